#include "integrators/load_stepping.hpp"

namespace gxrod {

void LoadStepping::begin_stage(State& state, const Stage&) const {
    state.trial = state.previous;
    for (NodeMotion& motion : state.trial) motion.theta.setZero();
}

void LoadStepping::linearize(const State& state,
                             const Stage&,
                             std::vector<NodeLinearization>& linearizations) const {
    NodeLinearization placement;
    placement.placement = 1.0;
    linearizations.assign(state.trial.size(), placement);
}

}  // namespace gxrod
