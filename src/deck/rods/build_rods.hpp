#pragma once

#include "deck/places/build_context.hpp"
#include "deck/rods/read_rod_nets.hpp"
#include "deck/sections/section_files.hpp"

namespace gxrod {

// Adds the rods and their nodes to the model. `points` are those of the deck's texts that name a point of a
// rod; `nets` are the rods from meshes, `files` those with sections from files.
void build_rods(const std::vector<RodPoint>& points,
                const RodNets& nets,
                const SectionFiles& files,
                BuildContext& context);

}  // namespace gxrod
