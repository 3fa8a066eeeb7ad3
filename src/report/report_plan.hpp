#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/blocks/step_thinning.hpp"
#include "report/model/drawn_cells.hpp"

namespace gxrod {

// Amounts of data that a page could show.
struct ReportContent {
    const FrameTopology* topology = nullptr;
    std::vector<int> marked_nodes;  // supports, loads, bodies, places of a failure: always kept
    std::size_t frames = 0;
    std::size_t steps = 0;
    std::size_t columns = 0;  // columns of all histories and tables, one number a step each
    std::size_t arrows = 0;   // arrows of loads
    std::size_t touches = 0;  // contacts of rods, most of them in a frame
    std::size_t moved_obstacles = 0;
    // Stresses of elements, a number each: datasets of /VTKHDF/CellData that the file has.
    std::vector<std::string> cell_scalars;
    bool has_sections = false;  // numbers of the sections of elements
    // Vectors of three numbers, for each node, of the shapes that stages have found.
    std::size_t shape_vectors = 0;
    bool is_static = false;  // no velocities
};

// The part of the data that goes into a page.
struct ReportPlan {
    std::size_t frame_stride = 1;  // every so many frames, and the last one
    StepThinning steps{0, 1};
    std::vector<DrawnCell> cells;
    std::vector<int> nodes;                 // nodes that are kept, in the order of the file
    std::vector<std::string> node_data;     // datasets of /VTKHDF/PointData
    std::vector<std::string> cell_data;     // vectors among the datasets of /VTKHDF/CellData
    std::vector<std::string> cell_scalars;  // numbers among them
    // Sentences on what was left out.
    std::vector<std::string> left_out;

    // Lists the numbers of the frames that are kept.
    std::vector<std::size_t> frames(std::size_t of) const;
};

// Counts the bytes of all data of the plan in the page, as base64.
std::size_t count_bytes(const ReportPlan& plan, const ReportContent& content);

// Thins until the data fit `bytes`: more steps per group; joins elements that hardly show; drops frames, down
// to some fifty; then quantities; then more frames, and at last whole elements. Throws std::length_error if
// not even that fits.
ReportPlan plan_report(const ReportContent& content, std::size_t bytes);

}  // namespace gxrod
