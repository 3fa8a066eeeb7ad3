#include "model/sections/section_at.hpp"

#include <cmath>

namespace gxrod {

const Section& section_at(const Model& model, const RodPlace& place) {
    const Rod& rod = model.rods[static_cast<std::size_t>(place.rod)];
    if (!rod.has_varying_sections()) return model.sections[static_cast<std::size_t>(rod.section)];
    const int first = place.element * (rod.order + 1);
    const auto nearest = static_cast<int>(std::lround(0.5 * (1.0 + place.xi) * rod.order));
    return rod.varying.at_nodes[static_cast<std::size_t>(first + nearest)];
}

std::shared_ptr<const CrossSection> find_shape(const Model& model, const RodPlace& place) {
    const Section& section = section_at(model, place);
    return section.law ? nullptr : section.shape;
}

}  // namespace gxrod
