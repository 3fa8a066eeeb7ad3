#include "study/studied_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "deck/schema/suggestion.hpp"
#include "model/settings/analysis_traits.hpp"

namespace gxrod {

namespace {

std::vector<std::string> list_names(const Problem& problem, bool only_studied) {
    std::vector<std::string> names;
    for (const StagePlan& stage : problem.stages) {
        if (!only_studied || can_be_studied(stage.analysis)) names.push_back(stage.name);
    }
    return names;
}

std::size_t find_last(const Problem& problem) {
    for (std::size_t i = problem.stages.size(); i > 0; --i) {
        if (can_be_studied(problem.stages[i - 1].analysis)) return i - 1;
    }
    return problem.stages.size() - 1;
}

std::size_t find_named(const Problem& problem, const std::string& name) {
    if (problem.record.stages.empty())
        throw std::invalid_argument("has [analysis] and no stages: leave out --stage");
    const auto found = std::ranges::find(problem.stages, name, &StagePlan::name);
    if (found == problem.stages.end()) {
        const std::vector<std::string> names = list_names(problem, false);
        throw std::invalid_argument(fmt::format(
            "there is no stage \"{}\"{}; there are {}", name, did_you_mean(name, names), plain_list(names)));
    }
    return static_cast<std::size_t>(found - problem.stages.begin());
}

}  // namespace

bool can_be_studied(const AnalysisSettings& analysis) { return has_steps(analysis) && !is_path(analysis); }

std::size_t find_studied_stage(const Problem& problem, const std::string& name) {
    const std::size_t index = name.empty() ? find_last(problem) : find_named(problem, name);
    const StagePlan& stage = problem.stages[index];
    if (can_be_studied(stage.analysis)) return index;
    const std::vector<std::string> others = list_names(problem, true);
    const std::string remedy =
        others.empty()
            ? "Compare runs with more elements instead"
            : fmt::format("Take --stage {}, or compare runs with more elements", fmt::join(others, " or "));
    throw std::invalid_argument(
        fmt::format("{}finds {}; gxrod verify refines what moves. {}",
                    stage.name.empty() ? "" : "stage " + stage.name + " ",
                    is_path(stage.analysis) ? "a path of equilibria" : kind_of(stage.analysis),
                    remedy));
}

void end_with_stage(std::size_t stage, Problem& problem) {
    problem.stages.erase(problem.stages.begin() + static_cast<std::ptrdiff_t>(stage) + 1,
                         problem.stages.end());
}

}  // namespace gxrod
