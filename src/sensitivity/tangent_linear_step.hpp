#pragma once

#include <span>
#include <vector>

#include "assembly/contact/contacts.hpp"
#include "assembly/system.hpp"
#include "integrators/integrator.hpp"
#include "sensitivity/held_friction.hpp"
#include "sensitivity/held_model.hpp"
#include "sensitivity/held_stops.hpp"
#include "solvers/coupled/exact_matrix.hpp"
#include "solvers/equilibrium.hpp"

namespace gxrod {

// A model that differs from the analysed one by `amount` in a number of the deck, and its state within a
// step.
struct VariedSystem {
    VariedSystem(const Model& model, double by) : held(model), system(held.model()), amount(by) {}

    HeldModel held;
    System system;
    double amount;
    State state;
    // The end of a step as its trial motions, before they are accepted. Recorded quantities of a step are
    // computed there, because forces of `simo` elements and of laws depend on the start of the step.
    State ended;
    std::vector<double> values;  // its matrix at its trial motions, if joints need it
    // Joints and law memory of State at the start of stages.
    std::vector<double> memory_before;
};

// Returns the part of the matrix with these values, times a vector, that is the regularization of joints: the
// equations of joints themselves are without it.
Eigen::VectorXd take_regularization(const System& system,
                                    const std::vector<double>& values,
                                    const Eigen::VectorXd& vector);

// Sets the trial motions of a varied system to those of the base at `time`, but for what its supports hold.
void place_next_to(const State& base, double time, VariedSystem& varied);

// The pieces of laws that the analysis is on in a stage, and what of its friction slips.
struct HeldStage {
    Pieces pieces;
    HeldFriction friction;
};

// Repeats a step of an analysis together with the same step of varied systems. For each equation that the
// analysis solves, they solve their own by one Newton iteration from the analysis' solution with its matrix
// there. Their end states are right to first order in the variation (docs/theory/sensitivities.md, (G1) to
// (G5)). Laws with kinks are held on the pieces that the analysis uses: if they yield or slip at their limit,
// they are taken to flow on.
class TangentLinearStep {
  public:
    // The arguments must outlive it.
    TangentLinearStep(const System& base,
                      const Integrator& integrator,
                      const NewtonSettings& newton,
                      LinearSolverKind linear_solver);

    // Advances from one accepted state of the analysis to the next. The states of the varied systems lie next
    // to `before` and become accepted states next to `after`. Throws std::runtime_error if an equation has no
    // solution.
    void advance(const Stage& first_stage,
                 const State& before,
                 const State& after,
                 std::span<VariedSystem* const> varied);

    // Advances likewise where the analysis settles at an instant, after which nothing has a rate.
    void settle(const Stage& stage,
                const State& before,
                const State& after,
                std::span<VariedSystem* const> varied);

    // Whether the step repeated here ended with these velocities. If not, energy was taken from them when it
    // was accepted.
    bool has_reproduced(const State& after) const;

    LinearSolverKind linear_solver() const { return workspace_.linear_solver->kind(); }
    // Return the analysis itself after the same step as the varied systems, and the pieces of its laws at the
    // end.
    const VariedSystem& centre() const { return centre_; }
    const Pieces& pieces() const { return pieces_; }

  private:
    // Let the base find its pieces again, and hold it and the varied systems on the pieces at its trial
    // motions.
    void release();
    void hold(double time, std::span<VariedSystem* const> varied);
    // Returns what holds the base at its trial motions, and lets it hold a system of the same parts.
    HeldStage find_held(double time);
    void hold(const HeldStage& held, const std::vector<double>& memory, HeldModel& model, State& state) const;
    // Lets the same ropes and stops hold as in the base's trial state. Throws KinkError if these change in a
    // motion, or if one is at its limit without a force.
    void hold_stops(std::span<VariedSystem* const> varied);
    // Throws KinkError if others hold than at the start of the step of a motion.
    void check_stops(const std::vector<JointState>& now) const;
    void solve_stage(const Stage& stage, std::span<VariedSystem* const> varied);
    void solve_stage_explicitly(const Stage& stage, std::span<VariedSystem* const> varied);
    // Solves all stages of a step that are found together.
    void solve_together(const CoupledStages& scheme,
                        const Stage& step,
                        std::span<VariedSystem* const> varied);
    void follow_stages(const StagesOfStep& base, VariedSystem& varied);
    void hold_stages(StagesOfStep& stages);
    // Finds accelerations without contact after a step with impulses.
    void split_contact(const Stage& stage, std::span<VariedSystem* const> varied);
    void commit(const State& after, std::span<VariedSystem* const> varied);
    // Takes the base as it is found, with the pairs of pieces that are near, as the place of tangents.
    void place_contact(double time);
    // Finds accelerations; the varied systems have the matrices of the equilibrium.
    void find_accelerations(double time, const TimeSpan& step, std::span<VariedSystem* const> varied);
    void meet_positions(double time, std::span<VariedSystem* const> varied);
    void meet_velocities(double time, const TimeSpan& step, std::span<VariedSystem* const> varied);

    // Solves the equilibrium of one varied system from the solution of base_.
    void follow_equilibrium(const Stage& stage, VariedSystem& varied);
    // Whether one solution with the matrix is enough, refined where joints are regularized: it is linear in
    // the residual, and no gap of contact closes. Others take more, for rates of the equations of joints,
    // which the matrix of accelerations leaves out, and for laws that yield because their response is
    // strongly curved.
    bool is_linear(const ConstraintRequest& request) const;
    void iterate(const System& system, State& state, bool refines);
    // Moves rates with the increments of an iteration, to first order. Rates from positions would have the
    // rounding of these over Δt², and stages pass it on.
    void advance_rates(const Stage& stage, const System& system, State& state) const;
    bool advances_rates() const;
    void advance_stage_rates(const std::vector<std::vector<Vec6>>& increments, State& state) const;
    ConstraintRequest request_accelerations(const TimeSpan& step) const;
    void follow_accelerations(double time, const TimeSpan& step, VariedSystem& varied);
    // Applies `total`, the solution of the base's projection, and corrects it: compute_rows(rows) finds the
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
    Contacts contacts_;
    SolverWorkspace workspace_;
    bool has_hidden_constraints_;
    HeldStops stops_;
    StopChoice stop_choice_;                         // of equations by which the varied systems are found
    std::vector<NodeLinearization> linearizations_;  // of the base at the present stage
    // The linearizations of stage j by stage k, one row after the other.
    std::vector<std::vector<NodeLinearization>> stage_linearizations_;
    std::unique_ptr<ExactMatrix> exact_;                         // of stages that are found together
    std::vector<HeldStage> held_stages_;                         // of these stages
    std::vector<ContactTrial> base_contacts_, varied_contacts_;  // of these stages
    bool is_settling_ = false;
    State base_;
    std::vector<double> memory_before_;
    Pieces pieces_;
};

}  // namespace gxrod
