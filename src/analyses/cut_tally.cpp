#include "analyses/cut_tally.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "solvers/worst_nodes.hpp"

namespace gxrod {
namespace {

const char* name_of(Outcome outcome) {
    switch (outcome) {
        case Outcome::converged:
        case Outcome::out_of_iterations:
            break;
        case Outcome::singular:
            return "the system of equations was singular";
        case Outcome::not_finite:
            return "a force or increment was not a finite number";
        case Outcome::rotation_too_large:
            return "a node turned by half a turn or more within a step";
        case Outcome::element_too_turned:
            return "one element's nodes turned against each other by half a turn";
        case Outcome::error_too_large:
            return "the estimated error of a step was above the tolerance";
        case Outcome::energy_out_of_reach:
            return "the energy of a step was off by more than vibrations could take up";
        case Outcome::joints_open:
            return "velocities could not be made to fit the joints";
        case Outcome::control_turned:
            return "the displacement that controls the path was about to turn back";
        case Outcome::path_crawls:
            return "the path crawled";
        case Outcome::lost_stability:
            return "the equilibrium was less stable than the one before";
    }
    return "Newton's method did not converge";
}

}  // namespace

void CutTally::add(const EquilibriumReport& report, long step) {
    ++cuts_;
    if (step != last_step_) ++cut_steps_;
    last_step_ = step;
    Reason& reason = reasons_[report.outcome];
    ++reason.cuts;
    if (report.worst_node >= 0) ++reason.places[{report.worst_node, report.worst_component}];
}

StepCuts CutTally::count(long steps) const {
    const auto by_error = reasons_.find(Outcome::error_too_large);
    // The one that a run failed in, too.
    return {std::max<std::int64_t>(steps, cut_steps_),
            cut_steps_,
            cuts_,
            by_error == reasons_.end() ? 0 : by_error->second.cuts};
}

std::string CutTally::describe_reasons(const Model& model) const {
    std::vector<std::pair<Outcome, const Reason*>> sorted;
    for (const auto& [outcome, reason] : reasons_) sorted.emplace_back(outcome, &reason);
    std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
        return a.second->cuts > b.second->cuts;
    });
    std::vector<std::string> words;
    for (const auto& [outcome, reason] : sorted) {
        std::string where;
        if (!reason->places.empty()) {
            const auto most = std::max_element(
                reason->places.begin(), reason->places.end(), [](const auto& a, const auto& b) {
                    return a.second < b.second;
                });
            where = ", mostly at " + name_place(model, most->first.node, most->first.component);
        }
        words.push_back(fmt::format(
            "{} ({} time{}{})", name_of(outcome), reason->cuts, reason->cuts == 1 ? "" : "s", where));
    }
    return fmt::format("{}", fmt::join(words, "; "));
}

}  // namespace gxrod
