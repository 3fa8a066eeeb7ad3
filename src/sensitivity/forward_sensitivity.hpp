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

// The models for p + step and p − step, p a number of the deck; both have the nodes, elements and equations
// of the model at p.
struct ModelPair {
    const Model& up;
    const Model& down;
    double step;
};

// Model pairs for a step and for twice that step; their differences are extrapolated.
struct VariedModels {
    ModelPair near, far;
};

// Functions of a system, a state and the side, each of which has a value that depends on p.
using Quantities =
    std::function<std::vector<double>(const System& system, const State& state, std::size_t side)>;

// How an analysis starts.
struct StartOfAnalysis {
    const Integrator& integrator;
    TimeSpan first_step;
    LinearSolverKind linear_solver;
    bool projects;  // whether initial velocities are projected onto the joints
    bool settles;   // whether it settles at its start
};

// Starts a system from its trial motions, as an analysis does.
void start_system(const System& system, const StartOfAnalysis& start, State& state, State& ended);
// Sets the trial motions to the last accepted step of an earlier stage, as an analysis that follows it does.
void take_over_stage(const System& system, const State& end, State& state);

// The derivative of an analysis' accepted states by a number p of its deck, and the varied systems by which
// it is found (docs/theory/sensitivities.md).
class ForwardSensitivity {
  public:
    // Throws std::invalid_argument if the models do not fit each other. Contact acts at the stages of the
    // scheme if it resolves it.
    ForwardSensitivity(const System& base, const VariedModels& models, bool resolves_contact = true);

    // Finds the derivative at the start of an analysis.
    void start(const StartOfAnalysis& start);
    // Does the same for a stage that follows another one, which ended in this state with this derivative.
    void start_after(const State& end, const StateDirection& direction, const StartOfAnalysis& start);
    // Moves the varied systems to the reference shapes of their models, and then in all but what supports
    // hold to this state.
    void place_in_reference(const State& state);
    // Takes over the values of the inputs of the model at p, but for those of signals.
    void take_inputs(const Model& base);
    // Moves the varied systems to the states next to this one. sides() lists them: near up, near down, far
    // up, far down; take_sides() takes over the states that they reach.
    void place_sides(const State& before);
    std::array<VariedSystem*, 4> sides();
    void take_sides();
    // Goes back to an earlier derivative, from which a step is found again.
    void return_to(const StateDirection& direction) { direction_ = direction; }
    // There is no derivative from then on, for this reason.
    void end(const std::string& reason) {
        if (kink_.empty()) kink_ = reason;
    }
    const std::string& kink() const { return kink_; }
    // Checks that the varied states lie about this state of the analysis as they do if it depends smoothly on
    // p. If not, there is no derivative from then on. `time_step` is the length of the last step.
    void check_smoothness(const State& centre, double time_step);
    // Moves the varied ends of the step onto the line along their derivative through the analysis' own: a
    // single iteration leaves small strains, which stiff sections multiply.
    void straighten_ends(const State& centre);

    const StateDirection& direction() const { return direction_; }

    // The derivative at an accepted state, to return to that state.
    struct Record {
        StateDirection direction;
        std::array<State, 4> ended;
        std::string kink;
    };
    Record record() const;
    void recall(const Record& record, const Pieces& pieces);

    // Computes the derivatives of quantities of a system with the end of the last step as its trial motions;
    // sides as in sides(). Throws std::runtime_error if there is no derivative.
    std::vector<double> differentiate(const Quantities& quantities) const;

  private:
    std::array<VariedSystem, 4> sides_;
    StateDirection direction_;
    std::string kink_;  // why there is no longer a derivative; "" if there is one
};

}  // namespace gxrod
