#pragma once

#include <cstdint>
#include <vector>

#include "model/model.hpp"

namespace gxrod {

// The fixed topology of the frames, in VTK's form: a cell for each element of the rods in their order, then a
// vertex for each body.
struct FrameMesh {
    std::vector<std::int64_t> connectivity;  // point numbers of the cells, one cell after the other
    std::vector<std::int64_t> offsets;       // start of each cell in connectivity, and the end
    std::vector<std::uint8_t> types;         // VTK cell types
    std::vector<double> cell_radius;         // for drawing; 0 for bodies
    std::vector<double> point_radius;        // radius of each node, from its first rod; 0 without a rod
    std::vector<Quat> triads;  // for each node: section axes at t = 0, or a body's axes without a rod

    std::size_t cell_count() const { return cell_radius.size(); }
};

FrameMesh make_frame_mesh(const Model& model);

// Computes the radius of the solid circle, of one material, with the section's ratio of bending to axial
// stiffness, 2 √(EI/EA) with the mean EI of both axes; 0 if that is not finite.
double equivalent_radius(const Section& section);

}  // namespace gxrod
