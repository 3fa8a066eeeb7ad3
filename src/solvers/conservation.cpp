#include "solvers/conservation.hpp"

#include "assembly/system_measures.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <optional>

#include "model/parts.hpp"

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

// With these momenta; of a plane model within its plane.
RigidRates find_rigid_rates(const Model& model, const WholeInertia& inertia, const Momentum& momentum) {
    const Vec3 about_centre = momentum.angular - inertia.centre.cross(momentum.linear);
    const Vec3 velocity = momentum.linear / inertia.mass;
    if (!model.plane)
        return {velocity, inertia.about_centre.partialPivLu().solve(about_centre), inertia.centre};
    const Vec3 n = Vec3::Unit(model.plane->normal);
    return {velocity - n.dot(velocity) * n,
            n.dot(about_centre) / n.dot(inertia.about_centre * n) * n,
            inertia.centre};
}

double find_energy(const WholeInertia& inertia, const RigidRates& rates) {
    return 0.5 *
           (inertia.mass * rates.velocity.squaredNorm() + rates.spin.dot(inertia.about_centre * rates.spin));
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

// Rigid motions that carry the momenta: those found, and those due.
struct RigidMotions {
    RigidRates found{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    RigidRates due = found;
    double energy_due = 0.0;
};

RigidMotions find_rigid_motions(const System& system,
                                const StepStart& start,
                                const Stage& step,
                                const State& state) {
    RigidMotions rigid;
    if (is_held(system.model())) return rigid;
    const Resultant acting = compute_acting(system, state, step.end_time);
    Momentum due = start.momentum;
    due.linear += 0.5 * step.time_step * (start.acting.force + acting.force);
    due.angular += 0.5 * step.time_step * (start.acting.moment + acting.moment);
    const WholeInertia inertia = find_inertia(system, state);
    rigid.found =
        find_rigid_rates(system.model(), inertia, SystemMeasures(system).compute_momentum(state.trial));
    rigid.due = find_rigid_rates(system.model(), inertia, due);
    rigid.energy_due = find_energy(inertia, rigid.due);
    return rigid;
}

}  // namespace

StepStart note_step_start(const System& system, const State& state, double time) {
    return {SystemMeasures(system).compute_momentum(state.trial), compute_acting(system, state, time)};
}

void conserve(const System& system,
              const StepStart& start,
              const Stage& step,
              double surplus,
              State& state,
              EquilibriumReport& report) {
    const Balance end = SystemMeasures(system).compute_balance(state, step.end_time);
    const RigidMotions rigid = find_rigid_motions(system, start, step, state);
    std::vector<NodeMotion> relative = state.trial;
    for (NodeMotion& motion : relative) {
        motion.v -= rigid.found.velocity_at(motion.r);
        motion.omega -= rigid.found.spin;
    }
    const double energy_due = end.kinetic_energy - surplus - rigid.energy_due;
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
        trial.v = rigid.due.velocity_at(trial.r) + *factor * relative[i].v;
        trial.omega = rigid.due.spin + *factor * relative[i].omega;
    }
}

}  // namespace gxrod
