#pragma once

#include <string>

#include "cross_section/section_mesh.hpp"

namespace gxrod {

// Returns what is wrong with a mesh, such as one from a file, or nothing: cells that are inside out or have
// no area, parts that do not hang together, sides with a foreign node in them, cells that overlap. Without a
// fault a section can be computed.
std::string find_mesh_fault(const SectionMesh& mesh);

}  // namespace gxrod
