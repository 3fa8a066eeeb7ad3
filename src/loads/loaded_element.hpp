#pragma once

#include <array>
#include <vector>

#include "model/model.hpp"

namespace gxrod {

inline constexpr std::size_t most_element_nodes = 5;

// Shape functions of an element's nodes, and their slopes, at ξ from −1 to 1.
struct ShapeValues {
    std::array<double, most_element_nodes> value;
    std::array<double, most_element_nodes> slope;
};
using ShapeFunctions = ShapeValues (*)(double xi);

// A distributed load on one element of its rod.
struct LoadedElement {
    const DistributedLoad* load = nullptr;
    std::vector<int> nodes;           // indices in the model
    std::vector<Quat> triads;         // section axes at t = 0
    std::vector<double> arc_lengths;  // from the start of the rod
    std::vector<Vec3> positions;      // stress-free positions
    ShapeFunctions shapes = nullptr;
};

}  // namespace gxrod
