#pragma once

#include <tuple>

#include "elements/bushing_element.hpp"
#include "elements/carried_bushing_element.hpp"
#include "elements/spring_element.hpp"

// Lists the elements of ties, and makes them. Each has one node if an end of its tie is the ground, else two.
namespace gxrod {

using TieElements = std::tuple<SpringElement<1>,
                               SpringElement<2>,
                               BushingElement<1>,
                               BushingElement<2>,
                               CarriedBushingElement<1>,
                               CarriedBushingElement<2>>;

template <template <int> class TieElement, class Visit>
decltype(auto) visit_tie_element(const auto& tie, Visit&& visit) {
    return tie.has_ground() ? visit(TieElement<1>(tie)) : visit(TieElement<2>(tie));
}

// Calls visit(element) with the element of a tie, and returns its result.
template <class Visit>
decltype(auto) visit_element(const Spring& spring, Visit&& visit) {
    return visit_tie_element<SpringElement>(spring, visit);
}
template <class Visit>
decltype(auto) visit_element(const Bushing& bushing, Visit&& visit) {
    return bushing.has_axes_between() ? visit_tie_element<BushingElement>(bushing, visit)
                                      : visit_tie_element<CarriedBushingElement>(bushing, visit);
}

}  // namespace gxrod
