#pragma once

#include <algorithm>
#include <cassert>
#include <type_traits>

#include "elements/rod/rod_geometry.hpp"
#include "model/model.hpp"

namespace gxrod {

// Calls visit with the number of nodes of an element of this order as a constant.
template <class Visitor>
void visit_node_count(int order, Visitor&& visit) {
    switch (order) {
        case 1:
            return visit(std::integral_constant<int, 2>());
        case 2:
            return visit(std::integral_constant<int, 3>());
        case 3:
            return visit(std::integral_constant<int, 4>());
        default:
            assert(order == 4);
            return visit(std::integral_constant<int, 5>());
    }
}

template <int Nodes>
RodElementGeometry<Nodes> find_geometry(const Model& model, const Rod& rod, int element) {
    RodElementGeometry<Nodes> geometry;
    for (int i = 0; i < Nodes; ++i) {
        const int entry = element * Nodes + i;
        geometry.nodes[i] = rod.element_nodes[entry];
        geometry.positions[i] = model.nodes[geometry.nodes[i]].position;
        geometry.triads[i] = rod.triads[entry];
    }
    if (!rod.rest_strains.empty()) {
        const auto first = rod.rest_strains.begin() + element * (Nodes - 1);
        std::copy(first, first + (Nodes - 1), geometry.strains.begin());
    }
    if (!rod.rest_positions.empty()) {
        geometry.rest.emplace();
        const std::ptrdiff_t first = std::ptrdiff_t{element} * Nodes;
        std::copy_n(rod.rest_positions.begin() + first, Nodes, geometry.rest->positions.begin());
        std::copy_n(rod.rest_triads.begin() + first, Nodes, geometry.rest->triads.begin());
    }
    return geometry;
}

}  // namespace gxrod
