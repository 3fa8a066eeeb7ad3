#include "integrators/quasi_static.hpp"

namespace gxrod {

void QuasiStatic::update_nodes(State& state, const Stage& stage, NodeRange nodes) const {
    Sdirk4::update_nodes(state, stage, nodes);
    for (std::size_t i = nodes.first; i < nodes.last; ++i) {
        state.trial[i].a.setZero();
        state.trial[i].alpha.setZero();
    }
}

void QuasiStatic::linearize_nodes(const State& state,
                                  const Stage& stage,
                                  NodeRange nodes,
                                  std::vector<NodeLinearization>& linearizations) const {
    Sdirk4::linearize_nodes(state, stage, nodes, linearizations);
    for (std::size_t i = nodes.first; i < nodes.last; ++i) {
        linearizations[i].acceleration = 0.0;
        linearizations[i].d_alpha.setZero();
    }
}

}  // namespace gxrod
