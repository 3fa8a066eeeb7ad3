#include "run/stage_sequence.hpp"

#include "analyses/buckling.hpp"
#include "analyses/modes.hpp"
#include "model/analysis_traits.hpp"

namespace gxrod {

StageSequence::StageSequence(Plan plan)
    : plan_(std::move(plan)), axis_start_(find_axis_start(plan_.stages)), current_(build()) {}

StageSequence::StageSequence(Plan plan, const RestartRecord& record)
    : plan_(std::move(plan)),
      index_(static_cast<std::size_t>(record.stage)),
      moving_index_(index_),
      axis_start_(record.axis_start),
      current_(build()) {}

const AnalysisSettings& StageSequence::settings() const {
    return index_ == 0 ? plan_.analysis : plan_.stages[index_].analysis;
}

FoundShapes StageSequence::find_shapes() const {
    const std::string stage = name().empty() ? kind_of(settings()) : name();
    const System& system = analysis().system();
    State state = analysis().state();
    undo_trial(state);
    if (const auto* modes = std::get_if<ModesSettings>(&settings()))
        return {stage, find_modes(system, state, state.time, *modes)};
    const double load_time = moving_index_ == 0 && !has_steps(plan_.analysis) ? 1.0 : state.time;
    return {stage, find_buckling(system, state, load_time, std::get<BucklingSettings>(settings()))};
}

StageSequence::Current StageSequence::build() const {
    Current current;
    if (index_ > 0) {
        current.model = std::make_unique<Model>(plan_.model);
        set_actions(plan_.stages[index_].actions, *current.model);
    }
    current.analysis = make_analysis(current.model ? *current.model : plan_.model, settings(), plan_.threads);
    current.analysis->watch(plan_.watched);
    return current;
}

double StageSequence::part_done() const {
    const auto count = static_cast<double>(std::max<std::size_t>(plan_.stages.size(), 1));
    const double part = has_steps(settings()) ? analysis().steps().part_done() : 0.0;
    return (static_cast<double>(index_) + part) / count;
}

EquilibriumReport StageSequence::enter_next() {
    if (!has_steps(plan_.stages[index_ + 1].analysis)) {
        ++index_;
        return {};
    }
    warnings_ = list_warnings();
    seconds_ = seconds();
    was_unstable_ = is_unstable();
    axis_start_ = axis();
    moving_index_ = ++index_;
    Current before = std::move(current_);
    current_ = build();
    return current_.analysis->start_after(*before.analysis);
}

PhaseSeconds StageSequence::seconds() const {
    PhaseSeconds sum = seconds_;
    sum += analysis().seconds();
    return sum;
}

std::vector<std::string> StageSequence::list_warnings() const {
    std::vector<std::string> warnings = warnings_;
    for (const std::string& warning : analysis().list_warnings()) warnings.push_back(prefix() + warning);
    return warnings;
}

}  // namespace gxrod
