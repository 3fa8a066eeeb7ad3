#include "report/report_plan.hpp"

#include <algorithm>
#include <stdexcept>

#include "report/base64.hpp"
#include "report/left_out.hpp"

namespace gxrod {

namespace {

constexpr std::size_t most_cells = 30000;     // more do not turn smoothly
constexpr std::size_t enough_cells = 1500;    // fewer show what was left out
constexpr std::size_t enough_frames = 50;     // fewer are no film
constexpr double least_share_of_steps = 0.3;  // of the bytes, if there are so many steps
constexpr std::size_t block_bytes = 3;        // of padding, at most, a block of data
constexpr std::size_t vector_bytes = 3 * sizeof(float);

// All, or which of them are left where there is no room for all.
ListedQuantities quantities_at(int level, bool is_static) {
    ListedQuantities quantities{{"displacement", "rotation_vector"}, {}};
    if (level == 0 && !is_static) {
        quantities.node_data.insert(quantities.node_data.end(), {"velocity", "angular_velocity"});
    }
    if (level <= 1) quantities.cell_data = {"force", "moment"};
    if (level == 0) quantities.cell_data.insert(quantities.cell_data.end(), {"strain", "curvature"});
    return quantities;
}

// The smallest stride that keeps at most `most` frames, two at least.
std::size_t stride_for(std::size_t frames, std::size_t most) {
    if (frames <= most) return 1;
    return (frames - 2) / (most - 1) + 1;
}

std::vector<int> nodes_of(const std::vector<DrawnCell>& cells, const std::vector<bool>& marked) {
    std::vector<bool> kept = marked;
    for (const DrawnCell& cell : cells) {
        for (const int node : cell.nodes) kept[node] = true;
    }
    std::vector<int> nodes;
    for (std::size_t node = 0; node < kept.size(); ++node) {
        if (kept[node]) nodes.push_back(static_cast<int>(node));
    }
    return nodes;
}

std::size_t still_bytes(const ReportPlan& plan, const ReportContent& content) {
    std::size_t entries = 0;
    for (const DrawnCell& cell : plan.cells) entries += cell.nodes.size();
    return (1 + content.shape_vectors) * base64_length(plan.nodes.size() * vector_bytes) +
           base64_length(entries * sizeof(std::int32_t)) +
           base64_length((plan.cells.size() + 1) * sizeof(std::int32_t)) +
           base64_length(entries * 4 * sizeof(float)) + base64_length(entries * 2 * sizeof(float)) +
           (content.has_sections ? 2 : 1) * base64_length(plan.cells.size() * sizeof(std::int32_t)) +
           base64_length(plan.cells.size() * sizeof(float)) + base64_length(entries * sizeof(float));
}

double frame_bytes(const ReportPlan& plan, const ReportContent& content) {
    const std::size_t bytes =
        vector_bytes * (plan.node_data.size() * plan.nodes.size() +
                        plan.cell_data.size() * plan.cells.size() + 2 * content.arrows) +
        sizeof(float) * plan.cell_scalars.size() * plan.cells.size() +
        7 * sizeof(float) * (content.touches + content.moved_obstacles) +
        (content.touches > 0 ? sizeof(std::int32_t) : 0) + sizeof(double);
    return static_cast<double>(bytes) * 4.0 / 3.0;
}

std::size_t step_bytes(const ReportPlan& plan, const ReportContent& content) {
    const std::size_t count = plan.steps.count();
    return base64_length(count * sizeof(double)) + base64_length(count * content.columns * sizeof(float));
}

class Planner {
  public:
    Planner(const ReportContent& content, std::size_t bytes)
        : content_(content), bytes_(static_cast<double>(bytes)), marked_(content.topology->nodes, false) {
        for (const int node : content.marked_nodes) marked_[node] = true;
    }

    ReportPlan plan() {
        choose_steps();
        choose_cells_and_frames();
        plan_.left_out = list_left_out(plan_, quantities_at(0, content_.is_static), content_, is_sampled_);
        return plan_;
    }

  private:
    const std::vector<DrawnCell>& all_cells() const { return content_.topology->rod_cells; }

    void set(const std::vector<DrawnCell>& cells, int level) {
        plan_.cells = cells;
        plan_.nodes = nodes_of(cells, marked_);
        const ListedQuantities quantities = quantities_at(level, content_.is_static);
        plan_.node_data = quantities.node_data;
        plan_.cell_data = cells.empty() ? std::vector<std::string>{} : quantities.cell_data;
        plan_.cell_scalars = plan_.cell_data.empty() ? std::vector<std::string>{} : content_.cell_scalars;
    }

