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
               bool projects_start,
               bool settles);
    // What the inputs of the model at p are set to.
    void take_inputs(const Model& base);
    // Gives the varied systems the states next to this one, and lists them: near up, near down, far up, far
    // down. Afterwards takes what their states have become.
    void place_sides(const State& before);
    std::array<VariedSystem*, 4> sides();
    void take_sides();
    // Finds out whether their states are next to this one of the analysis as they are if it depends smoothly
    // on the number. Otherwise there is no derivative from then on. `time_step`: of the step they have taken.
    void check_smoothness(const State& centre, double time_step);
    // Places the ends of the step next to that of the analysis along their derivative: a single iteration
    // leaves small strains, which stiff sections multiply.
    void straighten_ends(const State& centre);

    const StateDirection& direction() const { return direction_; }

    // What is known of an accepted state, to return to with it.
    struct Record {
        StateDirection direction;
        std::array<State, 4> ended;
        std::string kink;
    };
    Record record() const;
    void recall(const Record& record, const Pieces& pieces);

    // The derivative of quantities of a system and the end of the last step as its trial motions; sides as of
    // sides(). Throws std::runtime_error where there is none.
    std::vector<double> differentiate(const Quantities& quantities) const;

  private:
    static void start_one(VariedSystem& side,
                          const Integrator& integrator,
                          const TimeSpan& first_step,
                          LinearSolverKind solver,
                          bool projects_start,
                          bool settles);

    std::array<VariedSystem, 4> sides_;
    StateDirection direction_;
    std::string kink_;  // why there is no derivative any more; "" where there is
};

}  // namespace gxrod
