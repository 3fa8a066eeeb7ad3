#include "analyses/shapes/buckling.hpp"

#include "analyses/shapes/buckling_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "analyses/shapes/shape_measures.hpp"
#include "assembly/scatter.hpp"
#include "assembly/small_motions.hpp"
#include "check/findings/buckling_findings.hpp"
#include "check/motions/stability.hpp"
#include "linear/eigen/eigenvalue_count.hpp"
#include "linear/eigen/smallest_factors.hpp"
#include "solvers/newton_steps.hpp"
#include "solvers/trial_moves.hpp"

namespace gxrod {

namespace {

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

    // `pulls_only`: which tendons go slack where they would push.
    BucklingRecord find(const BucklingSettings& settings, const std::vector<bool>& pulls_only) {
        record_.load_time = load_time_;
        record_.linearization = settings.linearization;
        record_.cause = find_load_without_potential(system_.model());
        record_.is_symmetric = record_.cause.empty();
        record_.failure = find_reason_against_factors(system_.model());
        if (record_.failure.empty() && load_time_ != time_)
            record_.failure = find_moved_obstacle(system_.model());
        if (!record_.failure.empty()) return record_;
        std::vector<double> K = compute_first_tangent();
        record_.failure = solve_for_load(K);
        if (!record_.failure.empty()) return record_;
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
        take_over(found, K);
        if (found.values.size() == 0) count_within_strains(K, S);
        record_.failure = find_pushing_tendon(pulls_only);
        return record_;
    }

  private:
    std::int64_t multiplier_count() const { return system_.equations().attached_count(); }

    // Of a shape without loads before them: those that follow it add to the tangent in proportion, too.
    std::vector<double> compute_first_tangent() const {
        if (load_time_ == time_) return compute_tangent(system_, time_, {});
        const Model unloaded_model = make_unloaded(system_.model());
        const System unloaded(unloaded_model, system_.team(), touching_groups_of(system_));
        return compute_tangent(unloaded, time_, {});
    }

    std::vector<double> compute_tangent(const System& system,
                                        double time,
                                        const ConstraintRequest& request) const {
        std::vector<double> values;
        system.compute_tangent(state_, time, placements_, values, request);
        return values;
    }

    // Sets what is added at load_time to what acts without any load, the motions by K that this adds, and its
    // own stiffness. Why there are none, or "".
    std::string solve_for_load(const std::vector<double>& K) {
        const Model unloaded_model = make_unloaded(system_.model());
        const System unloaded(unloaded_model, system_.team(), touching_groups_of(system_));
        Residual with, without;
        system_.compute_residual(state_, load_time_, with);
        unloaded.compute_residual(state_, load_time_, without);
        Residual added = with;
        for (std::size_t i = 0; i < added.nodal.size(); ++i) added.nodal[i] -= without.nodal[i];
        for (std::size_t i = 0; i < added.rows.size(); ++i) added.rows[i] -= without.rows[i];
        const Eigen::VectorXd rest = gather(without.nodal, system_.equations(), system_.team());
        Eigen::VectorXd change = -gather_residual(system_, added, K);
        if (system_.supports().move())
            change -= compute_move_force(load_time_, with, K) - compute_move_force(0.0, with, K);
        if (change.isZero(0.0)) return "nothing strains the model that a buckling factor could multiply";
        if (load_time_ != time_ && is_out_of_balance(rest, change, K))
            return "the reference shape is not in equilibrium without its loads, by springs that pull, bent "
                   "starts or "
                   "what is around: put a stage of kind static before";
        const auto solver = make_linear_solver(LinearSolverKind::chains, system_.pattern(), system_.team());
        constexpr const char* singular =
            "the state has no unique change under more load: its tangent has no inverse";
        if (!solver->factorize(K).regular) return singular;
        solver->solve(change);
        increments_.resize(state_.trial.size());
        for (std::size_t i = 0; i < increments_.size(); ++i)
            increments_[i] = system_.equations().increment_of(static_cast<int>(i), change);
        if (system_.supports().move()) add_moves();
        State loaded = state_;
        system_.joints().advance_multipliers(increments_, change, K, loaded);
        joints_ = loaded.joints_trial;
        if (!change.allFinite()) return singular;
        find_load_stiffness(unloaded, loaded, K);
        return "";
    }

    // What loads and the tensions after the increments add to the tangent at the unmoved shape.
    void find_load_stiffness(const System& unloaded, const State& loaded, const std::vector<double>& K) {
        const ConstraintRequest alike{.scaled_as = &K};
        const std::vector<double> without = compute_tangent(unloaded, load_time_, alike);
        if (system_.model().tendons.empty()) {
            load_stiffness_ = combine(compute_tangent(system_, load_time_, alike), -1.0, without);
            return;
        }
        const std::vector<Vec6> none(increments_.size(), Vec6::Zero());
        tensions_before_ = compute_tensions(system_, state_, time_, none);
        tensions_ = compute_tensions(system_, loaded, load_time_, increments_);
        const Model pulled_model = set_elastic_tensions(system_, state_, tensions_);
        const System pulled(pulled_model, system_.team(), touching_groups_of(system_));
        load_stiffness_ = combine(compute_tangent(pulled, load_time_, alike), -1.0, without);
    }

