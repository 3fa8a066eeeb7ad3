#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/blocks/step_thinning.hpp"
#include "report/model/drawn_cells.hpp"

namespace gxrod {

// How much there is to show.
struct ReportContent {
    const FrameTopology* topology = nullptr;
    std::vector<int> marked_nodes;  // supports, loads, bodies, places of a failure: kept whatever happens
    std::size_t frames = 0;
    std::size_t steps = 0;
    std::size_t columns = 0;  // of all histories and tables, one number a step each
    std::size_t arrows = 0;   // of loads
    std::size_t touches = 0;  // of rods, at most in a frame
    std::size_t moved_obstacles = 0;
    // Of shapes that stages have found, for each node: three numbers each.
    std::size_t shape_vectors = 0;
    bool is_static = false;  // no velocities
};

// What of it goes into a page.
struct ReportPlan {
    std::size_t frame_stride = 1;  // every so many frames, and the last
    StepThinning steps{0, 1};
    std::vector<DrawnCell> cells;
    std::vector<int> nodes;              // that are kept, in the order of the file
    std::vector<std::string> node_data;  // datasets of /VTKHDF/PointData
    std::vector<std::string> cell_data;  // datasets of /VTKHDF/CellData
    // What was left out, a sentence each; empty if nothing was.
    std::vector<std::string> left_out;

    // Numbers of the frames that are kept.
    std::vector<std::size_t> frames(std::size_t of) const;
};

// Bytes that all data of the plan take in the page, as base64.
std::size_t count_bytes(const ReportPlan& plan, const ReportContent& content);

// Thins until the data fit `bytes`: more steps a group; elements that hardly show, joined; frames, as long as
// some fifty are left; then quantities; then more frames, and at last whole elements. Throws
// std::length_error if not even that fits.
ReportPlan plan_report(const ReportContent& content, std::size_t bytes);

}  // namespace gxrod
