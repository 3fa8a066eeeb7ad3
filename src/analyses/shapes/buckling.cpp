#include "analyses/shapes/buckling.hpp"

#include <algorithm>
#include <cmath>

#include "analyses/shapes/shape_measures.hpp"
#include "assembly/scatter.hpp"
#include "check/stability.hpp"
#include "linear/eigen/smallest_factors.hpp"

namespace gxrod {

namespace {

Model make_unloaded(Model model) {
    model.loads.clear();
    model.distributed_loads.clear();
    model.gravity = TimeVector(Vec3::Zero());
    return model;
}

// At rest, as the last accepted step.
State make_still(State state) {
    for (NodeMotion& motion : state.trial) {
        motion.v.setZero();
        motion.a.setZero();
        motion.omega.setZero();
        motion.alpha.setZero();
    }
    state.previous = state.trial;
    state.resultants.clear();
    return state;
}

class FactorFinder {
  public:
    FactorFinder(const System& system, const State& state, double load_time)
        : system_(system),
          state_(make_still(state)),
          time_(state.time),
          load_time_(load_time),
          placements_(state.trial.size(), NodeLinearization{.placement = 1.0}) {}

    BucklingRecord find(const BucklingSettings& settings) {
        record_.load_time = load_time_;
        record_.cause = find_load_without_potential(system_.model());
        record_.is_symmetric = record_.cause.empty();
        if (system_.is_driven() || !system_.model().tendons.empty()) {
            record_.failure =
                "the factor would leave out what tendons and actuations do: raise these in a static stage "
                "with "
                "small steps, whose stability is counted";
            return record_;
        }
        std::vector<double> K = compute_tangent(system_, time_, {});
        if (!solve_for_load(K)) {
            record_.failure = "the state has no unique change under more load: its tangent has no inverse";
            return record_;
        }
        std::vector<double> S = compute_change(K);
        if (!record_.is_symmetric) {
            K = make_symmetric(system_.pattern(), K);
            S = make_symmetric(system_.pattern(), S);
        }
        const SmallestFactors found = find_smallest_factors(
            system_.pattern(), K, S, settings.count, system_.team(), multiplier_count());
        if (!found.is_definite) {
            record_.failure = "the state is unstable as it is: its tangent has negative pivots";
            return record_;
        }
        take_over(found);
        return record_;
    }

  private:
    std::int64_t multiplier_count() const { return system_.equations().attached_count(); }

    std::vector<double> compute_tangent(const System& system,
                                        double time,
                                        const ConstraintRequest& request) const {
        std::vector<double> values;
        system.compute_tangent(state_, time, placements_, values, request);
        return values;
    }

    // Sets what the load at load_time would add to the motions by K, and its own stiffness.
    bool solve_for_load(const std::vector<double>& K) {
        const Model unloaded_model = make_unloaded(system_.model());
        const System unloaded(unloaded_model, system_.team());
        Residual with, without;
        system_.compute_residual(state_, load_time_, with);
        unloaded.compute_residual(state_, load_time_, without);
        for (std::size_t i = 0; i < with.nodal.size(); ++i) without.nodal[i] -= with.nodal[i];
        const ConstraintRequest alike{.scaled_as = &K};
        load_stiffness_ = combine(
            compute_tangent(system_, load_time_, alike), -1.0, compute_tangent(unloaded, load_time_, alike));
        Eigen::VectorXd change = gather(without.nodal, system_.equations(), system_.team());
        const auto solver = make_linear_solver(LinearSolverKind::chains, system_.pattern(), system_.team());
        if (!solver->factorize(K).regular) return false;
        solver->solve(change);
        increments_.resize(state_.trial.size());
        for (std::size_t i = 0; i < increments_.size(); ++i)
            increments_[i] = system_.equations().increment_of(static_cast<int>(i), change);
        State loaded = state_;
        system_.joints().advance_multipliers(increments_, change, K, loaded);
        joints_ = loaded.joints_trial;
        return change.allFinite();
    }

    // K_σ: of the resultants that the increments add, and of the load itself. It is linear in them, and they
    // are taken so large that it does not vanish in the round-off of K.
    std::vector<double> compute_change(const std::vector<double>& K) {
        const std::vector<double> once = compute_change(K, 1.0);
        const double largest = find_largest(once);
        const double factor =
            largest > 0.0 ? std::exp2(std::floor(std::log2(find_largest(K) / largest))) : 1.0;
        std::vector<double> change = compute_change(K, factor);
        for (double& value : change) value /= factor;
        return combine(change, 1.0, load_stiffness_);
    }

    std::vector<double> compute_change(const std::vector<double>& K, double factor) {
        std::vector<Vec6> increments = increments_;
        for (Vec6& increment : increments) increment *= factor;
        system_.start_resultants(state_);
        system_.advance_resultants(increments, state_);
        const std::vector<JointState> unloaded = state_.joints_trial;
        for (std::size_t i = 0; i < joints_.size(); ++i) {
            for (std::size_t row = 0; row < unloaded[i].multipliers.size(); ++row) {
                state_.joints_trial[i].multipliers[row] +=
                    factor * (joints_[i].multipliers[row] - unloaded[i].multipliers[row]);
            }
        }
        std::vector<double> change = combine(compute_tangent(system_, time_, {.scaled_as = &K}), -1.0, K);
        state_.joints_trial = unloaded;
        state_.resultants.clear();
        return change;
    }

    static double find_largest(const std::vector<double>& values) {
        double largest = 0.0;
        for (const double value : values) largest = std::max(largest, std::abs(value));
        return largest;
    }

    void take_over(const SmallestFactors& found) {
        record_.limit = found.limit;
        record_.counted_positive = found.counted_positive;
        record_.counted_negative = found.counted_negative;
        record_.is_complete = found.complete();
        for (Eigen::Index i = 0; i < found.values.size(); ++i) {
            BucklingFactor factor{
                found.values[i], found.residuals[i], make_unit_shape(system_, state_, found.vectors.col(i))};
            (factor.factor > 0.0 ? record_.factors : record_.reversed).push_back(std::move(factor));
        }
    }

    const System& system_;
    State state_;
    double time_, load_time_;
    std::vector<NodeLinearization> placements_;
    std::vector<JointState> joints_;  // under the load that is added
    std::vector<Vec6> increments_;
    std::vector<double> load_stiffness_;
    BucklingRecord record_;
};

}  // namespace

BucklingRecord find_buckling(const System& system,
                             const State& state,
                             double load_time,
                             const BucklingSettings& settings) {
    return FactorFinder(system, state, load_time).find(settings);
}

}  // namespace gxrod
