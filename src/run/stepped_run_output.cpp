#include <fmt/format.h>

#include "analyses/dynamic.hpp"
#include "model/settings/analysis_traits.hpp"
#include "model/settings/frame_interval.hpp"
#include "run/stepped_run.hpp"

// What a simulation writes, and when.
namespace gxrod {

namespace {

// Which polynomials carry what is written at times within steps; of several stages each its own.
std::string describe_interpolants(const std::vector<StagePlan>& stages) {
    std::string words;
    const auto add = [&](const std::string& stage, const AnalysisSettings& analysis) {
        const auto* dynamic = std::get_if<DynamicSettings>(&analysis);
        if (dynamic == nullptr) return;
        const Interpolant interpolant = make_scheme(*dynamic)->interpolant();
        words += fmt::format("{}{}{}, order {}",
                             words.empty() ? "" : "; ",
                             stage.empty() ? "" : stage + ": ",
                             interpolant.form,
                             interpolant.order);
    };
    for (const StagePlan& stage : stages) add(stage.name, stage.analysis);
    return words;
}

}  // namespace

void SteppedRun::note_interpolants() {
    if (file_ && !OutputSchedule(problem().output, 0.0).is_empty())
        file_->note_interpolant(describe_interpolants(problem().stages));
}

// Of the stage at hand, whose analysis is new.
void SteppedRun::schedule_output() {
    schedule_ = OutputSchedule();
    if (!file_ || !is_timed(stages_->settings())) return;
    schedule_ = OutputSchedule(problem().output, stages_->axis_start());
    if (schedule_.is_empty()) return;
    stages_->analysis().keep_steps([this](double from, double to) { return schedule_.has_inner(from, to); });
}

long SteppedRun::frame_interval() const {
    return stages_->index() == 0 ? problem().output.every : problem().stages[stages_->index()].frame_interval;
}

void SteppedRun::record() {
    const PhaseTimer timer(output_seconds_);
    last_framed_ = file_ && is_frame_due();
    const LedgerRow ledger = analysis().ledger_row();
    books_.watch_energy(*stages_, ledger, !has_started_);
    accepted_totals_ = books_.summary().totals;
    if (!signals_.empty()) signals_.measure(take_snapshot(false));
    if (file_ || request_.observe) {
        record_within();
        const Snapshot snapshot = take_snapshot(last_framed_);
        if (request_.observe) request_.observe(snapshot, ledger);
        if (file_) file_->record_step(snapshot, ledger, analysis().solver_row());
        if (last_framed_) file_->write_frame(snapshot);
        if (find_due().is_sample) file_->record_sample(snapshot);
    }
    recorded_time_ = stages_->axis();
    ++rows_;
    if (file_ && file_->is_flush_due()) {
        if (!stages_->has_critical_points()) file_->set_restart(restart_record());
        file_->flush();
    }
}

// Frames and samples that are due before the end of the accepted step.
void SteppedRun::record_within() {
    if (!has_started_ || schedule_.is_empty()) return;
    std::vector<DueOutput> due = schedule_.list(analysis().step_start(), analysis().state().time);
    due.pop_back();
    for (const DueOutput& each : due) {
        Snapshot snapshot = stages_->analysis().snapshot_within(each.time, each.is_frame);
        complete(snapshot, each.time);
        if (each.is_frame) file_->write_frame(snapshot);
        if (each.is_sample) file_->record_sample(snapshot);
    }
}

Snapshot SteppedRun::take_snapshot(bool with_elements) {
    Snapshot snapshot = stages_->analysis().snapshot(with_elements);
    complete(snapshot, analysis().state().time);
    snapshot.time = stages_->axis();
    return snapshot;
}

void SteppedRun::complete(Snapshot& snapshot, double time) {
    snapshot.time = stages_->axis_start() + time;
    snapshot.stage = static_cast<int>(stages_->moving_index());
    snapshot.load_factor = time;
    snapshot.branch = stages_->branch();
    input_values_.clear();
    for (const std::shared_ptr<Input>& input : problem().model.inputs)
        input_values_.push_back((*input)(snapshot.load_factor));
    snapshot.inputs = input_values_;
    snapshot.limit_load_factor = limit_load_factor_of(stages_->settings()).value_or(snapshot.load_factor);
}

// At the accepted time.
DueOutput SteppedRun::find_due() const {
    const double now = analysis().state().time;
    if (schedule_.is_empty()) return {now, false, false};
    if (!has_started_) return schedule_.list_start();
    return schedule_.list(analysis().step_start(), now).back();
}

// At the accepted time; the one before it is recorded. The end of a stage is shown.
bool SteppedRun::is_frame_due() const {
    if (analysis().finished() && (!stages_->is_last() || is_path(stages_->settings()))) return true;
    if (schedule_.has_frames()) return !has_started_ || find_due().is_frame;
    const long interval = frame_interval();
    if (interval > 0) return analysis().steps().is_frame_due(interval);
    const double before = recorded_time_ - stages_->axis_start();
    return !has_started_ || is_frame_time(before, analysis().state().time, end_of(stages_->settings()));
}

// Frames show where a path that was given up ends, too.
void SteppedRun::show_last() {
    if (!file_ || last_framed_ || !has_started_) return;
    file_->write_frame(take_snapshot());
    last_framed_ = true;
}

void SteppedRun::write_end() {
    // If memory ran out, the last step may not have become a row; a resumed run takes it again.
    if (has_started_ && recorded_time_ != stages_->axis()) return;
    if (has_started_ && !stages_->has_critical_points()) file_->set_restart(restart_record());
    // The last frame, where none was due, is no part of what a run resumes from.
    if (!last_framed_) file_->write_frame(take_snapshot());
}

}  // namespace gxrod
