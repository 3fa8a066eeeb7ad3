#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "deck/loads/station_loads.hpp"
#include "deck/places/build_context.hpp"
#include "deck/text/table_files.hpp"

namespace gxrod {

// Loads at stations that files have, by the path of their table, "load[2]".
using LoadFiles = std::map<std::string, std::shared_ptr<const StationLoads>>;

// Reads the files of loads. If a file is wrong, adds a fault. Adds the files' bytes to `records`.
LoadFiles read_load_files(const CheckedTable& deck,
                          const TableFiles& files,
                          FaultList& faults,
                          std::vector<MeshRecord>& records);

// Adds gravity and the loads, at points and along rods, to the model. After build_bodies.
void build_loads(const LoadFiles& files, BuildContext& context);

// A force at a point of a rod or a body, global.
struct SteadyLoad {
    std::string point;
    Vec3 force;
};

// Lists the forces of the first stage at points that do not depend on the motion and are fixed in space: at
// full load, or at t = 0 if it has time.
std::vector<SteadyLoad> list_steady_loads(const BuildContext& context);

// Sets the frame that turns, if the deck has one.
void build_rotation(BuildContext& context);

}  // namespace gxrod
