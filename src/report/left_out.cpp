#include "report/left_out.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gxrod {

namespace {

std::string describe_cells(std::size_t all, std::size_t drawn, bool is_sampled) {
    if (is_sampled) {
        return fmt::format(
            "Of {} elements, {} pieces, evenly chosen, are drawn; gaps between them are not in the model.",
            all,
            drawn);
    }
    return fmt::format(
        "{} elements are drawn as {} straight pieces, with the section quantities of the element at the "
        "middle of each.",
        all,
        drawn);
}

void add_missing(const std::vector<std::string>& all,
                 const std::vector<std::string>& kept,
                 std::vector<std::string>& missing) {
    for (const std::string& name : all) {
        if (std::find(kept.begin(), kept.end(), name) == kept.end()) missing.push_back(name);
    }
}

}  // namespace

std::vector<std::string> list_left_out(const ReportPlan& plan,
                                       const ListedQuantities& all,
                                       const ReportContent& content,
                                       bool is_sampled) {
    std::vector<std::string> sentences;
    if (plan.frame_stride > 1) {
        sentences.push_back(fmt::format("Of {} frames, one in {} is kept, and the last: {} in all.",
                                        content.frames,
                                        plan.frame_stride,
                                        plan.frames(content.frames).size()));
    }
    if (!plan.steps.keeps_all()) {
        sentences.push_back(fmt::format(
            "Of each {} of {} steps, charts have the least and the largest value, in their order; the first "
            "and the last step are kept as they are.",
            plan.steps.group(),
            content.steps));
    }
    const std::size_t elements = content.topology->rod_cells.size();
    if (plan.cells.size() < elements) {
        sentences.push_back(describe_cells(elements, plan.cells.size(), is_sampled));
    }
    std::vector<std::string> missing;
    add_missing(all.node_data, plan.node_data, missing);
    if (!plan.cells.empty()) {
        add_missing(all.cell_data, plan.cell_data, missing);
        add_missing(content.cell_scalars, plan.cell_scalars, missing);
    }
    if (!missing.empty())
        sentences.push_back(fmt::format("Left out altogether: {}.", fmt::join(missing, ", ")));
    return sentences;
}

}  // namespace gxrod
