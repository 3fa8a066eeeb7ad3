#include "face/derivatives.hpp"

#include <algorithm>
#include <stdexcept>

#include "assembly/system_measures.hpp"
#include "assembly/system_values.hpp"
#include "elements/tie_values.hpp"
#include "sensitivity/equilibrium_adjoint.hpp"
#include "watch/history_watch.hpp"

namespace gxrod {
namespace {

// Lists the nodes on whose motion a history depends.
std::vector<int> list_nodes(const Problem& problem, std::size_t history) {
    const HistoryRequest& request = problem.output.histories.at(history);
    std::vector<int> nodes;
    const auto add = [&](int node) {
        if (node >= 0) nodes.push_back(node);
    };
    add(node_of(request.target));
    add(request.relative_node);
    if (const auto* point = std::get_if<WatchedPoint>(&request.target)) {
        const Rod& rod = problem.model.rods[static_cast<std::size_t>(point->place.rod)];
        const std::ptrdiff_t first = std::ptrdiff_t{point->place.element} * (rod.order + 1);
        for (int i = 0; i <= rod.order; ++i) add(rod.element_nodes[static_cast<std::size_t>(first + i)]);
    }
    if (const auto* tie = std::get_if<WatchedTie>(&request.target)) {
        const std::vector<Tie> ties = list_ties(problem.model, tie->kind);
        for (const Anchor& end : ties[static_cast<std::size_t>(tie->index)].ends) add(end.node);
    }
    return nodes;
}

// Throws std::invalid_argument if a quantity has no gradient.
void check_has_gradient(const HistoryRequest& request, std::size_t quantity) {
    const auto* tie = std::get_if<WatchedTie>(&request.target);
    if (tie != nullptr && !is_element(tie->kind))
        throw std::invalid_argument("history " + request.name +
                                    " is of a joint; there are gradients of points, springs and bushings");
    if (part_of(*quantities_of(request).at(quantity)) == SnapshotPart::reactions)
        throw std::invalid_argument("there are no gradients of reactions; carry derivatives along instead");
}

}  // namespace

std::vector<double> compute_history(const Problem& problem,
                                    const System& system,
                                    const State& state,
                                    std::size_t history,
                                    std::size_t quantity) {
    const double load_factor = state.trial_time;
    const std::vector<HistoryRequest>& requests = problem.output.histories;
    const std::vector<PointValues> points =
        SystemValues(system).compute_point_values(state, load_factor, list_rod_places(requests));
    const std::vector<JointValues> joints = system.joints().compute_joint_values(state, load_factor);
    const Quantity& asked = *quantities_of(requests.at(history)).at(quantity);
    std::vector<Vec6> reactions;
    if (part_of(asked) == SnapshotPart::reactions) {
        Residual residual;
        system.compute_residual(state, load_factor, residual);
        reactions = SystemMeasures(system).compute_reactions(residual);
    }
    Snapshot snapshot{load_factor, state.trial, {}, reactions, points};
    snapshot.load_factor = snapshot.limit_load_factor = load_factor;
    snapshot.joints = joints;
    const TieValues ties = compute_tie_values(problem.model, state.trial);
    snapshot.ties = &ties;
    const std::vector<PointSurroundings> bodies =
        SystemValues(system).compute_body_surroundings(state, load_factor);
    snapshot.bodies = bodies;
    std::vector<TendonValues> tendons;
    if (std::holds_alternative<WatchedTendon>(requests.at(history).target))
        tendons = SystemValues(system).compute_tendon_values(state, load_factor);
    snapshot.tendons = tendons;
    const HistoryRow row = HistoryWatch(problem.model, requests, history).compute(asked, snapshot);
    return {row.begin(), row.begin() + asked.columns};
}

Derivatives::Derivatives(const SteppedRun& run, std::vector<VariedNumber> variations)
    : run_(run), variations_(std::move(variations)) {
    if (run.problem().stages.size() > 1)
        throw std::invalid_argument("derivatives are there for analyses of one stage");
    std::vector<VariedModels> models;
    for (const VariedNumber& variation : variations_) models.push_back(variation.models());
    sensitivities_ = std::make_unique<Sensitivities>(run.analysis(), run.problem().analysis(), models);
}

std::vector<std::string> Derivatives::numbers() const {
    std::vector<std::string> names;
    for (const VariedNumber& variation : variations_) names.push_back(variation.name);
    return names;
}

std::vector<double> Derivatives::differentiate(std::size_t number,
                                               std::size_t history,
                                               std::size_t quantity) const {
    if (!is_known_)
        throw std::logic_error(
            "derivatives are not known after a return to a state that was saved without "
            "them, as pickles are");
    return sensitivities_->by(number).differentiate(
        [&](const System& system, const State& state, std::size_t side) {
            return compute_history(variations_[number].problems.at(side), system, state, history, quantity);
        });
}

std::shared_ptr<const Sensitivities::Record> Derivatives::save() const {
    return is_known_ ? std::make_shared<const Sensitivities::Record>(sensitivities_->record()) : nullptr;
}

void Derivatives::restore(const Sensitivities::Record* record) {
    is_known_ = record != nullptr;
    if (!is_known_) return;
    sensitivities_->follow(run_.analysis());
    sensitivities_->recall(*record);
}

std::vector<double> find_gradient(const SteppedRun& run,
                                  const std::vector<WeightedQuantity>& sum,
                                  const std::vector<VariedNumber>& variations) {
    const Problem& base = run.problem();
    const auto* settings = std::get_if<StaticSettings>(&base.analysis());
    if (settings == nullptr || base.stages.size() > 1)
        throw std::invalid_argument("there are gradients of equilibria, of a static analysis of one stage");
    std::vector<int> nodes;
    for (const WeightedQuantity& one : sum) {
        const HistoryRequest& request = base.output.histories.at(one.history);
        check_has_gradient(request, one.quantity);
        const std::vector<int> own = list_nodes(base, one.history);
        nodes.insert(nodes.end(), own.begin(), own.end());
    }
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    const VariedNumber* varied = nullptr;
    const auto add_up = [&](const System& system, const State& state, int side) {
        const Problem& problem = side < 0 ? base : varied->problems[static_cast<std::size_t>(side)];
        double total = 0.0;
        for (const WeightedQuantity& one : sum) {
            const std::vector<double> row =
                compute_history(problem, system, state, one.history, one.quantity);
            for (std::size_t i = 0; i < row.size(); ++i) total += one.weights.at(i) * row[i];
        }
        return total;
    };
    const SteppedAnalysis& analysis = run.analysis();
    const EquilibriumAdjoint adjoint(
        analysis.system(), analysis.state(), analysis.state().time, settings->linear_solver, nodes, add_up);
    std::vector<double> gradient;
    for (const VariedNumber& one : variations) {
        varied = &one;
        gradient.push_back(adjoint.differentiate(one.models(), add_up));
    }
    return gradient;
}

}  // namespace gxrod
