#pragma once

#include "deck/places/build_context.hpp"
#include "deck/surroundings/surroundings_files.hpp"
#include "deck/table/name_kinds.hpp"
#include "deck/table/table.hpp"

namespace gxrod {

const TableSpec& vessel_table();

struct VesselTable : TableHead {
    std::string rao;
    Vec3 at = Vec3::Zero();
    double heading = 0.0;
    Vec3 offset = Vec3::Zero();
    ChosenWord phases;
    std::optional<ChosenWord> rotations;
};

// Gives the supports that follow vessels their motion in the current stage. Call it after build_supports and
// build_surroundings.
void move_with_vessels(const SurroundingsFiles& files, BuildContext& context);

}  // namespace gxrod