    // Linear theory lets tendons push that would go slack before the first factor.
    std::string find_pushing_tendon(const std::vector<bool>& pulls_only) const {
        constexpr double rounding = 1e-9;
        if (record_.factors.empty()) return "";
        for (std::size_t i = 0; i < tensions_.size(); ++i) {
            const double added = tensions_[i] - tensions_before_[i];
            const double tension = tensions_before_[i] + record_.factors.front().factor * added;
            if (!pulls_only[i] || tension >= -rounding * std::abs(record_.factors.front().factor * added))
                continue;
            return fmt::format(
                "tendon.{} goes slack before the first factor, and would push by linear theory: raise the "
                "loads in a stage of kind static with small steps, whose stability is counted",
                system_.model().tendons[i].name);
        }
        return "";
    }

    // What supports that move to where they are at this time do to the residual, to first order.
    Eigen::VectorXd compute_move_force(double time,
                                       const Residual& residual,
                                       const std::vector<double>& K) const {
        constexpr double part = 1e-5;
        const auto one_sided = [&](double side) {
            return compute_support_motion_force(system_, time, load_time_, side, residual, K, state_);
        };
        return 0.5 * (one_sided(part) + one_sided(-part));
    }

    void add_moves() {
        std::vector<Vec6> from(increments_.size(), Vec6::Zero());
        add_support_motion(system_, 0.0, state_, from);
        add_support_motion(system_, load_time_, state_, increments_);
        for (std::size_t i = 0; i < increments_.size(); ++i) increments_[i] -= from[i];
    }

    // Whether forces remain by more than round-off, and than a hardly noticeable part of the load.
    bool is_out_of_balance(const Eigen::VectorXd& rest,
                           const Eigen::VectorXd& load,
                           const std::vector<double>& K) const {
        constexpr double noticeable = 1e-6;
        constexpr double rounding = 100.0 * std::numeric_limits<double>::epsilon();
        const double length = system_.length_scale();
        double largest = 0.0, of_load = 0.0, stiffest = 0.0;
        for (Eigen::Index i = 0; i < rest.size(); ++i) {
            const bool is_force = system_.equations().unknown(i).component < 3;
            const double size = is_force ? 1.0 : length;
            largest = std::max(largest, std::abs(rest[i]) / size);
            of_load = std::max(of_load, std::abs(load[i]) / size);
            stiffest = std::max(stiffest, std::abs(K[system_.pattern().slot(i, i)]) * length / (size * size));
        }
        return largest > std::max(noticeable * of_load, rounding * stiffest);
    }

    // K_σ: of the resultants that the increments add, and of the load itself. It is
    // linear in them, and they are taken so large that it does not vanish in the round-off of K.
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

    // Leaves out shapes that joints hold, where only their equations yield.
    void take_over(const SmallestFactors& found, const std::vector<double>& K) {
        record_.limit = found.limit;
        record_.counted_positive = found.counted_positive;
        record_.counted_negative = found.counted_negative;
        record_.is_complete = found.complete();
        for (Eigen::Index i = 0; i < found.values.size(); ++i) {
            if (measure_gap_share(system_, K, found.vectors.col(i)) > 0.5) continue;
            BucklingFactor factor{
                found.values[i], found.residuals[i], make_unit_shape(system_, state_, found.vectors.col(i))};
            (factor.factor > 0.0 ? record_.factors : record_.reversed).push_back(std::move(factor));
        }
        if (!record_.factors.empty()) estimate_mesh_error(record_.factors.front());
    }

    // Strains of a driven rod do not show how it is pressed.
    static bool is_driven(const Model& model, int rod) {
        const auto is_in = [&](const auto& drive) { return drive.rod == rod; };
        return std::ranges::any_of(model.tendons, is_in) || std::ranges::any_of(model.actuations, is_in);
    }

    // Where no factor was found, counts those up to strains of a tenth, beyond which nothing is linear: a
    // tendon and the rod that follows it cancel but for shear.
    void count_within_strains(const std::vector<double>& K, const std::vector<double>& S) {
        constexpr double large_strain = 0.1;
        double strain = 0.0;
        for (const Rod& rod : system_.model().rods) {
            for (int element = 0; element < rod.element_count(); ++element)
                strain = std::max(strain, std::abs(find_extension(rod, element)));
        }
        if (strain == 0.0) return;
        record_.limit = large_strain / strain;
        EigenvalueCount counter(system_.pattern(), system_.team(), multiplier_count());
        record_.counted_positive = counter.count(K, record_.limit, S);
        record_.counted_negative = counter.count(K, -record_.limit, S);
        record_.is_complete = record_.counted_positive == 0 && record_.counted_negative == 0;
    }

