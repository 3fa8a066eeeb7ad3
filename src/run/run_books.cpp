#include "run/run_books.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "analyses/path/path.hpp"
#include "analyses/static.hpp"
#include "check/motions/stability.hpp"
#include "check/shape_report.hpp"
#include "model/energy_round_off.hpp"
#include "model/settings/analysis_traits.hpp"
#include "model/settings/newton_choice.hpp"

namespace gxrod {

namespace {

EnergyPoint point_of(const StageSequence& stages, const LedgerRow& ledger) {
    return {stages.axis(),
            ledger.strain_energy + ledger.dissipated_energy + ledger.contact_energy + ledger.contact_loss,
            ledger.external_work,
            ledger.work_uncertainty};
}

// To those of earlier stages.
void add_sentence(const std::string& sentence, const std::string& prefix, std::string& text) {
    if (!text.empty()) text += "; ";
    text += prefix + sentence;
}

}  // namespace

RunBooks::RunBooks(const Model& model, const std::vector<Finding>& examined) : model_(model) {
    for (const Finding& finding : examined) {
        if (finding.severity == Severity::warning) examined_.push_back(finding.message);
    }
}

std::string name_stage(const StageSequence& stages, std::int64_t stage_count) {
    return stage_count > 1 ? "stage " + stages.name() + ": " : "";
}

void RunBooks::complete() {
    if (summary_.status == RunStatus::running) summary_.status = RunStatus::complete;
}

void RunBooks::reopen() {
    summary_.status = RunStatus::running;
    summary_.reason.clear();
    summary_.reason_nodes.clear();
    summary_.failure.reset();
    summary_.deck_fault = summary_.out_of_memory = false;
    summed_up_.reset();
}

void RunBooks::fail(const std::string& reason) {
    summary_.status = RunStatus::failed;
    summary_.reason = reason;
}

void RunBooks::fail(const Failure& failure, const std::string& prefix) {
    fail(prefix + describe_failure(failure));
    summary_.reason_nodes = failure.nodes;
    summary_.failure = failure;
}

void RunBooks::begin(const StageSequence& stages) {
    first_step_ = stages.analysis().steps().steps_done();
    begin_branch(stages);
}

void RunBooks::begin_branch(const StageSequence& stages) {
    last_point_ = point_of(stages, stages.analysis().ledger_row());
}

void RunBooks::watch_energy(const StageSequence& stages, const LedgerRow& ledger, bool is_first) {
    const double energy = ledger.kinetic_energy + ledger.strain_energy;
    RunTotals& totals = summary_.totals;
    totals.largest_energy = std::max({totals.largest_energy, energy, std::abs(ledger.external_work)});
    totals.largest_energy_error = std::max(totals.largest_energy_error, std::abs(ledger.energy_error));
    if (is_timed(stages.settings()) || stages.analysis().frame() != nullptr) return;
    const EnergyPoint point = point_of(stages, ledger);
    if (!is_first) {
        const std::optional<EnergyJump> jump = find_jump(last_point_, point, totals.largest_energy);
        if (jump) add_jump(*jump, totals.jumps);
    }
    last_point_ = point;
}

void RunBooks::sum_up_stage(const StageSequence& stages, std::int64_t stage_count) {
    if (summed_up_ == stages.moving_index()) return;  // where the next stage could not start
    summed_up_ = stages.moving_index();
    const std::string prefix = stage_count > 1 ? "stage " + stages.name_of(stages.moving_index()) + ": " : "";
    note_pivots(stages, prefix);
    const JointAssembly& joints = stages.analysis().system().joints();
    for (const JointAssembly::Break& one : joints.list_breaks(stages.analysis().state())) {
        summary_.findings.push_back(fmt::format(
            "{}{} broke at t = {:.6g}", prefix, joints.name(static_cast<int>(one.joint)), one.time));
    }
    if (!is_path(stages.settings())) {
        for (const std::string& finding : stages.analysis().list_findings())
            summary_.findings.push_back(prefix + finding);
    }
    sum_up_cuts(stages, prefix);
    compare_errors(stages, prefix);
}

void RunBooks::note_pivots(const StageSequence& stages, const std::string& prefix) {
    const SteppedAnalysis& analysis = stages.analysis();
    const bool counts =
        dynamic_cast<const StaticAnalysis*>(&analysis) || dynamic_cast<const PathAnalysis*>(&analysis);
    if (!counts || analysis.steps().steps_done() == 0) return;
    const std::string cause = find_load_without_potential(stages.model());
    if (cause.empty()) return;
    summary_.notes.push_back(fmt::format(
        "{}{}, so pivots do not show whether equilibria are stable (/solver/negative_pivots is -1, unknown)",
        prefix,
        cause));
}

// Of this part of a run that was resumed.
void RunBooks::sum_up_cuts(const StageSequence& stages, const std::string& prefix) {
    const CutTally& tally = stages.analysis().cuts();
    const StepCuts cuts = tally.count(stages.analysis().steps().steps_done() - first_step_);
    if (!are_worth_telling(cuts)) return;
    add_sentence(
        count_cuts(cuts) + ": " + tally.describe_reasons(model_) +
            advise_on_cuts(stages.model(), stages.moving_settings(), stages.analysis().is_unstable()),
        prefix,
        summary_.cuts);
}

// Equal steps that are so short that the scheme's error is below what Newton's method leaves.
void RunBooks::compare_errors(const StageSequence& stages, const std::string& prefix) {
    const auto* dynamic = std::get_if<DynamicSettings>(&stages.moving_settings());
    const double error = stages.analysis().largest_error();
    const double tolerance = stages.analysis().newton().tolerance.value_or(usual_newton_tolerance);
    if (dynamic == nullptr || dynamic->adaptive || tolerance <= tolerable_newton_part * error) return;
    // Errors of a model at rest are round-off, which no tolerance makes smaller.
    if (newton_part * error < least_newton_tolerance) return;
    add_sentence(
        fmt::format(
            "the estimated errors of the steps, at most {:.2g}, are near what newton.tolerance, {:.2g}, "
            "leaves: "
            "shorter steps may gain nothing. newton.tolerance = {:.0e} would do",
            error,
            tolerance,
            newton_part * error),
        prefix,
        summary_.newton_limit);
}

void RunBooks::add_paths(const PathRecord& paths) {
    summary_.paths.push_back(paths);
    for (const FollowedPath& path : paths) {
        for (const std::string& finding : path.findings)
            summary_.findings.push_back(path.name + ": " + finding);
        if (!path.cause.empty()) add_warning(path.name + " was given up: " + path.cause);
    }
}

void RunBooks::close(const StageSequence& stages, std::int64_t stage_count) {
    sum_up_stage(stages, stage_count);
    summary_.is_unstable = stages.is_unstable();
    std::vector<std::string>& all = summary_.warnings;
    all = examined_;
    const auto add = [&](const std::vector<std::string>& more) {
        std::ranges::copy_if(
            more, std::back_inserter(all), [](const std::string& one) { return !one.empty(); });
    };
    add(stages.list_warnings());
    add(warnings_);
    add({summary_.cuts,
         summary_.newton_limit,
         describe_imbalance(summary_.energy(), compute_energy_round_off(model_))});
}

std::string RunBooks::join_warnings() const { return fmt::format("{}", fmt::join(summary_.warnings, "\n")); }

}  // namespace gxrod
