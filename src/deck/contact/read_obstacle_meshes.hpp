#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "deck/reading/checked_deck.hpp"
#include "deck/text/fault_list.hpp"
#include "mesh/mesh_files.hpp"
#include "model/contact.hpp"

namespace gxrod {

// Reads the meshes of obstacles, by their names. Keeps the files in the records and adds notes on their
// content.
std::map<std::string, std::shared_ptr<const TriangleMesh>> read_obstacle_meshes(
    const CheckedTable& deck,
    const MeshFiles& files,
    FaultList& faults,
    std::vector<MeshRecord>& records,
    std::vector<std::string>& notes);

}  // namespace gxrod
