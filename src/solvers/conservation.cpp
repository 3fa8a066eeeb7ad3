#include "solvers/conservation.hpp"

#include "assembly/system_measures.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
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

// The rigid motions that a model can make wherever it is.
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

// Adds what is held at a node asks of rigid motions (v, ω): that the node, and any place that it can reach,
// does not move along it. `arm`: the node's place from the centre; `axes`: those of the support, in columns.
template <class Holder>
void add_conditions(const Holder& holder, const Vec3& arm, const Mat3& axes, std::vector<Vec6>& rows) {
    const auto add = [&](const Vec3& by_velocity, const Vec3& by_spin) {
        rows.emplace_back((Vec6() << by_velocity, by_spin).finished());
    };
    for (int i = 0; i < 3; ++i) {
        const Vec3 axis = axes.col(i);
        if (holder.holds(3 + i)) add(Vec3::Zero(), axis);
        if (!holder.holds(i)) continue;
        add(axis, arm.cross(axis));
        for (int free = 0; free < 3; ++free) {
            if (!holder.holds(free)) add(Vec3::Zero(), axes.col(free).cross(axis));
        }
    }
}

// docs/theory/newmark.md, (M4).
RigidMotions list_rigid_motions(const Model& model, const State& state) {
    constexpr double round_off = 1e-12;
    RigidMotions motions;
    if (is_joined_to_ground(model)) return motions;
    const auto place_of = [&](const Support& support) {
        return state.trial[static_cast<std::size_t>(support.node)].r;
    };
    if (!model.supports.empty()) {
        motions.centre = place_of(model.supports.front());
    } else {
        for (const NodeMotion& motion : state.trial)
            motions.centre += motion.r / static_cast<double>(state.trial.size());
    }
    std::vector<Vec6> rows;
    for (const Support& support : model.supports)
        add_conditions(support, place_of(support) - motions.centre, support.axes.toRotationMatrix(), rows);
    if (model.plane) add_conditions(*model.plane, Vec3::Zero(), Mat3::Identity(), rows);
    Eigen::MatrixXd kernel = Eigen::MatrixXd::Identity(6, 6);
    if (!rows.empty()) {
        Eigen::MatrixXd conditions(static_cast<Eigen::Index>(rows.size()), 6);
        for (std::size_t i = 0; i < rows.size(); ++i)
            conditions.row(static_cast<Eigen::Index>(i)) = rows[i].transpose();
        Eigen::FullPivLU<Eigen::MatrixXd> factors(conditions);
        factors.setThreshold(round_off);
        if (factors.dimensionOfKernel() == 0) return motions;
        kernel = factors.kernel();
    }
    for (Eigen::Index i = 0; i < kernel.cols(); ++i)
        motions.list.push_back({kernel.col(i).head<3>(), kernel.col(i).tail<3>()});
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
