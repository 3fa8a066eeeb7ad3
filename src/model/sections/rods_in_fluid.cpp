#include "model/sections/rods_in_fluid.hpp"

#include <algorithm>

namespace gxrod {
namespace {

bool has_fluid_section(const Model& model) {
    return std::ranges::any_of(model.rods,
                               [&](const Rod& rod) { return fluid_section_at(model, rod, 0) != nullptr; });
}

}  // namespace

const SectionInFluid* fluid_section_at(const Model& model, const Rod& rod, std::size_t entry) {
    const Section& section = rod.has_varying_sections()
                                 ? rod.varying.at_nodes[entry]
                                 : model.sections[static_cast<std::size_t>(rod.section)];
    return section.fluid ? &*section.fluid : nullptr;
}

bool has_rods_in_water(const Model& model) {
    return model.surroundings.water.has_value() && has_fluid_section(model);
}

bool has_rods_on_ground(const Model& model) {
    return model.surroundings.seabed.has_value() && has_fluid_section(model);
}

}  // namespace gxrod
