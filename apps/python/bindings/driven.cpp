#include "driven.hpp"

#include <algorithm>
#include <limits>

#include "check/model_examination.hpp"
#include "elements/tie_values.hpp"
#include "sensitivity/equilibrium_adjoint.hpp"

namespace gxrod::python {

namespace {

std::unique_ptr<const Problem> build(const BuiltModel& built) {
    return std::make_unique<const Problem>(built.deck->build(built.overrides));
}

// Of four in a row.
VariedModels pair_models(std::span<const std::unique_ptr<const Problem>> sides, double step) {
    return {{sides[0]->model, sides[1]->model, step}, {sides[2]->model, sides[3]->model, 2.0 * step}};
}

}  // namespace

Driven::Driven(const BuiltModel& model,
               const std::string& results,
               int threads,
               Kept kept,
               const std::vector<Varied>& varied)
    : problem_(model.deck->build(model.overrides)), kept_(std::move(kept)) {
    RunRequest request{problem_};
    request.threads = threads;
    if (!results.empty()) {
        request.results = ResultsFileOptions{results};
        request.examined = examine_stages(problem_.model, problem_.stages);
    }
    request.observe = [this](const Snapshot& snapshot, const LedgerRow& ledger) { note(snapshot, ledger); };
    simulation_ = std::make_unique<SteppedRun>(request);
    const std::vector<HistoryRequest>& requests = problem_.output.histories;
    for (std::size_t i = 0; i < requests.size(); ++i) {
        Recorded recorded{HistoryWatch(problem_.model, requests, i), quantities_of(requests[i]), {}};
        recorded.records.resize(recorded.quantities.size());
        histories_.push_back(std::move(recorded));
    }
    if (varied.empty()) return;
    if (problem_.stages.size() > 1)
        throw std::invalid_argument("derivatives are there for analyses of one stage");
    std::vector<VariedModels> all;
    for (const Varied& one : varied) {
        for (const BuiltModel* side : one.models) varied_.push_back(build(*side));
        all.push_back(pair_models({varied_.end() - 4, varied_.end()}, one.step));
    }
    sensitivities_ = std::make_unique<Sensitivities>(simulation_->analysis(), problem_.analysis(), all);
}

std::vector<double> Driven::differentiate_history(std::size_t number,
                                                  std::size_t history,
                                                  std::size_t quantity) {
    if (!has_derivatives_)
        throw std::logic_error(
            "derivatives are not known after a return to a state that was saved without "
            "them, as pickles are");
    return sensitivities_->by(number).differentiate(
        [&](const System& system, const State& state, std::size_t side) {
            return compute_at(*varied_.at(4 * number + side), system, state, history, quantity);
        });
}

std::vector<double> Driven::compute_at(const Problem& problem,
                                       const System& system,
                                       const State& state,
                                       std::size_t history,
                                       std::size_t quantity) const {
    const double load_factor = state.trial_time;
    const std::vector<HistoryRequest>& requests = problem_.output.histories;
    const std::vector<PointValues> points =
        system.compute_point_values(state, load_factor, list_rod_places(requests));
    const std::vector<JointValues> joints = system.joints().compute_joint_values(state, load_factor);
    const Quantity& asked = *histories_.at(history).quantities.at(quantity);
    std::vector<Vec6> reactions;
    if (part_of(asked) == Part::reactions) {
        Residual residual;
        system.compute_residual(state, load_factor, residual);
        reactions = system.compute_reactions(residual);
    }
    Snapshot snapshot{load_factor, state.trial, {}, reactions, points};
    snapshot.load_factor = snapshot.limit_load_factor = load_factor;
    const std::vector<SpringValues> springs = compute_spring_values(problem.model, state.trial);
    const std::vector<BushingValues> bushings = compute_bushing_values(problem.model, state.trial);
    snapshot.springs = springs;
    snapshot.bushings = bushings;
    snapshot.joints = joints;
    const std::vector<PointSurroundings> bodies = system.compute_body_surroundings(state, load_factor);
    snapshot.bodies = bodies;
    std::vector<TendonValues> tendons;
    if (std::holds_alternative<WatchedTendon>(requests.at(history).target))
        tendons = system.compute_tendon_values(state, load_factor);
    snapshot.tendons = tendons;
    const HistoryRow row = HistoryWatch(problem.model, requests, history).compute(asked, snapshot);
    return {row.begin(), row.begin() + asked.columns};
}

std::vector<int> Driven::list_nodes(std::size_t history) const {
    const HistoryRequest& request = problem_.output.histories.at(history);
    std::vector<int> nodes;
    const auto add = [&](int node) {
        if (node >= 0 && std::ranges::find(nodes, node) == nodes.end()) nodes.push_back(node);
    };
    add(node_of(request.target));
    add(request.relative_node);
    if (const auto* point = std::get_if<WatchedPoint>(&request.target)) {
        const Rod& rod = problem_.model.rods[static_cast<std::size_t>(point->place.rod)];
        const std::ptrdiff_t first = std::ptrdiff_t{point->place.element} * (rod.order + 1);
        for (int i = 0; i <= rod.order; ++i) add(rod.element_nodes[static_cast<std::size_t>(first + i)]);
    }
    const auto add_ends = [&](const std::array<Anchor, 2>& ends) {
        for (const Anchor& end : ends) add(end.node);
    };
    if (const auto* spring = std::get_if<WatchedSpring>(&request.target))
        add_ends(problem_.model.springs[static_cast<std::size_t>(spring->index)].ends);
    if (const auto* bushing = std::get_if<WatchedBushing>(&request.target))
        add_ends(problem_.model.bushings[static_cast<std::size_t>(bushing->index)].ends);
    return nodes;
}

std::vector<double> Driven::find_gradient(const std::vector<Weighted>& sum,
                                          const std::vector<Varied>& varied) {
    const auto* settings = std::get_if<StaticSettings>(&problem_.analysis());
    if (settings == nullptr || problem_.stages.size() > 1)
        throw std::invalid_argument("there are gradients of equilibria, of a static analysis of one stage");
    std::vector<int> nodes;
    for (const Weighted& one : sum) {
        const HistoryRequest& request = problem_.output.histories.at(one.history);
        if (std::holds_alternative<WatchedJoint>(request.target) ||
            std::holds_alternative<WatchedSleeve>(request.target) ||
            std::holds_alternative<WatchedGear>(request.target))
            throw std::invalid_argument(
                "history " + request.name +
                " is of a joint; there are gradients of points, springs and bushings");
        if (part_of(*histories_.at(one.history).quantities.at(one.quantity)) == Part::reactions)
            throw std::invalid_argument(
                "there are no gradients of reactions; carry derivatives along instead");
        const std::vector<int> own = list_nodes(one.history);
        nodes.insert(nodes.end(), own.begin(), own.end());
    }
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    std::vector<std::unique_ptr<const Problem>> sides;
    const auto add_up = [&](const System& system, const State& state, int side) {
        const Problem& problem = side < 0 ? problem_ : *sides[static_cast<std::size_t>(side)];
        double total = 0.0;
        for (const Weighted& one : sum) {
            const std::vector<double> row = compute_at(problem, system, state, one.history, one.quantity);
            for (std::size_t i = 0; i < row.size(); ++i) total += one.weights.at(i) * row[i];
        }
        return total;
    };
    const SteppedAnalysis& analysis = simulation_->analysis();
    const EquilibriumAdjoint adjoint(
        analysis.system(), analysis.state(), analysis.state().time, settings->linear_solver, nodes, add_up);
    std::vector<double> gradient;
    for (const Varied& one : varied) {
        sides.clear();
        for (const BuiltModel* side : one.models) sides.push_back(build(*side));
        gradient.push_back(adjoint.differentiate(pair_models(sides, one.step), add_up));
    }
    return gradient;
}

bool Driven::start() {
    if (!simulation_->start()) return false;
    if (sensitivities_) sensitivities_->start();
    return true;
}

bool Driven::take_step() {
    if (sensitivities_) sensitivities_->note_before();
    if (!simulation_->step()) return false;
    if (sensitivities_ && has_derivatives_) sensitivities_->advance();
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
        for (std::size_t quantity = 0; quantity < histories_.at(history).quantities.size(); ++quantity)
            compute(history, quantity, snapshot, histories_[history].records[quantity]);
    }
}