    void choose_steps() {
        set(sample_cells(all_cells(), most_cells), 0);
        const double frames = static_cast<double>(content_.frames) * frame_bytes(plan_, content_) +
                              static_cast<double>(still_bytes(plan_, content_));
        const double room = std::max(least_share_of_steps * bytes_, bytes_ - frames);
        const double step =
            4.0 / 3.0 * static_cast<double>(sizeof(double) + content_.columns * sizeof(float));
        const auto count = static_cast<std::size_t>(std::max(0.0, room / step));
        plan_.steps = StepThinning(content_.steps, StepThinning::group_for(content_.steps, count));
    }

    // Frames for which there is room next to the steps and what does not move.
    std::size_t frames_that_fit() const {
        const double blocks =
            19.0 + static_cast<double>(content_.cell_scalars.size() + (content_.has_sections ? 1 : 0));
        const double room = bytes_ - static_cast<double>(step_bytes(plan_, content_)) -
                            static_cast<double>(still_bytes(plan_, content_)) - blocks * block_bytes;
        return room < 0.0 ? 0 : static_cast<std::size_t>(room / frame_bytes(plan_, content_));
    }

    // Whether the cells and quantities leave room for so many frames, which are then set.
    bool fits(const std::vector<DrawnCell>& cells, int level, std::size_t least_frames) {
        set(cells, level);
        const std::size_t room = frames_that_fit();
        if (room < std::min(content_.frames, least_frames)) return false;
        plan_.frame_stride = stride_for(content_.frames, room);
        return true;
    }

    void choose_cells_and_frames() {
        std::vector<DrawnCell> cells = all_cells();
        for (std::size_t run = 2; cells.size() > most_cells && run <= 64; run *= 2) {
            cells = join_cells(all_cells(), run, marked_);
        }
        is_sampled_ = cells.size() > most_cells;
        cells = sample_cells(cells, most_cells);
        if (fits(cells, 0, enough_frames)) return;
        for (std::size_t run = 2; run <= 64 && !is_sampled_; run *= 2) {
            const std::vector<DrawnCell> joined = join_cells(all_cells(), run, marked_);
            if (joined.size() < enough_cells) break;
            if (joined.size() < cells.size()) cells = joined;
            if (fits(cells, 0, enough_frames)) return;
        }
        if (fits(cells, 1, enough_frames) || fits(cells, 2, enough_frames) || fits(cells, 2, 2)) return;
        is_sampled_ = true;
        while (cells.size() > 1) {
            cells = sample_cells(cells, cells.size() / 2);
            if (fits(cells, 2, 2)) return;
        }
        throw std::length_error("not even two frames fit");
    }

    const ReportContent& content_;
    double bytes_;
    std::vector<bool> marked_;
    bool is_sampled_ = false;
    ReportPlan plan_;
};

}  // namespace

std::vector<std::size_t> ReportPlan::frames(std::size_t of) const {
    std::vector<std::size_t> kept;
    for (std::size_t frame = 0; frame + 1 < of; frame += frame_stride) kept.push_back(frame);
    if (of > 0) kept.push_back(of - 1);
    return kept;
}

std::size_t count_bytes(const ReportPlan& plan, const ReportContent& content) {
    const std::size_t frames = plan.frames(content.frames).size();
    std::size_t bytes = still_bytes(plan, content) + step_bytes(plan, content) +
                        base64_length(frames * sizeof(double)) +
                        base64_length(frames * 2 * content.arrows * vector_bytes);
    if (content.touches > 0)
        bytes += base64_length(frames * 7 * sizeof(float) * content.touches) +
                 base64_length((frames + 1) * sizeof(std::int32_t));
    bytes += base64_length(frames * 7 * sizeof(float) * content.moved_obstacles);
    bytes += plan.node_data.size() * base64_length(frames * plan.nodes.size() * vector_bytes);
    bytes += plan.cell_data.size() * base64_length(frames * plan.cells.size() * vector_bytes);
    bytes += plan.cell_scalars.size() * base64_length(frames * plan.cells.size() * sizeof(float));
    return bytes;
}

ReportPlan plan_report(const ReportContent& content, std::size_t bytes) {
    return Planner(content, bytes).plan();
}

}  // namespace gxrod
