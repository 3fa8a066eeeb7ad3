#include "study/deck_run.hpp"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>

#include "check/shape_report.hpp"
#include "machine/phase_timer.hpp"
#include "model/settings/analysis_traits.hpp"

namespace gxrod {

DeckRun::DeckRun(const std::string& name, const std::string& text, const std::vector<std::string>& overrides)
    : name_(name),
      problem_(read_problem_text(text, name + ".toml", overrides)),
      stages_(std::make_unique<StageSequence>(
          StageSequence::Plan{problem_,
                              list_rod_places(problem_.output.histories),
                              list_contact_watches(problem_.output.histories)})),
      signals_(problem_) {}

double DeckRun::limit_load_factor() const {
    return limit_load_factor_of(stages_->settings()).value_or(std::numeric_limits<double>::quiet_NaN());
}

void DeckRun::check(const EquilibriumReport& report) {
    if (report.converged()) return;
    throw std::runtime_error(name_ + ": " + describe_failure(analysis().explain(report)));
}

void DeckRun::run(const std::function<void()>& visit) {
    check(analysis().start());
    measure_signals();
    visit();
    for (;;) {
        if (has_steps(stages_->settings()))
            run_steps(visit);
        else
            find_shapes();
        if (stages_->is_last()) return;
        if (const std::optional<Failure> failure = stages_->enter_next())
            throw std::runtime_error(name_ + ": " + describe_failure(*failure));
    }
}

void DeckRun::run_steps(const std::function<void()>& visit) {
    do {
        while (!analysis().finished()) {
            {
                const PhaseTimer timer(seconds_);
                if (is_timed(stages_->settings())) signals_.act(analysis(), stages_->axis_start());
                check(analysis().advance());
                measure_signals();
            }
            ++steps_;
            newton_iterations_ += analysis().solver_row().newton_iterations;
            visit();
        }
    } while (stages_->enter_next_branch(""));
    if (is_path(stages_->settings())) paths_.push_back(stages_->paths());
}

void DeckRun::measure_signals() {
    if (!signals_.empty()) signals_.measure(analysis().snapshot(false));
}

void DeckRun::find_shapes() {
    const PhaseTimer timer(seconds_);
    shapes_.push_back(stages_->find_shapes());
    const std::string failure = find_failure(shapes_.back().record);
    if (!failure.empty()) throw std::runtime_error(name_ + ": " + failure);
}

HistoryRow DeckRun::value(const std::string& history, const std::string& quantity) {
    const std::vector<HistoryRequest>& requests = problem_.output.histories;
    for (std::size_t i = 0; i < requests.size(); ++i) {
        if (requests[i].name != history) continue;
        const Quantity* found = find_quantity(requests[i].target, quantity);
        if (found == nullptr) break;
        return HistoryWatch(problem_.model, requests, i).compute(*found, analysis().snapshot(false));
    }
    throw std::runtime_error(fmt::format("{}: no {} of a history {}", name_, quantity, history));
}

}  // namespace gxrod
