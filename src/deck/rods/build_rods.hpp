#pragma once

#include "deck/places/build_context.hpp"
#include "deck/rods/read_rod_nets.hpp"
#include "deck/sections/section_files.hpp"

namespace gxrod {

// Adds the rods and their nodes to the model. `points` are the points of rods that texts of the deck name;
// `nets` are the rods from meshes, `files` the rods with sections from files.
void build_rods(const std::vector<RodPoint>& points,
                const RodNets& nets,
                const SectionFiles& files,
                BuildContext& context);

}  // namespace gxrod
