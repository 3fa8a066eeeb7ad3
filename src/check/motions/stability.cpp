#include "check/motions/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "assembly/contact/contacts.hpp"
#include "assembly/scatter.hpp"
#include "check/summaries/direction_words.hpp"
#include "linear/scalar_pivots.hpp"
#include "model/contact.hpp"
#include "solvers/path/soft_modes.hpp"

namespace gxrod {

namespace {

constexpr double rounding = 100.0 * std::numeric_limits<double>::epsilon();

// Whether supports leave the node at most one rotation, about an axis that does not turn: then a moment about
// it has a potential.
bool is_hinge(const Model& model, int node) {
    if (model.plane) return true;
    for (const Support& support : model.supports) {
        if (support.node != node) continue;
        return support.holds(3) + support.holds(4) + support.holds(5) >= 2;
    }
    return false;
}

std::string count_pivots(std::int64_t count) {
    return fmt::format("{} negative pivot{}", count, count == 1 ? "" : "s");
}

std::string describe_with_potential(const StabilityChange& change) {
    const std::string between = fmt::format("between t = {:.10g} and {:.10g}", change.from, change.until);
    if (change.after == 0) return between + " the equilibrium became stable again";
    if (change.after < change.before) {
        return fmt::format("{} the equilibrium stayed unstable, with {} instead of {}",
                           between,
                           count_pivots(change.after),
                           change.before);
    }
    return fmt::format(
        "{} the equilibrium became {}unstable (the tangent has {}). The shape that gives way: {}",
        between,
        change.before > 0 ? "more " : "",
        count_pivots(change.after),
        change.shape);
}

std::string describe_without_potential(const StabilityChange& change, bool has_contact) {
    const std::string between = fmt::format("between t = {:.10g} and {:.10g}", change.from, change.until);
    if (change.after == 0) return between + " the determinant of the tangent became positive again";
    return fmt::format(
        "{} the determinant of the tangent became negative: from one of these equilibria the structure "
        "diverges. "
        "The shape: {}{}",
        between,
        change.shape,
        has_contact ? ""
                    : ". Loads that follow the structure may make it flutter as well: a stage of kind "
                      "eigenvalues after this one shows that");
}

}  // namespace

std::string find_load_without_potential(const Model& model) {
    for (const NodalLoad& load : model.loads) {
        if (load.by_motion) return load.key + " depends on its point's motion";
        const bool has_moment = !is_zero(load.moment);
        if (load.frame != Frame::spatial && !(is_zero(load.force) && !has_moment))
            return load.key + " follows its point";
        if (has_moment && !is_hinge(model, load.node))
            return load.key + " is a moment whose axis does not turn with its point";
    }
    for (const DistributedLoad& load : model.distributed_loads) {
        if (load.by_motion) return load.key + " depends on its rod's motion";
        if (load.field) continue;
        if (load.frame != Frame::spatial && !(is_zero(load.force) && is_zero(load.moment)))
            return load.key + " follows its rod";
        if (!is_zero(load.moment)) return load.key + " is a moment whose axis does not turn with its rod";
    }
    const Surroundings& around = model.surroundings;
    if (around.water && around.water->acts() && !around.water->current.is_still())
        return "the current of fluid drags";
    if (around.air && !around.air->wind.is_still()) return "the wind of air drags";
    if (around.seabed && around.seabed->has_friction()) return "seabed rubs";
    if (rubs(model.contact)) return "contact rubs";
    return "";
}

void PivotCounter::compute_tangent(const Integrator& integrator,
                                   const Stage& stage,
                                   SolverWorkspace& workspace,
                                   State& state,
                                   double round_off) {
    // Without them the tangent is the consistent one.
    std::vector<Vec6> resultants;
    resultants.swap(state.resultants);
    integrator.linearize(state, stage, workspace.linearizations, system_->team());
    system_->compute_tangent(state, integrator.stage_time(stage), workspace.linearizations, workspace.values);
    resultants.swap(state.resultants);
    const SparsePattern& pattern = system_->pattern();
    for (std::int64_t i = 0; i < pattern.size(); ++i) {
        double& entry = workspace.values[pattern.slot(i, i)];
        entry += round_off * std::abs(entry);
    }
    if (!workspace.paired) return;
    if (!paired_) paired_ = std::make_unique<PairedMatrix>(*system_, LinearSolverKind::chains);
    const Contacts contacts(*system_);
    paired_->start(contacts.list_groups(state));
    paired_->set_values(workspace.values, contacts.compute_tangents(state, 1.0, workspace.linearizations));
}

std::int64_t PivotCounter::count(const Integrator& integrator,
                                 const Stage& stage,
                                 SolverWorkspace& workspace,
                                 State& state) {
    const PhaseTimer timer(workspace.seconds.solve);
    compute_tangent(integrator, stage, workspace, state, rounding);
    const auto factorize = [&] {
        if (paired_) return paired_->factorize();
        if (workspace.linear_solver->kind() == LinearSolverKind::chains)
            return workspace.linear_solver->factorize(workspace.values);
        if (!chains_)
            chains_ = make_linear_solver(LinearSolverKind::chains, system_->pattern(), system_->team());
        return chains_->factorize(workspace.values);
    };
    // Each multiplier of a joint adds one.
    const std::int64_t multipliers = system_->equations().attached_count();
    const std::int64_t count = factorize().negative_pivots;
    if (count <= multipliers) return count < 0 ? count : 0;
    const std::vector<double>& values = paired_ ? paired_->assemble() : workspace.values;
    const SparsePattern& pattern = paired_ ? paired_->pattern() : system_->pattern();
    const std::int64_t exact = has_potential_ ? count_negative_pivots(pattern, values) : -1;
    const std::int64_t negative = (exact < 0 ? count : exact) - multipliers;
    if (negative <= 0 || multipliers > 0) return std::max<std::int64_t>(negative, 0);
    return negative - count_neutral(pattern, values, workspace.residual, static_cast<int>(negative));
}

// Shapes that resist so little that neither round-off nor what Newton's method leaves out of balance tells
// their sign: a line that can spin about itself, say. If forces r are out of balance, K times a turn of all
// nodes is the turned r instead of zero.
std::int64_t PivotCounter::count_neutral(const SparsePattern& pattern,
                                         const std::vector<double>& values,
                                         const Residual& residual,
                                         int count) const {
    constexpr double safety = 10.0;
    const EquationNumbers& equations = system_->equations();
    const double length = system_->length_scale();
    Eigen::VectorXd weights(pattern.size());
    for (std::int64_t i = 0; i < pattern.size(); ++i)
        weights[i] = equations.unknown(i).component < 3 ? 1.0 / (length * length) : 1.0;
    const std::unique_ptr<LinearSolver> solver = make_general_solver(pattern);
    if (!solver->factorize(values).regular) return count;
    const SoftModes modes = find_soft_modes(*solver, pattern, values, weights, count, has_potential_);
    const Eigen::VectorXd rest = gather(residual.nodal, equations, system_->team());
    const double out_of_balance =
        rest.cwiseQuotient(weights.cwiseSqrt()).norm();  // moments, and forces times length
    std::int64_t neutral = 0;
    for (Eigen::Index k = 0; k < modes.values.size(); ++k) {
        double terms = 0.0;  // what cancels in xᵀ K x
        pattern.visit_entries([&](std::int64_t i, std::int64_t j, std::int64_t slot) {
            terms +=
                std::abs(modes.vectors(i, k) * values[static_cast<std::size_t>(slot)] * modes.vectors(j, k));
        });
        const double unknown = rounding * terms + safety * out_of_balance;
        if (std::abs(modes.values[k]) <= unknown) ++neutral;
    }
    return std::min<std::int64_t>(neutral, count);
}

std::string PivotCounter::describe_shape(const Integrator& integrator,
                                         const Stage& stage,
                                         SolverWorkspace& workspace,
                                         State& state) {
    compute_tangent(integrator, stage, workspace, state, 0.0);
    const std::vector<double>& values = paired_ ? paired_->assemble() : workspace.values;
    const SparsePattern& pattern = paired_ ? paired_->pattern() : system_->pattern();
    const std::optional<Weakness> weakness = describe_weakness(*system_, state, pattern, values);
    return weakness ? weakness->words : "";
}

std::vector<std::string> describe_stability(const std::vector<StabilityChange>& changes,
                                            std::int64_t pivots_at_end,
                                            double end,
                                            bool has_potential,
                                            bool has_contact) {
    constexpr std::size_t most = 6;
    std::vector<std::string> sentences;
    for (std::size_t i = 0; i < std::min(most, changes.size()); ++i) {
        sentences.push_back(has_potential ? describe_with_potential(changes[i])
                                          : describe_without_potential(changes[i], has_contact));
    }
    if (changes.size() > most) {
        sentences.push_back(
            fmt::format("stability changed {} more times (/solver/negative_pivots)", changes.size() - most));
    }
    if (has_potential && pivots_at_end > 0) {
        sentences.push_back(
            fmt::format("the state at t = {:.10g} is unstable ({}): a structure leaves it at a touch. {} "
                        "small side load in "
                        "the shape that gives way shows where it goes; a dynamic analysis how",
                        end,
                        count_pivots(pivots_at_end),
                        has_contact ? "A" : "kind = \"path\" with branches = 1 or a"));
    }
    return sentences;
}

}  // namespace gxrod
