#include "solvers/conservation.hpp"

#include "assembly/system_measures.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "model/parts.hpp"

namespace gxrod {

namespace {

// v = velocity + spin × (r − centre), ω = spin.
struct RigidRates {
    Vec3 velocity = Vec3::Zero();
    Vec3 spin = Vec3::Zero();

    double power_of(const Momentum& about_centre) const {
        return velocity.dot(about_centre.linear) + spin.dot(about_centre.angular);
    }
};

// The rigid motions that supports, joints and the plane leave whatever the place of the model: those of a
// model that nothing holds, and the turns of one that a single point holds.
struct RigidMotions {
    Vec3 centre = Vec3::Zero();
    std::vector<RigidRates> list;

    Momentum about_centre(const Momentum& momentum) const {
        return {momentum.linear, momentum.angular - centre.cross(momentum.linear)};
    }
    void set(const RigidRates& rates, std::vector<NodeMotion>& motions) const {
        for (NodeMotion& motion : motions) {
            motion.v = rates.velocity + rates.spin.cross(motion.r - centre);
            motion.omega = rates.spin;
        }
    }
};

bool is_within(const Plane& plane, const RigidRates& rates) {
    for (int i = 0; i < 3; ++i) {
        if (plane.holds(i) && rates.velocity[i] != 0.0) return false;
        if (plane.holds(3 + i) && rates.spin[i] != 0.0) return false;
    }
    return true;
}

RigidMotions list_rigid_motions(const Model& model, const State& state) {
    RigidMotions motions;
    if (!is_held(model)) {
        for (const NodeMotion& motion : state.trial)
            motions.centre += motion.r / static_cast<double>(state.trial.size());
        for (int i = 0; i < 3; ++i) motions.list.push_back({Vec3::Unit(i), Vec3::Zero()});
        for (int i = 0; i < 3; ++i) motions.list.push_back({Vec3::Zero(), Vec3::Unit(i)});
    } else if (model.supports.size() == 1 && model.supports.front().holds_all(0) &&
               std::ranges::none_of(model.joints, &Joint::has_ground) && model.sleeves.empty()) {
        const Support& support = model.supports.front();
        motions.centre = state.trial[static_cast<std::size_t>(support.node)].r;
        for (int i = 0; i < 3; ++i) {
            if (!support.holds(3 + i)) motions.list.push_back({Vec3::Zero(), support.axes * Vec3::Unit(i)});
        }
    }
    if (model.plane)
        std::erase_if(motions.list, [&](const RigidRates& rates) { return !is_within(*model.plane, rates); });
    return motions;
}

// The rigid part of the rates as found, the one that momenta and impulses leave, and the energy of that one.
struct RigidPart {
    RigidRates found, due;
    double energy_due = 0.0;
};

// Of momenta about the centre.
RigidPart find_rigid_part(const System& system,
                          const RigidMotions& motions,
                          const State& state,
                          const Momentum& found,
                          const Momentum& due) {
    RigidPart part;
    const auto count = static_cast<Eigen::Index>(motions.list.size());
    if (count == 0) return part;
    Eigen::MatrixXd inertia(count, count);
    Eigen::VectorXd along_found(count), along_due(count);
    std::vector<NodeMotion> moving = state.trial;
    for (Eigen::Index i = 0; i < count; ++i) {
        const RigidRates& rates = motions.list[static_cast<std::size_t>(i)];
        motions.set(rates, moving);
        const Momentum momentum = motions.about_centre(SystemMeasures(system).compute_momentum(moving));
        for (Eigen::Index j = 0; j < count; ++j)
            inertia(j, i) = motions.list[static_cast<std::size_t>(j)].power_of(momentum);
        along_found[i] = rates.power_of(found);
        along_due[i] = rates.power_of(due);
    }
    const Eigen::LDLT<Eigen::MatrixXd> factors(inertia);
    const auto sum_of = [&](const Eigen::VectorXd& sizes) {
        RigidRates sum;
        for (Eigen::Index i = 0; i < count; ++i) {
            sum.velocity += sizes[i] * motions.list[static_cast<std::size_t>(i)].velocity;
            sum.spin += sizes[i] * motions.list[static_cast<std::size_t>(i)].spin;
        }
        return sum;
    };
    const Eigen::VectorXd sizes = factors.solve(along_due);
    part.found = sum_of(factors.solve(along_found));
    part.due = sum_of(sizes);
    part.energy_due = 0.5 * sizes.dot(along_due);
    return part;
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
    return {SystemMeasures(system).compute_momentum(state.trial), compute_acting(system, state, time)};
}

void conserve(const System& system,
              const StepStart& start,
              const Stage& step,
              double surplus,
              State& state,
              EquilibriumReport& report) {
    const Balance end = SystemMeasures(system).compute_balance(state, step.end_time);
    const RigidMotions motions = list_rigid_motions(system.model(), state);
    RigidPart rigid;
    if (!motions.list.empty()) {
        const Resultant acting = compute_acting(system, state, step.end_time);
        Momentum due = start.momentum;
        due.linear += 0.5 * step.time_step * (start.acting.force + acting.force);
        due.angular += 0.5 * step.time_step * (start.acting.moment + acting.moment);
        rigid = find_rigid_part(
            system, motions, state, motions.about_centre(end.momentum), motions.about_centre(due));
    }
    std::vector<NodeMotion> found = state.trial, due = state.trial, relative = state.trial;
    motions.set(rigid.found, found);
    motions.set(rigid.due, due);
    for (std::size_t i = 0; i < relative.size(); ++i) {
        relative[i].v -= found[i].v;
        relative[i].omega -= found[i].omega;
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
        state.trial[i].v = due[i].v + *factor * relative[i].v;
        state.trial[i].omega = due[i].omega + *factor * relative[i].omega;
    }
}

}  // namespace gxrod
