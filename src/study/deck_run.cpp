#include "study/deck_run.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "deck/schema/choices.hpp"
#include "machine/phase_timer.hpp"

namespace gxrod {

DeckRun::DeckRun(const std::string& name, const std::string& text, const std::vector<std::string>& overrides)
    : name_(name),
      problem_(read_problem_text(text, name + ".toml", overrides)),
      analysis_(make_analysis(problem_.model, problem_.analysis)) {
    analysis_->watch(list_rod_places(problem_.output.histories));
}

double DeckRun::end_time() const {
    const auto* dynamic = std::get_if<DynamicSettings>(&problem_.analysis);
    return dynamic == nullptr ? 1.0 : dynamic->end_time;
}

void DeckRun::check(const EquilibriumReport& report) {
    if (report.converged()) return;
    throw std::runtime_error(name_ + ": " + describe_failure(analysis_->explain(report)));
}

void DeckRun::run(const std::function<void()>& visit) {
    check(analysis_->start());
    visit();
    while (!analysis_->finished()) {
        {
            const PhaseTimer timer(seconds_);
            check(analysis_->advance());
        }
        ++steps_;
        newton_iterations_ += analysis_->solver_row().newton_iterations;
        visit();
    }
}

HistoryPoint::Row DeckRun::value(const std::string& history, const std::string& quantity) {
    const std::vector<HistoryRequest>& requests = problem_.output.histories;
    for (std::size_t i = 0; i < requests.size(); ++i) {
        if (requests[i].name != history) continue;
        for (const Choice<Quantity>& choice : quantity_choices) {
            if (choice.word != quantity) continue;
            return HistoryPoint(problem_.model, requests, i)
                .compute(choice.value, analysis_->snapshot(false));
        }
    }
    throw std::runtime_error(fmt::format("{}: no {} of a history {}", name_, quantity, history));
}

}  // namespace gxrod
