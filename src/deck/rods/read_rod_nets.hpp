#pragma once

#include <map>
#include <string>

#include "deck/places/point.hpp"
#include "deck/reading/checked_deck.hpp"
#include "deck/text/fault_list.hpp"
#include "mesh/mesh_files.hpp"
#include "mesh/rod_net.hpp"
#include "model/deck_record.hpp"

namespace gxrod {

// A rod from a mesh, and the points that the mesh names.
struct NamedNet {
    RodNet net;
    NetPoints points;
};

using RodNets = std::map<int, NamedNet>;  // by index in Model::rods

// Reads the meshes of a deck, each once, through `files`. If a mesh is wrong, adds a fault and no entry for
// the rod. Adds the files' bytes to `records`.
RodNets read_rod_nets(const CheckedTable& deck,
                      const MeshFiles& files,
                      FaultList& faults,
                      std::vector<MeshRecord>& records);

// Returns the points by rod, for PointNames.
std::map<int, NetPoints> points_of(const RodNets& nets);

}  // namespace gxrod
