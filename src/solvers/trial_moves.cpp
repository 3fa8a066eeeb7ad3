#include "solvers/trial_moves.hpp"

#include "assembly/contact/contacts.hpp"
#include "rotation/rotation_map.hpp"
#include "solvers/newton_steps.hpp"
#include "state/increment.hpp"

namespace gxrod {

namespace {

Vec3 find_spin(const NodeMotion& from, const NodeMotion& to) {
    return log_nearest(to.Lambda * from.Lambda.conjugate(), to.theta - from.theta);
}

// So much of the way from one motion to another, rates too.
void go_towards(const NodeMotion& from,
                const NodeMotion& to,
                const NodeMotion& previous,
                double part,
                NodeMotion& motion) {
    apply_spin(previous, part * (to.r - from.r), part * find_spin(from, to), motion);
    motion.v += part * (to.v - from.v);
    motion.a += part * (to.a - from.a);
    motion.omega += part * (to.omega - from.omega);
    motion.alpha += part * (to.alpha - from.alpha);
}

}  // namespace

void add_support_motion(const System& system, double time, State& state, std::vector<Vec6>& deltas) {
    std::vector<NodeMotion> before;
    for (const Support* support : system.supports().moving()) before.push_back(state.trial[support->node]);
    system.supports().place(time, state);
    auto kept = before.begin();
    for (const Support* support : system.supports().moving()) {
        NodeMotion& trial = state.trial[support->node];
        deltas[support->node].head<3>() += trial.r - kept->r;
        deltas[support->node].tail<3>() += find_spin(*kept, trial);
        trial = *kept++;
    }
}

Eigen::VectorXd compute_support_motion_force(const System& system,
                                             double time,
                                             double time_of_loads,
                                             double part,
                                             const Residual& residual,
                                             const std::vector<double>& values,
                                             const State& state) {
    State moved = state;
    system.supports().place(time, moved);
    State nudged = state;
    for (const Support* support : system.supports().moving()) {
        const auto node = static_cast<std::size_t>(support->node);
        go_towards(state.trial[node], moved.trial[node], state.previous[node], part, nudged.trial[node]);
    }
    Residual other;
    if (!Contacts(system).are_possible()) {
        system.compute_residual(nudged, time_of_loads, other);
        return (gather_residual(system, other, values) - gather_residual(system, residual, values)) / part;
    }
    ConstraintRequest request;
    request.contact_weight = 0.0;
    Residual here;
    system.compute_residual(state, time_of_loads, here, request);
    system.compute_residual(nudged, time_of_loads, other, request);
    return (gather_residual(system, other, values) - gather_residual(system, here, values)) / part;
}

}  // namespace gxrod
