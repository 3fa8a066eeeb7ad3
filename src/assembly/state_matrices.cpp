#include "assembly/state_matrices.hpp"

#include "assembly/small_motions.hpp"
#include "linear/eigen/pencil.hpp"

namespace gxrod {

namespace {

NodeLinearization ask_stiffness() { return {.placement = 1.0}; }
NodeLinearization ask_damping() { return {.rate = 1.0, .d_omega = Mat3::Identity()}; }
NodeLinearization ask_mass() { return {.acceleration = 1.0, .d_alpha = Mat3::Identity()}; }

}  // namespace

StateMatrices compute_state_matrices(const System& system, const State& state, double time) {
    if (!state.resultants.empty()) {
        // With them the tangent would be the mixed one.
        State bare = state;
        bare.resultants.clear();
        return compute_state_matrices(system, bare, time);
    }
    const SmallMotions small(system);
    const auto compute = [&](const NodeLinearization& ask, std::vector<double>& values) {
        small.system().compute_tangent(
            state, time, std::vector<NodeLinearization>(state.trial.size(), ask), values);
    };
    StateMatrices matrices;
    compute(ask_stiffness(), matrices.stiffness);
    compute(ask_damping(), matrices.damping);
    compute(ask_mass(), matrices.mass);
    matrices.relaxing = small.compute_relaxing(state, time);
    return matrices;
}

std::vector<double> StateMatrices::instantaneous_stiffness() const {
    std::vector<double> sum = stiffness;
    for (const RelaxingMatrix& one : relaxing) sum = combine(sum, 1.0, one.values);
    return sum;
}

}  // namespace gxrod
