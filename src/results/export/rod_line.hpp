#pragma once

#include <string>
#include <vector>

#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// Places of the elements and nodes along a rod of a results file.
struct RodLine {
    struct Element {
        std::size_t cell = 0;             // row in CellData
        double middle = 0.0;              // arc length
        std::vector<std::size_t> points;  // rows in PointData: the two ends, then points between them
    };
    struct Node {
        std::size_t point = 0;
        std::size_t element = 0;  // index in the rod; the first one where two meet
        double arc_length = 0.0;
    };
    std::vector<Element> elements;
    std::vector<Node> nodes;  // from start to end, each once
};

// Returns the names of the rods, in the order of the deck; empty if an earlier version wrote the file without
// them. Throws Hdf5Error.
std::vector<std::string> read_rod_names(const Hdf5Reader& file);

// Reads a rod. Throws Hdf5Error, and std::runtime_error if the file's numbers do not fit together.
RodLine read_rod_line(const Hdf5Reader& file, std::size_t rod);

// Returns the weights of an element's 2 to 5 nodes, in the order of RodLine::Element, for values at its
// middle: Lagrange interpolation on Gauss-Lobatto points at ξ = 0.
const std::vector<double>& middle_weights(std::size_t nodes);

}  // namespace gxrod
