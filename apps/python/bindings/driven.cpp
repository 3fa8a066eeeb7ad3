#include "driven.hpp"

#include <algorithm>
#include <limits>

#include "deck/schema/choices.hpp"
#include "results/tables/quantity.hpp"

namespace gxrod::python {

Driven::Driven(const BuiltModel& model,
               const std::string& results,
               int threads,
               Kept kept,
               const std::vector<Varied>& varied)
    : problem_(model.deck->build(model.overrides)), kept_(std::move(kept)) {
    RunRequest request{problem_.model, problem_.analysis, problem_.output, problem_.record, {}};
    request.stages = problem_.stages;
    request.threads = threads;
    if (!results.empty()) request.results = ResultsFileOptions{results};
    request.observe = [this](const Snapshot& snapshot, const LedgerRow& ledger) { note(snapshot, ledger); };
    simulation_ = std::make_unique<Simulation>(request);
    const std::vector<HistoryRequest>& requests = problem_.output.histories;
    for (std::size_t i = 0; i < requests.size(); ++i) {
        Recorded recorded{HistoryPoint(problem_.model, requests, i), {}, {}};
        for (const Quantity quantity : requests[i].quantities)
            recorded.widths.push_back(quantity_form(quantity, recorded.point.kind()).shape.columns);
        recorded.records.resize(recorded.widths.size());
        histories_.push_back(std::move(recorded));
    }
    if (varied.empty()) return;
    if (problem_.stages.size() > 1)
        throw std::invalid_argument("derivatives are there for analyses of one stage");
    std::vector<VariedModels> all;
    for (const Varied& one : varied) {
        std::array<const Model*, 4> models{};
        for (std::size_t i = 0; i < 4; ++i) {
            const BuiltModel& built = *one.models[i];
            varied_.push_back(std::make_unique<const Problem>(built.deck->build(built.overrides)));
            models[i] = &varied_.back()->model;
        }
        all.push_back({{*models[0], *models[1], one.step}, {*models[2], *models[3], 2.0 * one.step}});
    }
    sensitivities_ = std::make_unique<Sensitivities>(simulation_->analysis(), problem_.analysis, all);
}

std::vector<double> Driven::differentiate_history(std::size_t number,
                                                  std::size_t history,
                                                  std::size_t quantity) {
    if (!has_derivatives_)
        throw std::logic_error("derivatives are not known after a return to an earlier state");
    const State& state = simulation_->analysis().state();
    const double load_factor = state.time;
    const std::vector<HistoryRequest>& requests = problem_.output.histories;
    const std::vector<RodPlace> places = list_rod_places(requests);
    const auto compute_one = [&](const System& system, const State& moved, std::size_t side) {
        const Problem& problem = *varied_.at(4 * number + side);
        const std::vector<PointValues> points = system.compute_point_values(moved, load_factor, places);
        const std::vector<JointValues> joints = system.joints().compute_joint_values(moved, load_factor);
        Snapshot snapshot{load_factor, moved.trial, {}, {}, points};
        snapshot.load_factor = snapshot.limit_load_factor = load_factor;
        snapshot.joints = joints;
        HistoryPoint point(problem.model, problem.output.histories, history);
        const HistoryPoint::Row row = point.compute(requests.at(history).quantities.at(quantity), snapshot);
        return std::vector<double>(row.begin(), row.begin() + histories_[history].widths[quantity]);
    };
    return sensitivities_->by(number).differentiate_function(state, compute_one);
}

bool Driven::start() {
    if (!simulation_->start()) return false;
    if (sensitivities_) sensitivities_->start(simulation_->analysis());
    return true;
}

bool Driven::take_step() {
    if (sensitivities_) sensitivities_->note_before(simulation_->analysis());
    if (!simulation_->step()) return false;
    if (sensitivities_ && has_derivatives_) sensitivities_->advance(simulation_->analysis());
    return true;
}

bool Driven::step() {
    const bool is_accepted = take_step();
    views_.follow(nodes());
    return is_accepted;
}

long Driven::advance(std::optional<double> until, long most_steps) {
    long steps = 0;
    double goal = until.value_or(std::numeric_limits<double>::infinity());
    while (steps < most_steps && !simulation_->has_ended()) {
        if (until) goal = simulation_->land_on(*until).value_or(goal);
        if (simulation_->time() >= goal || !take_step()) break;
        ++steps;
    }
    views_.follow(nodes());
    return steps;
}

void Driven::note(const Snapshot& snapshot, const LedgerRow& ledger) {
    times_.push_back(snapshot.time);
    if (kept_.ledger) ledgers_.push_back(ledger);
    for (const std::size_t history : kept_.histories) {
        for (std::size_t quantity = 0; quantity < histories_.at(history).widths.size(); ++quantity)
            compute(history, quantity, snapshot, histories_[history].records[quantity]);
    }
}

void Driven::restore(const Checkpoint& checkpoint) {
    simulation_->restore(checkpoint);
    has_derivatives_ = false;
    const auto rows = static_cast<std::size_t>(checkpoint.rows);
    // Of another simulation's checkpoint there may be more rows than here.
    const auto cut = [&](auto& values, std::size_t width) {
        values.resize(std::min(values.size(), width * rows));
    };
    cut(times_, 1);
    ledgers_.resize(std::min(ledgers_.size(), rows));
    for (Recorded& recorded : histories_) {
        for (std::size_t i = 0; i < recorded.widths.size(); ++i)
            cut(recorded.records[i], static_cast<std::size_t>(recorded.widths[i]));
    }
    views_.follow(nodes());
}

void Driven::compute(std::size_t history,
                     std::size_t quantity,
                     const Snapshot& snapshot,
                     std::vector<double>& to) {
    Recorded& recorded = histories_.at(history);
    const HistoryPoint::Row row =
        recorded.point.compute(problem_.output.histories[history].quantities.at(quantity), snapshot);
    to.insert(to.end(), row.begin(), row.begin() + recorded.widths[quantity]);
}

std::vector<double> Driven::compute_history(std::size_t history, std::size_t quantity) {
    std::vector<double> values;
    compute(history, quantity, simulation_->take_snapshot(false), values);
    return values;
}

std::vector<std::string> Driven::list_quantities(std::size_t history) const {
    std::vector<std::string> names;
    for (const Quantity quantity : problem_.output.histories.at(history).quantities) {
        for (const auto& choice : quantity_choices) {
            if (choice.value == quantity) names.emplace_back(choice.word);
        }
    }
    return names;
}

}  // namespace gxrod::python
