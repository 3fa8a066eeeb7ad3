#pragma once

#include <cstdint>
#include <vector>

#include "model/model.hpp"

namespace gxrod {

// Places of the frames' cells or points along the rods. Bodies, and points on no rod, have rod and element −1
// and arc length 0.
struct RodPlaces {
    std::vector<std::int64_t> rod;      // number in Model::rods
    std::vector<std::int64_t> element;  // number in its rod
    std::vector<double> arc_length;     // from the start of the rod
};

// Finds the places of the cells of FrameMesh: elements at their middles.
RodPlaces find_cell_places(const Model& model);

// Finds the places of the nodes: on the first rod there, and on its first element.
RodPlaces find_point_places(const Model& model);

// Lists the arc length of each entry of FrameMesh::connectivity, on the rod of its cell; 0 for bodies.
std::vector<double> list_arc_lengths(const Model& model);

}  // namespace gxrod
