#include "assembly/state_matrices.hpp"

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
    const auto compute = [&](const NodeLinearization& ask, std::vector<double>& values) {
        system.compute_tangent(state, time, std::vector<NodeLinearization>(state.trial.size(), ask), values);
    };
    StateMatrices matrices;
    compute(ask_stiffness(), matrices.stiffness);
    compute(ask_damping(), matrices.damping);
    compute(ask_mass(), matrices.mass);
    return matrices;
}

}  // namespace gxrod
