#include "run/swept_equilibria.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "analyses/static.hpp"
#include "model/path_dependence.hpp"
#include "model/settings/analysis_traits.hpp"

namespace gxrod {
namespace {

// Within which Newton's method takes the step from one value to the next; an equilibrium further away is
// found through all stages.
constexpr int few_iterations = 10;

// Unless the deck says otherwise: where two frequencies merge, errors of the equilibrium count many times.
constexpr double sharp_tolerance = 1e-11;

AnalysisSettings sharpen(AnalysisSettings analysis) {
    std::visit(
        [](auto& settings) {
            if constexpr (requires { settings.newton; })
                settings.newton.tolerance = settings.newton.tolerance.value_or(sharp_tolerance);
        },
        analysis);
    return analysis;
}

bool have_same_shape(const Model& a, const Model& b) {
    const auto same_node = [](const Node& one, const Node& other) { return one.position == other.position; };
    return std::ranges::equal(a.nodes, b.nodes, same_node);
}

}  // namespace

std::size_t SweptEquilibria::find_last(const Problem& deck) const {
    std::size_t last = 0;
    for (std::size_t i = 0; i < index_; ++i) {
        if (has_steps(deck.stages[i].analysis)) last = i;
    }
    return last;
}

SweptEquilibria::Equilibrium SweptEquilibria::prepare(const Problem& deck, std::size_t stage) const {
    Equilibrium prepared;
    prepared.model = std::make_unique<Model>(deck.model);
    if (stage > 0) set_actions(deck.stages[stage].actions, *prepared.model);
    prepared.analysis = make_analysis(*prepared.model, sharpen(deck.stages[stage].analysis), threads_);
    return prepared;
}

bool SweptEquilibria::settle(const Problem& deck, Equilibrium& found) const {
    if (!last_.analysis || !have_same_shape(*last_.model, deck.model)) return false;
    // From the last equilibrium it would inherit what sections and friction remember of that.
    if (depends_on_path(deck.model)) return false;
    const std::size_t stage = find_last(deck);
    if (!has_steps(deck.stages[stage].analysis)) return false;
    found = prepare(deck, stage);
    const EquilibriumReport report =
        found.analysis->settle_after(*last_.analysis, end_of(deck.stages[stage].analysis));
    return report.converged() && report.iterations <= few_iterations;
}

std::string SweptEquilibria::run_stages(const Problem& deck, Equilibrium& found) const {
    found = {};
    const std::size_t last = find_last(deck);
    for (std::size_t i = 0; i <= last; ++i) {
        if (i > 0 && !has_steps(deck.stages[i].analysis)) continue;
        Equilibrium next = prepare(deck, i);
        EquilibriumReport report =
            found.analysis ? next.analysis->start_after(*found.analysis) : next.analysis->start();
        while (report.converged() && has_steps(deck.stages[i].analysis) && !next.analysis->finished())
            report = next.analysis->advance();
        found = std::move(next);
        if (!report.converged()) return describe_failure(found.analysis->explain(report));
    }
    return "";
}

SweepState SweptEquilibria::find(double value) {
    const Problem deck = plan_.vary(value);
    Equilibrium found;
    if (!settle(deck, found)) {
        const std::string failure = run_stages(deck, found);
        if (!failure.empty()) return {.failure = failure};
    }
    if (unknowns_ == 0) unknowns_ = found.analysis->system().equations().count();
    if (found.analysis->system().equations().count() != unknowns_)
        return {.failure = "the model has another number of unknowns than at the first value"};
    last_ = std::move(found);
    const SteppedAnalysis& analysis = *last_.analysis;
    const FrameColumns* frame = analysis.frame();
    const double time = analysis.state().time;
    return {.failure = "",
            .system = &analysis.system(),
            .state = &analysis.state(),
            .time = time,
            .frame = frame,
            .speed = frame != nullptr ? frame->frame().speed(time) : 0.0};
}

}  // namespace gxrod
