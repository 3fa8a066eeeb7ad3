#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "model/obstacle_shape.hpp"

namespace gxrod {

// Open edges of a mesh that hang together.
struct MeshHole {
    Vec3 middle = Vec3::Zero();  // of its edges, by their lengths
    double length = 0.0;         // of all of them
    std::size_t edges = 0;
};

// Describes a mesh of triangles, and what may be wrong with it.
struct TriangleExamination {
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();
    double area = 0.0;
    std::optional<double> volume{};  // that it encloses, if it is closed
    double least_side = 0.0, greatest_side = 0.0;
    double greatest_turn = 0.0;   // of the surface at an edge, 0 if it is flat; open edges do not count
    std::size_t sharp_edges = 0;  // that turn by more than the mesh's feature angle
    std::size_t parts = 0;        // that share no edge
    std::vector<MeshHole> holes;  // the longest first
    std::vector<std::array<int, 2>> open_edges;  // their corners
    std::size_t crowded_edges = 0;               // with more than two triangles
    std::vector<int>
        flipped;  // numbers of triangles in the file, the other way around than most of their part

    bool is_closed() const { return open_edges.empty() && crowded_edges == 0; }
};
TriangleExamination examine_triangles(const TriangleMesh& mesh);

}  // namespace gxrod
