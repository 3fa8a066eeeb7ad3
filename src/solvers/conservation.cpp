#include "solvers/conservation.hpp"

#include "assembly/system_measures.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <optional>

namespace gxrod {

namespace {

// Of the model as it stands, as if it were rigid.
struct WholeInertia {
    double mass;
    Vec3 centre;
    Mat3 about_centre;
};

// v = velocity + spin × (r − centre), ω = spin.
struct RigidRates {
    Vec3 velocity;
    Vec3 spin;
    Vec3 centre;

    Vec3 velocity_at(const Vec3& r) const { return velocity + spin.cross(r - centre); }
};

WholeInertia find_inertia(const System& system, const State& state) {
    std::vector<NodeMotion> motions = state.trial;
    const auto momentum_of = [&](const RigidRates& rates) {
        for (NodeMotion& motion : motions) {
            motion.v = rates.velocity_at(motion.r);
            motion.omega = rates.spin;
        }
        return SystemMeasures(system).compute_momentum(motions);
    };
    const Momentum along_x = momentum_of({Vec3::UnitX(), Vec3::Zero(), Vec3::Zero()});
    const Momentum along_y = momentum_of({Vec3::UnitY(), Vec3::Zero(), Vec3::Zero()});
    WholeInertia inertia{};
    inertia.mass = along_x.linear.x();
    inertia.centre = Vec3(along_y.angular.z(), -along_x.angular.z(), along_x.angular.y()) / inertia.mass;
    for (int i = 0; i < 3; ++i) {
        const Momentum about = momentum_of({Vec3::Zero(), Vec3::Unit(i), inertia.centre});
        inertia.about_centre.col(i) = about.angular - inertia.centre.cross(about.linear);
    }
    return inertia;
}

RigidRates find_rigid_rates(const WholeInertia& inertia, const Momentum& momentum) {
    const Vec3 about_centre = momentum.angular - inertia.centre.cross(momentum.linear);
    return {momentum.linear / inertia.mass,
            inertia.about_centre.partialPivLu().solve(about_centre),
            inertia.centre};
}

double find_energy(const WholeInertia& inertia, const RigidRates& rates) {
    return 0.5 *
           (inertia.mass * rates.velocity.squaredNorm() + rates.spin.dot(inertia.about_centre * rates.spin));
}

// The mean of the forces at both ends of the step times what nodes did in it, as the ledger has it.
double compute_work(const std::vector<Vec6>& before, const std::vector<Vec6>& after, const State& state) {
    double work = 0.0;
    for (std::size_t i = 0; i < after.size(); ++i) {
        const Vec6 mean = 0.5 * (before[i] + after[i]);
        work += mean.head<3>().dot(state.trial[i].r - state.previous[i].r) +
                mean.tail<3>().dot(state.trial[i].theta);
    }
    return work;
}

// The factor that takes a kinetic energy to the one that is due, a difference of energies as large as `size`.
std::optional<double> find_factor(double energy, double due, double size) {
    constexpr double round_off = 64.0 * std::numeric_limits<double>::epsilon();
    constexpr double most = 4.0;
    if (energy <= round_off * size) {
        if (std::abs(due - energy) <= round_off * size) return 1.0;
        return std::nullopt;
    }
    const double square = due / energy;
    if (!(square >= 1.0 / most && square <= most)) return std::nullopt;
    return std::sqrt(square);
}

Resultant compute_acting(const System& system, const State& state, double time) {
    const std::vector<Vec6> no_reactions(state.trial.size(), Vec6::Zero());
    return SystemMeasures(system).compute_outer_resultant(state, time, no_reactions);
}

}  // namespace

StepStart note_step_start(const System& system, const State& state, double time) {
    const Balance balance = SystemMeasures(system).compute_balance(state, time);
    return {balance.kinetic_energy + balance.strain_energy + balance.gravity_potential,
            balance.momentum,
            compute_acting(system, state, time),
            SystemMeasures(system).compute_load_forces(state, time)};
}

void conserve(const System& system,
              const StepStart& start,
              const Stage& step,
              State& state,
              EquilibriumReport& report) {
    const Balance end = SystemMeasures(system).compute_balance(state, step.end_time);
    const Resultant acting = compute_acting(system, state, step.end_time);
    Momentum due = start.momentum;
    due.linear += 0.5 * step.time_step * (start.acting.force + acting.force);
    due.angular += 0.5 * step.time_step * (start.acting.moment + acting.moment);
    const WholeInertia inertia = find_inertia(system, state);
    const RigidRates found = find_rigid_rates(inertia, end.momentum);
    const RigidRates rigid = find_rigid_rates(inertia, due);

    std::vector<NodeMotion> relative = state.trial;
    for (NodeMotion& motion : relative) {
        motion.v -= found.velocity_at(motion.r);
        motion.omega -= found.spin;
    }
    const double work =
        compute_work(start.forces, SystemMeasures(system).compute_load_forces(state, step.end_time), state);
    const double energy_due =
        start.energy + work - end.strain_energy - end.gravity_potential - find_energy(inertia, rigid);
    const double size = end.kinetic_energy + std::abs(end.strain_energy) + std::abs(end.gravity_potential);
    const std::optional<double> factor =
        find_factor(SystemMeasures(system).compute_kinetic_energy(relative), energy_due, size);
    if (!factor) {
        report.outcome = Outcome::energy_out_of_reach;
        report.worst_node = -1;
        return;
    }
    for (std::size_t i = 0; i < relative.size(); ++i) {
        NodeMotion& trial = state.trial[i];
        trial.v = rigid.velocity_at(trial.r) + *factor * relative[i].v;
        trial.omega = rigid.spin + *factor * relative[i].omega;
    }
}

}  // namespace gxrod