SavedState Driven::save() const {
    SavedState saved{simulation_->save()};
    if (!sensitivities_ || !has_derivatives_) return saved;
    saved.derivatives = std::make_shared<const Sensitivities::Record>(sensitivities_->record());
    saved.owner = this;
    return saved;
}

void Driven::restore(const SavedState& checkpoint) {
    simulation_->restore(checkpoint);
    has_derivatives_ = checkpoint.owner == this;
    if (has_derivatives_) {
        sensitivities_->follow(simulation_->analysis());
        sensitivities_->recall(*checkpoint.derivatives);
    }
    const auto rows = static_cast<std::size_t>(checkpoint.rows);
    // Of another simulation's checkpoint there may be more rows than here.
    const auto cut = [&](auto& values, std::size_t width) {
        values.resize(std::min(values.size(), width * rows));
    };
    cut(times_, 1);
    ledgers_.resize(std::min(ledgers_.size(), rows));
    for (Recorded& recorded : histories_) {
        for (std::size_t i = 0; i < recorded.quantities.size(); ++i)
            cut(recorded.records[i], static_cast<std::size_t>(recorded.quantities[i]->columns));
    }
    views_.follow(nodes());
}

void Driven::compute(std::size_t history,
                     std::size_t quantity,
                     const Snapshot& snapshot,
                     std::vector<double>& to) {
    Recorded& recorded = histories_.at(history);
    const Quantity& asked = *recorded.quantities.at(quantity);
    const HistoryRow row = recorded.watch.compute(asked, snapshot);
    to.insert(to.end(), row.begin(), row.begin() + asked.columns);
}

std::vector<double> Driven::compute_history(std::size_t history, std::size_t quantity) {
    std::vector<double> values;
    compute(history, quantity, simulation_->take_snapshot(false), values);
    return values;
}

std::vector<std::string> Driven::list_quantities(std::size_t history) const {
    return problem_.output.histories.at(history).quantities;
}

}  // namespace gxrod::python
