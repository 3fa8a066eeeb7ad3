#pragma once

#include <span>
#include <vector>

#include "assembly/system.hpp"
#include "integrators/integrator.hpp"
#include "sensitivity/held_friction.hpp"
#include "sensitivity/held_model.hpp"
#include "solvers/equilibrium.hpp"

namespace gxrod {

// A model next to the one that is analysed, for a number of the deck that differs by `amount`, and what of
// its own goes through a step.
struct VariedSystem {
    VariedSystem(const Model& model, double by) : held(model), system(held.model()), amount(by) {}

    HeldModel held;
    System system;
    double amount;
    State state;
    // The end of a step as its trial motions, before they become the last accepted ones: what a run records
    // of a step is computed there, because forces of `simo` elements and of laws depend on where it began.
    State ended;
    std::vector<double> values;  // of its matrix at its trial motions, where joints ask for it
    // What stages begin with, of State.
    std::vector<JointState> joints_before;
    std::vector<double> memory_before;
};

// A step of an analysis once more, together with the same step of varied systems: to each equation that the
// analysis solves they solve theirs by one iteration of Newton's method, from the analysis' solution and with
// its matrix there. What they end with is theirs to first order in what they vary by
// (docs/theory/sensitivities.md, (G1) to (G5)). What has kinks is held on the pieces on which the analysis
// is: where it yields or slips at its limit, it is taken to flow on.
class TangentLinearStep {
  public:
    // What it is given must outlive it.
    TangentLinearStep(const System& base,
                      const Integrator& integrator,
                      const NewtonSettings& newton,
                      LinearSolverKind linear_solver);

    // From one accepted state of the analysis to the next. The states of the varied systems are next to
    // `before`, and become accepted ones next to `after`. Throws std::runtime_error if an equation has no
    // solution.
    void advance(const Stage& first_stage,
                 const State& before,
                 const State& after,
                 std::span<VariedSystem* const> varied);

    // The same where the analysis settles at an instant, after which nothing has a rate.
    void settle(const Stage& stage,
                const State& before,
                const State& after,
                std::span<VariedSystem* const> varied);

    LinearSolverKind linear_solver() const { return workspace_.linear_solver->kind(); }
    // The analysis itself, as it comes out of the same step as the varied systems; and the pieces at its end.
    const VariedSystem& centre() const { return centre_; }
    const Pieces& pieces() const { return pieces_; }

  private:
    // Lets the base find its pieces again; and holds it and the varied systems on those of its trial motions.
    void release();
    void hold(double time, std::span<VariedSystem* const> varied);
    void solve_stage(const Stage& stage, std::span<VariedSystem* const> varied);
    void solve_stage_explicitly(const Stage& stage, std::span<VariedSystem* const> varied);
    // Their matrices are those of the equilibrium.
    void find_accelerations(double time, const TimeSpan& step, std::span<VariedSystem* const> varied);
    void meet_positions(double time, std::span<VariedSystem* const> varied);
    void meet_velocities(double time, const TimeSpan& step, std::span<VariedSystem* const> varied);

    void place_next_to_base(double time, VariedSystem& varied) const;
    // Of one varied system, next to the solution of base_.
    void follow_equilibrium(const Stage& stage, VariedSystem& varied);
    // How often it is solved with the one matrix: with joints also for what their regularization leaves, and
    // for rates of their equations, which the matrix of accelerations leaves out; with laws that yield
    // because their response bends strongly.
    int count_iterations(const ConstraintRequest& request) const;
    void iterate(const System& system, State& state);
    void follow_accelerations(double time, const TimeSpan& step, VariedSystem& varied);
    // Takes `total`, the solution of the base's projection, and corrects it: compute_rows(rows) finds the
    // equations, move(node, increment) moves a node.
    template <class ComputeRows, class Move>
    void follow_projection(const Eigen::VectorXd& total,
                           const VariedSystem& varied,
                           const ComputeRows& compute_rows,
                           const Move& move);
    void compute_matrix(const Stage& stage,
                        const System& system,
                        const State& state,
                        std::vector<double>& values);

    VariedSystem centre_;
    const System& base_system_;
    const Integrator& integrator_;
    const NewtonSettings& newton_;
    SolverWorkspace workspace_;
    bool has_hidden_constraints_;
    bool is_settling_ = false;
    State base_;
    std::vector<JointState> joints_before_;
    std::vector<double> memory_before_;
    Pieces pieces_;
};

}  // namespace gxrod
