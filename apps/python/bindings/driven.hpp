#pragma once

#include <string>
#include <utility>
#include <vector>

#include "face/simulation.hpp"
#include "model.hpp"
#include "state_views.hpp"

namespace gxrod::python {

// A simulation, and the arrays that follow it.
struct Driven : Simulation {
    using Simulation::Simulation;

    // Steps, and lets the arrays follow, also if a step fails.
    template <class Steps>
    auto follow(const Steps& take) {
        const struct Follow {
            Driven& driven;
            ~Follow() { driven.views.follow(driven.nodes()); }
        } follow{*this};
        return take();
    }

    StateViews views;
};

}  // namespace gxrod::python
