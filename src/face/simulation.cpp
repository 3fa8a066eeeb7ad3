#include "face/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "assembly/touching_system.hpp"
#include "check/model_examination.hpp"
#include "face/convergence_error.hpp"
#include "face/unknown_name_error.hpp"
#include "model/evaluation_error.hpp"
#include "model/path_dependence.hpp"

namespace gxrod {
namespace {

std::vector<std::string> list_histories(const Problem& problem) {
    std::vector<std::string> names;
    for (const HistoryRequest& request : problem.output.histories) names.push_back(request.name);
    return names;
}

const Input& find_input(const Problem& problem, const std::string& name) {
    std::vector<std::string> names;
    for (const std::shared_ptr<Input>& input : problem.model.inputs) names.push_back(input->name());
    return *problem.model.inputs[find_name("input", name, names)];
}

}  // namespace

Simulation::Simulation(Problem&& problem, Options options)
    : problem_(std::move(problem)), writes_(!options.results.empty()) {
    choose_records(options.record);
    RunRequest request{problem_};
    request.threads = options.threads;
    if (writes_) {
        request.results = ResultsFileOptions{options.results};
        request.examined = examine_stages(problem_.model, problem_.stages);
    }
    request.observe = [this](const Snapshot& snapshot, const LedgerRow& ledger) { note(snapshot, ledger); };
    request.observe_stage = [this] {
        if (derivatives_) derivatives_->enter_stage();
    };
    run_ = std::make_unique<SteppedRun>(request);
    add_histories();
    if (!options.sensitivities.empty())
        derivatives_ = std::make_unique<Derivatives>(*run_, std::move(options.sensitivities));
    run_->start();
    throw_if_failed();
    if (derivatives_) derivatives_->start();
}

Simulation::~Simulation() {
    try {
        if (writes_) run_->close();
    } catch (...) {  // what was written stays
    }
}

void Simulation::add_histories() {
    const std::vector<HistoryRequest>& requests = problem_.output.histories;
    for (std::size_t i = 0; i < requests.size(); ++i) {
        Recorded recorded{HistoryWatch(problem_.model, requests, i), quantities_of(requests[i]), {}};
        recorded.records.resize(recorded.quantities.size());
        histories_.push_back(std::move(recorded));
    }
}

void Simulation::choose_records(const std::optional<std::vector<std::string>>& names) {
    const std::vector<std::string> histories = list_histories(problem_);
    keeps_ledger_ = !names || std::ranges::find(*names, "ledger") != names->end();
    for (const std::string& name : names.value_or(histories)) {
        if (!names || name != "ledger") kept_.push_back(find_name("history", name, histories));
    }
}

void Simulation::throw_if_failed() const {
    const RunSummary& summary = this->summary();
    if (summary.status != RunStatus::failed) return;
    if (!summary.failure && summary.deck_fault) throw EvaluationError(summary.reason);
    throw ConvergenceError(summary.reason, summary.failure);
}

bool Simulation::take_step(std::optional<double> landing) {
    if (derivatives_) derivatives_->note_before();
    if (!run_->step()) return false;
    StepCall& call = calls_.emplace_back(landing);
    for (const std::shared_ptr<Input>& input : problem_.model.inputs) call.inputs.push_back(input->state());
    if (derivatives_) derivatives_->advance();
    return true;
}

// Completes the results of a run that has come to its end, whether it will be closed or not.
void Simulation::complete() {
    if (writes_ && finished()) run_->close();
}

void Simulation::interrupt() {
    run_->interrupt();
    complete();
}

bool Simulation::step() {
    set_inputs(next_time());
    const bool is_accepted = take_step();
    throw_if_failed();
    complete();
    return is_accepted;
}

long Simulation::advance(std::optional<double> until, long most_steps) {
    set_inputs(until.value_or(next_time()));
    long steps = 0;
    double goal = until.value_or(std::numeric_limits<double>::infinity());
    while (steps < most_steps && !finished()) {
        if (until) goal = run_->land_on(*until).value_or(goal);
        if (time() >= goal || !take_step(until)) break;
        ++steps;
    }
    throw_if_failed();
    complete();
    return steps;
}

const RunSummary& Simulation::run() {
    while (!finished()) advance(std::nullopt);
    return summary();
}

double Simulation::next_time() const {
    return run_->stages().axis_start() + run_->analysis().steps().next_time();
}

Values Simulation::operator[](const std::string& history) {
    return {*this, find_name("history", history, list_histories(problem_))};
}

void Simulation::set(const std::string& name, double value) {
    find_input(problem_, name);
    if (!std::isfinite(value)) throw std::invalid_argument(fmt::format("input {} cannot be {}", name, value));
    pending_[name] = value;
}

double Simulation::input(const std::string& name) const {
    const auto pending = pending_.find(name);
    return pending != pending_.end() ? pending->second
                                     : find_input(problem_, name)(run_->analysis().state().time);
}

void Simulation::set_inputs(double until) {
    for (const auto& [name, value] : pending_) run_->set_input(name, value, until);
    pending_.clear();
}

Checkpoint Simulation::save() const {
    Checkpoint saved{run_->save()};
    if (derivatives_) saved.derivatives = derivatives_->save();
    if (saved.derivatives) saved.owner = this;
    return saved;
}

void Simulation::restore(const Checkpoint& checkpoint) {
    run_->restore(checkpoint);
    pending_.clear();
    if (derivatives_)
        derivatives_->restore(checkpoint.owner == this ? checkpoint.derivatives.get() : nullptr);
    const auto rows = static_cast<std::size_t>(checkpoint.rows);
    // There may be more rows in a checkpoint of another simulation than here.
    const auto cut = [&](auto& values, std::size_t width) {
        values.resize(std::min(values.size(), width * rows));
    };
    cut(times_, 1);
    ledgers_.resize(std::min(ledgers_.size(), rows));
    calls_.resize(std::min(calls_.size(), std::max(rows, std::size_t{1}) - 1));
    for (Recorded& recorded : histories_) {
        for (std::size_t i = 0; i < recorded.quantities.size(); ++i)
            cut(recorded.records[i], static_cast<std::size_t>(recorded.quantities[i]->columns));
    }
}

void Simulation::note(const Snapshot& snapshot, const LedgerRow& ledger) {
    times_.push_back(snapshot.time);
    if (keeps_ledger_) ledgers_.push_back(ledger);
    for (const std::size_t history : kept_) {
        Recorded& recorded = histories_.at(history);
        for (std::size_t quantity = 0; quantity < recorded.quantities.size(); ++quantity)
            add_row(history, quantity, snapshot, recorded.records[quantity]);
    }
}

void Simulation::add_row(std::size_t history,
                         std::size_t quantity,
                         const Snapshot& snapshot,
                         std::vector<double>& to) {
    Recorded& recorded = histories_.at(history);
    const Quantity& asked = *recorded.quantities.at(quantity);
    const HistoryRow row = recorded.watch.compute(asked, snapshot);
    to.insert(to.end(), row.begin(), row.begin() + asked.columns);
}

std::vector<double> Simulation::compute(std::size_t history, std::size_t quantity) {
    return compute({{history, quantity}});
}

std::vector<double> Simulation::compute(const std::vector<RecordedQuantity>& quantities) {
    const Snapshot snapshot = run_->take_snapshot(false);
    std::vector<double> values;
    for (const auto& [history, quantity] : quantities) add_row(history, quantity, snapshot, values);
    return values;
}

std::vector<std::string> Simulation::list_quantities(std::size_t history) const {
    return problem_.output.histories.at(history).quantities;
}

SmallMotionMatrices Simulation::matrices() const {
    State state = run_->analysis().state();
    undo_trial(state);
    const TouchingSystem touching(run_->analysis().system(), state);
    return {touching.system().pattern(),
            compute_state_matrices(touching.system(), touching.state(), state.time)};
}

const std::vector<double>& Simulation::records(const std::string& history,
                                               const std::string& quantity) const {
    std::vector<std::string> kept;
    for (const std::size_t index : kept_) kept.push_back(problem_.output.histories[index].name);
    const std::size_t index = kept_[find_name("record", history, kept)];
    return records(index, find_name("quantity of history " + history, quantity, list_quantities(index)));
}

SweptGradient Simulation::find_gradient(const std::vector<WeightedQuantity>& sum,
                                        const std::vector<VariedNumber>& variations,
                                        const std::vector<std::string>& inputs) const {
    const auto is_of_end = [&](const WeightedQuantity& one) {
        return one.weights.size() == static_cast<std::size_t>(width(one.history, one.quantity));
    };
    const bool is_equilibrium =
        std::holds_alternative<StaticSettings>(problem_.analysis()) && !depends_on_path(problem_.model);
    if (is_equilibrium && inputs.empty() && std::ranges::all_of(sum, is_of_end))
        return {gxrod::find_gradient(*run_, sum, variations), {}};
    std::vector<std::size_t> indices;
    for (const std::string& name : inputs) {
        const Input& input = find_input(problem_, name);
        for (std::size_t i = 0; i < problem_.model.inputs.size(); ++i) {
            if (problem_.model.inputs[i].get() == &input) indices.push_back(i);
        }
    }
    return sweep_back(*run_, calls_, sum, variations, indices);
}

std::vector<std::string> Simulation::numbers() const {
    return derivatives_ ? derivatives_->numbers() : std::vector<std::string>{};
}

std::vector<double> Simulation::differentiate(std::size_t number,
                                              std::size_t history,
                                              std::size_t quantity) const {
    if (!derivatives_) throw std::logic_error("the simulation carries no derivatives along");
    return derivatives_->differentiate(number, history, quantity);
}

}  // namespace gxrod
