#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "sensitivity/memory/rod_memory.hpp"
#include "sensitivity/tangent_linear_step.hpp"
#include "sensitivity/transposed_products.hpp"
#include "state/motion_gradient.hpp"

namespace gxrod {

// What joints do at the end of a step, transposed: velocities are projected onto their equations, then
// accelerations follow from equilibrium (docs/theory/sensitivities.md, (G17) to (G19)).
class HiddenAdjoint {
  public:
    // All must outlive it. `part` is a step for differences, of a length or in rad.
    HiddenAdjoint(const System& system,
                  const Integrator& integrator,
                  const NewtonSettings& newton,
                  LinearSolverKind linear_solver,
                  double part);

    // Repeats a step from its start, whose trial motions become those of its end; hold_laws() is called when
    // its equilibrium is found. Throws SensitivityError if an equation has no solution.
    void repeat(const Stage& step, State& state, const std::function<void()>& hold_laws);
    // The equilibrium of the step, before velocities are projected, and the values of its tangent.
    const State& equilibrium() const { return equilibrium_; }
    const std::vector<double>& values() const { return values_; }

    // Takes a scalar's gradient by the end of the step, and makes it that by the equilibrium; adds to that by
    // the start of the step. The workspace has the factors of the transposed tangent.
    void transpose(const Stage& step,
                   const State& end,
                   TransposedProducts& products,
                   SolverWorkspace& transposed,
                   MotionGradient& gradient,
                   MotionGradient& before);
    // Adds how its equations, times their multipliers, change with what rods remember from before the step.
    void subtract_by_memory(const Stage& step,
                            const State& end,
                            const RodMemory& memory,
                            MemoryGradient& memory_before,
                            MotionGradient& before) const;
    // Returns the gradient by the multipliers of the equilibrium.
    const RowNumbers& by_multipliers() const { return by_multipliers_; }
    // Moves the equilibrium of a varied system on to the end of its step, to the accuracy of its own
    // supports, and returns what its equations add to what is differentiated, −ξ · R of both.
    double weigh(const Stage& step, const System& system, const State& end, State& state);

  private:
    void transpose_accelerations(const Stage& step,
                                 const State& end,
                                 TransposedProducts& products,
                                 MotionGradient& gradient);
    void transpose_projection(const Stage& step,
                              const State& end,
                              TransposedProducts& products,
                              SolverWorkspace& transposed,
                              MotionGradient& gradient);
    // How ξ · K x̂ changes with the equilibrium.
    void transpose_matrix(const Stage& step,
                          TransposedProducts& products,
                          MotionGradient& gradient,
                          MotionGradient& before);
    void transpose_linearization(const Stage& step,
                                 const std::vector<Vec6>& by_rates,
                                 const std::vector<Vec6>& by_accelerations,
                                 MotionGradient& gradient,
                                 MotionGradient& before) const;
    State move_along(double amount) const;
    // A step along x̂ and ν for differences; 0 if there is no way.
    double find_part() const;
    ConstraintRequest of_velocities(const Stage& step) const;
    static ConstraintRequest of_accelerations(const Stage& step);

    const System& system_;
    const Integrator& integrator_;
    const NewtonSettings& newton_;
    SolverWorkspace forward_;
    SolverWorkspace masses_;  // transposed
    State equilibrium_;
    std::vector<NodeLinearization> linearizations_;  // there
    std::vector<double> values_, mass_values_;
    Eigen::VectorXd projection_;  // x̂ and μ, times the time scale
    std::vector<Vec6> moves_;     // x̂ of each node
    double time_scale_ = 1.0;
    double part_;
    Eigen::VectorXd of_projection_, of_accelerations_;  // multipliers of both
    std::vector<Vec6> xi_;                              // of the projection, of each node
    RowNumbers by_multipliers_;
    Residual residual_;
};

}  // namespace gxrod
