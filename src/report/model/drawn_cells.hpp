#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/model.hpp"
#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// A drawn piece of a rod: one element, or a straight piece in place of several.
struct DrawnCell {
    std::vector<int> nodes;  // nodes of the results file; the two ends, then nodes between them
    std::vector<Quat> axes;  // section axes at t = 0 at these nodes
    // Semi-axes of the ellipses that are drawn at these nodes, along section y and z.
    std::vector<std::array<double, 2>> radii;
    int source = 0;  // row in CellData of the element at its middle
    int rod = -1;    // in the order of the deck; −1, and no arc lengths, if the model is not known
    std::vector<double> arc_length;  // arc length of `nodes`, from the start of the rod
    double middle = 0.0;             // arc length of the middle of `source`
};

// The things that the frames of a results file show.
struct FrameTopology {
    int nodes = 0;
    int cells = 0;                     // elements and bodies in CellData
    std::vector<DrawnCell> rod_cells;  // in the order of the file
    std::vector<int> body_nodes;
};

// Reads a topology from the file alone: round rods, with the axes of the first frame's nodes. Throws
// Hdf5Error, or std::runtime_error if a cell is neither of a rod nor of a body.
FrameTopology read_topology(const Hdf5Reader& file);

// Sets true axes, the proportions of the sections and the places along rods from the model. Returns false,
// and does nothing, if it is not the model of these results.
bool refine_cells(const Model& model, FrameTopology& topology);

// Joins up to `run` consecutive elements between nodes of `kept` and corners into straight pieces.
std::vector<DrawnCell> join_cells(const std::vector<DrawnCell>& cells,
                                  std::size_t run,
                                  const std::vector<bool>& kept);

// Chooses at most `most` cells evenly.
std::vector<DrawnCell> sample_cells(const std::vector<DrawnCell>& cells, std::size_t most);

}  // namespace gxrod