    // By how much the load extends an element, relative, along the line through its ends.
    double find_extension(const Rod& rod, int element) const {
        const std::size_t first = static_cast<std::size_t>(element) * static_cast<std::size_t>(rod.order + 1);
        const auto a = static_cast<std::size_t>(rod.element_nodes[first]);
        const auto b =
            static_cast<std::size_t>(rod.element_nodes[first + static_cast<std::size_t>(rod.order)]);
        const Vec3 chord = state_.trial[b].r - state_.trial[a].r;
        return chord.dot(increments_[b].head<3>() - increments_[a].head<3>()) / chord.squaredNorm();
    }

    // A column of elements of order p, each of the length L and pressed with P, has a factor that is too
    // large by about c x^(2p), x² = P L²/EI. Rods count by their part in the energy of the shape.
    void estimate_mesh_error(const BucklingFactor& found) {
        double largest = 0.0;
        const Model& model = system_.model();
        for (std::size_t r = 0; r < model.rods.size(); ++r) {
            const Rod& rod = model.rods[r];
            if (is_driven(model, static_cast<int>(r))) continue;
            const Mat6& stiffness = model.sections[static_cast<std::size_t>(rod.section)].stiffness;
            double of_rod = 0.0;
            for (const int bending : {4, 5}) {
                const double share = found.shape.energy_shares[r][bending];
                if (share <= 0.0 || stiffness(bending, bending) <= 0.0) continue;
                double worst = 0.0;
                for (int element = 0; element < rod.element_count(); ++element) {
                    const double pressed = find_compression(rod, element, found.factor) * stiffness(0, 0);
                    if (pressed <= 0.0) continue;
                    const double length = find_length(rod, element);
                    const double x = length * std::sqrt(pressed / stiffness(bending, bending));
                    worst = std::max(worst, estimate_column_error(rod.order, x));
                }
                of_rod += share * worst;
            }
            record_.mesh_error += of_rod;
            if (of_rod <= largest) continue;
            largest = of_rod;
            record_.coarse_rod = rod.name;
        }
    }

    // c = 2/(2p + 1) (p!/(2p)!)²: 1/6, 1/360, 1/50400, …
    static double estimate_column_error(int order, double x) {
        double error = 2.0 / (2.0 * order + 1.0);
        for (int i = 1; i <= order; ++i) error *= std::pow(x / (order + i), 2);
        return error;
    }

    static double find_length(const Rod& rod, int element) {
        const std::size_t first = static_cast<std::size_t>(element) * static_cast<std::size_t>(rod.order + 1);
        return rod.arc_length[first + static_cast<std::size_t>(rod.order)] - rod.arc_length[first];
    }

    // By how much an element is shortened under the factor times the load, relative, by the line through its
    // ends.
    double find_compression(const Rod& rod, int element, double factor) const {
        const std::size_t first = static_cast<std::size_t>(element) * static_cast<std::size_t>(rod.order + 1);
        const auto a = static_cast<std::size_t>(rod.element_nodes[first]);
        const auto b =
            static_cast<std::size_t>(rod.element_nodes[first + static_cast<std::size_t>(rod.order)]);
        const std::vector<Node>& nodes = system_.model().nodes;
        const Vec3 chord = state_.trial[b].r - state_.trial[a].r;
        const double before = (nodes[b].position - nodes[a].position).norm();
        const double added = chord.normalized().dot(increments_[b].head<3>() - increments_[a].head<3>());
        return -(chord.norm() - before + factor * added) / before;
    }

    const System& system_;
    State state_;
    double time_, load_time_;
    std::vector<NodeLinearization> placements_;
    std::vector<JointState> joints_;  // under the load that is added
    std::vector<Vec6> increments_;
    std::vector<double> tensions_before_, tensions_;  // of all tendons, before and after the increments
    std::vector<double> load_stiffness_;
    BucklingRecord record_;
};

}  // namespace

BucklingRecord find_buckling(const System& system,
                             const State& state,
                             double load_time,
                             const BucklingSettings& settings) {
    const SmallMotions small(system, settings.linearization);
    const TautSystem taut(small.system(), state, load_time != state.time);
    std::vector<bool> pulls_only;
    for (const Tendon& tendon : system.model().tendons)
        pulls_only.push_back(tendon.winch && tendon.winch->pulls_only);
    return FactorFinder(taut.system(), state, load_time).find(settings, pulls_only);
}

}  // namespace gxrod
