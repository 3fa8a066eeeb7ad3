#pragma once

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "sensitivity/state_direction.hpp"
#include "sensitivity/tangent_linear_step.hpp"

namespace gxrod {

// A model for two values of a number p of its deck, p + step and p − step; both have the nodes, elements and
// equations of the model at p.
struct ModelPair {
    const Model& up;
    const Model& down;
    double step;
};

// Of a step and of twice that step, whose differences are extrapolated.
struct VariedModels {
    ModelPair near, far;
};

// A number that depends on p at a state.
using Quantities =
    std::function<std::vector<double>(const System& system, const State& state, std::size_t side)>;

// How the accepted states of an analysis change with a number p of its deck: the derivative of the state, and
// the systems next to the analysis' own by which it is found (docs/theory/sensitivities.md).
class ForwardSensitivity {
  public:
    // Throws std::invalid_argument if the models do not fit each other.
    ForwardSensitivity(const System& base, const VariedModels& models);

    // Of the start of an analysis with this integrator; with initial velocities that joints allow, if it
    // projects them.
    void start(const Integrator& integrator,
               const TimeSpan& first_step,
               LinearSolverKind solver,
               bool projects_start);
    // What the inputs of the model at p are set to.
    void take_inputs(const Model& base);
    // Gives the varied systems the states next to this one, and lists them: near up, near down, far up, far
    // down. Afterwards takes what their states have become.
    void place_sides(const State& before);
    std::array<VariedSystem*, 4> sides();
    void take_sides();

    const StateDirection& direction() const { return direction_; }
    void set_direction(StateDirection direction) { direction_ = std::move(direction); }

    // The derivative of quantities of a system and an accepted state of it; sides as of sides().
    std::vector<double> differentiate(const State& state, const Quantities& quantities) const;

  private:
    State start_one(const VariedSystem& side,
                    const Integrator& integrator,
                    const TimeSpan& first_step,
                    LinearSolverKind solver,
                    bool projects_start) const;

    std::array<VariedSystem, 4> sides_;
    StateDirection direction_;
};

}  // namespace gxrod
