#pragma once

#include "model/model.hpp"

namespace gxrod {

// Returns what water, air and the ground need of the section at an entry of Rod::element_nodes; nullptr if
// they pass it by.
const SectionInFluid* fluid_section_at(const Model& model, const Rod& rod, std::size_t entry);

// Returns whether the water presses on any rod.
bool has_rods_in_water(const Model& model);

// Returns whether any rod can touch the ground.
bool has_rods_on_ground(const Model& model);

}  // namespace gxrod
