#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "analyses/stepped_analysis.hpp"
#include "model/model.hpp"
#include "sensitivity/state_direction.hpp"

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

// How the accepted states of an analysis change with a number, carried along from step to step (the
// tangent-linear step, docs/theory/sensitivities.md, (G1) to (G4)): each step takes the previous state
// moved by ± step along its derivative through one iteration of Newton's method with the tangent of the
// step, of the models at p ± step.
class ForwardSensitivity {
  public:
    // Throws std::invalid_argument if the models do not fit each other.
    ForwardSensitivity(const Model& base, const VariedModels& models);

    // Of the start of an analysis, with its integrator and first step.
    void start(const Integrator& integrator, const TimeSpan& first_step, LinearSolverKind solver);
    // What the inputs of the model at p are set to.
    void take_inputs(const Model& base);
    // Of a step from one accepted state to the next. The workspace has the step's tangent, factorized.
    void advance(const Integrator& integrator,
                 const Stage& stage,
                 const State& before,
                 const State& after,
                 SolverWorkspace& workspace);

    const StateDirection& direction() const { return direction_; }
    // The derivative of a function of a system and an accepted state of it, by differences along the
    // direction; sides are near up, near down, far up, far down.
    std::vector<double> differentiate_function(
        const State& state,
        const std::function<std::vector<double>(const System&, const State&, std::size_t side)>& function)
        const;

  private:
    struct Side {
        const Model& model;
        System system;
        double amount;  // of p
    };
    // Calls find(side) with each of the two pairs' sides, up and down, and extrapolates their differences.
    template <class Find>
    StateDirection differentiate_by(Find&& find) const;
    State start_one(const System& system,
                    const Integrator& integrator,
                    const TimeSpan& first_step,
                    LinearSolverKind solver) const;
    State advance_one(const System& system,
                      double amount,
                      const Integrator& integrator,
                      const Stage& stage,
                      const State& before,
                      const State& after,
                      SolverWorkspace& workspace) const;

    std::array<Side, 4> sides_;  // near up, near down, far up, far down
    StateDirection direction_;
};

// The sensitivities of an analysis in steps, by several numbers.
class Sensitivities {
  public:
    // Throws std::invalid_argument if the analysis is not one whose steps can be differentiated: along a
    // path, of steady rotation, or by a scheme of several stages.
    Sensitivities(const SteppedAnalysis& analysis,
                  const AnalysisSettings& settings,
                  const std::vector<VariedModels>& models);
    ~Sensitivities();

    void start(const SteppedAnalysis& analysis);
    // Before each step, and after it has been accepted.
    void note_before(const SteppedAnalysis& analysis) { before_ = analysis.state(); }
    void advance(const SteppedAnalysis& analysis);

    const ForwardSensitivity& by(std::size_t number) const { return *all_[number]; }

  private:
    std::unique_ptr<Integrator> integrator_;
    std::unique_ptr<SolverWorkspace> workspace_;
    std::vector<std::unique_ptr<ForwardSensitivity>> all_;
    State before_;
};

}  // namespace gxrod
