#pragma once

#include <string>

#include "cross_section/examination/cell_sides.hpp"

namespace gxrod {

// Returns a node's place.
inline const PlanePoint& node_of(const SectionMesh& mesh, int node) {
    return mesh.nodes[static_cast<std::size_t>(node)];
}

// Returns the mean place of a cell's nodes.
PlanePoint middle_of(const SectionMesh& mesh, const SectionCell& cell);

// Prints a place: "(0.1, 0.02)".
std::string place_text(const PlanePoint& at);

// Finds parts of a mesh that share no node, and how many of their nodes coincide within a distance.
std::string find_part_fault(const SectionMesh& mesh, double within);

// Finds parts that share nodes but no side, so that one turns about the other.
std::string find_pivot_fault(const SectionMesh& mesh, const MeshSides& sides);

}  // namespace gxrod
