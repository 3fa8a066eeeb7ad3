#include "integrators/load_stepping.hpp"

#include <algorithm>

namespace gxrod {

void LoadStepping::place_nodes(State& state, const Stage&, NodeRange nodes) const {
    for (std::size_t i = nodes.first; i < nodes.last; ++i) {
        state.trial[i] = state.previous[i];
        state.trial[i].theta.setZero();
    }
}

void LoadStepping::linearize_nodes(const State&,
                                   const Stage&,
                                   NodeRange nodes,
                                   std::vector<NodeLinearization>& linearizations) const {
    NodeLinearization placement;
    placement.placement = 1.0;
    std::fill(linearizations.begin() + nodes.first, linearizations.begin() + nodes.last, placement);
}

}  // namespace gxrod
