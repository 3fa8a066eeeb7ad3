#include "solvers/trial_moves.hpp"

#include "solvers/newton_steps.hpp"
#include "state/increment.hpp"

namespace gxrod {

void add_support_motion(const System& system, double time, State& state, std::vector<Vec6>& deltas) {
    std::vector<NodeMotion> before;
    for (const Support* support : system.supports().moving()) before.push_back(state.trial[support->node]);
    system.supports().place(time, state);
    auto kept = before.begin();
    for (const Support* support : system.supports().moving()) {
        NodeMotion& trial = state.trial[support->node];
        deltas[support->node].head<3>() += trial.r - kept->r;
        deltas[support->node].tail<3>() += trial.theta - kept->theta;
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
        const NodeMotion& from = state.trial[support->node];
        const NodeMotion& to = moved.trial[support->node];
        apply_spin(from, part * (to.r - from.r), part * (to.theta - from.theta), nudged.trial[support->node]);
    }
    Residual other;
    if (!system.contact()) {
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
