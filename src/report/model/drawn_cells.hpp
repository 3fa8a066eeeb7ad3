#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/model.hpp"
#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// A piece of a rod as it is drawn: one element, or a straight piece in place of several.
struct DrawnCell {
    std::vector<int> nodes;  // of the results file; the two ends, then those between them
    std::vector<Quat> axes;  // section axes at t = 0 at those nodes
    // Semi-axes of the ellipses that are drawn at those nodes, along section y and z.
    std::vector<std::array<double, 2>> radii;
    int source = 0;  // row in CellData of the element at its middle
    int rod = -1;    // in the order of the deck; −1, and no arc lengths, where the model is not known
    std::vector<double> arc_length;  // of `nodes`, from the start of the rod
    double middle = 0.0;             // arc length of the middle of `source`
};

// What a results file's frames show.
struct FrameTopology {
    int nodes = 0;
    int cells = 0;                     // rods' elements and bodies, as CellData counts them
    std::vector<DrawnCell> rod_cells;  // in the order of the file
    std::vector<int> body_nodes;
};

// From the file alone: round rods, with the axes of the first frame's nodes. Throws Hdf5Error, or
// std::runtime_error if the cells are not those of rods and bodies.
FrameTopology read_topology(const Hdf5Reader& file);

// Sets true axes, the proportions of the sections and the places along rods from the model; false, and
// nothing done, if it is not the model of these results.
bool refine_cells(const Model& model, FrameTopology& topology);

// Joins up to `run` elements that follow each other between nodes of `kept` and corners into straight pieces.
std::vector<DrawnCell> join_cells(const std::vector<DrawnCell>& cells,
                                  std::size_t run,
                                  const std::vector<bool>& kept);

// Evenly chosen cells, at most so many.
std::vector<DrawnCell> sample_cells(const std::vector<DrawnCell>& cells, std::size_t most);

}  // namespace gxrod
