#include "face/derivatives.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "analyses/contact_record.hpp"
#include "assembly/contact/contacts.hpp"
#include "assembly/system_measures.hpp"
#include "assembly/system_values.hpp"
#include "elements/tie_values.hpp"
#include "face/signal_derivatives.hpp"
#include "model/settings/analysis_traits.hpp"
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
    const bool is_point =
        node_of(request.target) >= 0 || std::holds_alternative<WatchedPoint>(request.target);
    if (!is_point && (tie == nullptr || !is_element(tie->kind)))
        throw std::invalid_argument("history " + request.name + " is of a " +
                                    (tie ? "joint" : "tendon or of contact") +
                                    "; there are gradients of points, springs and bushings");
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
    const std::optional<Seabed>& seabed = problem.model.surroundings.seabed;
    snapshot.has_ground = !seabed || seabed->acts();
    ContactRecord contacts;
    if (part_of(asked) == SnapshotPart::contact) {
        contacts = record_contacts(system, state, load_factor, list_contact_watches(requests), false);
        contacts.show_in(snapshot);
    }
    const HistoryRow row = HistoryWatch(problem.model, requests, history).compute(asked, snapshot);
    return {row.begin(), row.begin() + asked.columns};
}

Derivatives::Derivatives(const SteppedRun& run, std::vector<VariedNumber> variations)
    : run_(run), variations_(std::move(variations)) {
    const std::vector<StagePlan>& stages = run.problem().stages;
    for (std::size_t i = 0; i < stages.size(); ++i) {
        if (!has_steps(stages[i].analysis)) continue;
        Sensitivities::check_settings(stages[i].analysis);
        if (i == 0) continue;
        Model model = run.problem().model;
        set_actions(stages[i].actions, model);
        Sensitivities::check_model(model);
    }
    for (const VariedNumber& variation : variations_) {
        for (const Problem& problem : variation.problems) {
            if (problem.stages.size() != run.problem().stages.size())
                throw std::invalid_argument("it changes which stages there are");
        }
    }
    if (!run.problem().signals.empty()) signals_ = std::make_unique<SignalDerivatives>(run_, variations_);
    take_over(build());
}

Derivatives::~Derivatives() = default;

void Derivatives::take_over(OfStage stage) {
    std::swap(now_, stage);
    if (signals_) signals_->follow(*now_.carried);
}

void Derivatives::start() {
    now_.carried->start();
    if (signals_) signals_->start();
}

void Derivatives::note_before() {
    now_.carried->note_before();
    if (signals_) signals_->note_before();
}

Derivatives::OfStage Derivatives::build() const {
    OfStage built{run_.stages().moving_index(), {}, nullptr};
    std::vector<VariedModels> varied;
    for (const VariedNumber& variation : variations_) {
        if (built.stage == 0) {
            varied.push_back(variation.models());
            continue;
        }
        for (const Problem& problem : variation.problems) {
            built.models.push_back(std::make_unique<Model>(problem.model));
            set_actions(problem.stages[built.stage].actions, *built.models.back());
        }
        const auto last = built.models.end();
        varied.push_back({{**(last - 4), **(last - 3), variation.step},
                          {**(last - 2), **(last - 1), 2.0 * variation.step}});
    }
    built.carried =
        std::make_unique<Sensitivities>(run_.analysis(), run_.problem().stages[built.stage].analysis, varied);
    return built;
}

void Derivatives::advance() {
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    if (is_known_) now_.carried->advance();
}

void Derivatives::enter_stage() {
    if (!is_known_) return;
    try {
        OfStage next = build();
        if (signals_) signals_->begin_stage();
        next.carried->start_after(*now_.carried);
        take_over(std::move(next));
        if (signals_) signals_->note_before();
    } catch (...) {
        failure_ = std::current_exception();
        is_known_ = false;
    }
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
    const HistoryRequest& request = run_.problem().output.histories.at(history);
    if (part_of(*quantities_of(request).at(quantity)) == SnapshotPart::reactions &&
        Contacts(run_.analysis().system()).are_impulses())
        throw std::runtime_error(
            "there are no derivatives of reactions where contact is an impulse of a step; ask for the forces "
            "in "
            "the rod next to the support");
    return now_.carried->by(number).differentiate(
        [&](const System& system, const State& state, std::size_t side) {
            return compute_history(variations_[number].problems.at(side), system, state, history, quantity);
        });
}

std::shared_ptr<const Sensitivities::Record> Derivatives::save() const {
    if (!is_known_) return nullptr;
    Sensitivities::Record record = now_.carried->record();
    record.stage = now_.stage;
    return std::make_shared<const Sensitivities::Record>(std::move(record));
}

void Derivatives::restore(const Sensitivities::Record* record) {
    is_known_ = record != nullptr;
    if (!is_known_) return;
    if (record->stage == now_.stage) {
        now_.carried->follow(run_.analysis());
    } else {
        take_over(build());
    }
    now_.carried->recall(*record);
}

std::vector<int> list_nodes(const Problem& problem, const std::vector<WeightedQuantity>& sum) {
    std::vector<int> nodes;
    for (const WeightedQuantity& one : sum) {
        check_has_gradient(problem.output.histories.at(one.history), one.quantity);
        const std::vector<int> own = list_nodes(problem, one.history);
        nodes.insert(nodes.end(), own.begin(), own.end());
    }
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

std::vector<double> find_gradient(const SteppedRun& run,
                                  const std::vector<WeightedQuantity>& sum,
                                  const std::vector<VariedNumber>& variations) {
    const Problem& base = run.problem();
    const auto* settings = std::get_if<StaticSettings>(&base.analysis());
    if (settings == nullptr || base.stages.size() > 1)
        throw std::invalid_argument("there are gradients of equilibria, of a static analysis of one stage");
    const std::vector<int> nodes = list_nodes(base, sum);
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
