#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "cross_section/section_mesh.hpp"
#include "mesh/sections/surface_file.hpp"

namespace gxrod {

// Makes cells of a section from elements of a file, whose nodes are in Gmsh's order. Elements with straight
// sides (order 1) are raised to order 3; neighbours share the nodes on their common side. A quadrangle of 8
// nodes gets its middle. Elements that are walked clockwise are turned over.
class SurfaceCells {
  public:
    // The nodes of the mesh are those of the file first.
    explicit SurfaceCells(SectionMesh& mesh) : mesh_(mesh) {}

    SectionCell make(const SurfaceElement& element, int layer);

  private:
    SectionCell raise(const SectionCell& straight);
    // Returns the two nodes on a straight side, from one end to the other.
    std::array<int, 2> nodes_on_side(int from, int to);
    int add_node(const PlanePoint& at);
    const PlanePoint& at(int node) const { return mesh_.nodes[static_cast<std::size_t>(node)]; }
    bool is_clockwise(const SectionCell& cell) const;

    SectionMesh& mesh_;
    std::map<std::pair<int, int>, std::array<int, 2>> sides_;
};

}  // namespace gxrod
