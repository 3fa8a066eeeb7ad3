#pragma once

#include <Eigen/Core>
#include <vector>

#include "solvers/equilibrium.hpp"

// Steps in pseudo-time, in which a model falls to a stable equilibrium: drag x′ = −residual(x). It has no
// physical meaning (docs/theory/stability.md).
namespace gxrod {

// The drag on motion in pseudo-time: 1/N on the displacement of each of the model's N nodes, and the square
// of an arm over N on its rotation, the arm a tenth of the length of the node's part. Along rods it also
// resists bending and twist, sharper ones more, so that slack lines swing round before they fold.
class PseudoDrag {
  public:
    // The system must outlive it.
    explicit PseudoDrag(const System& system);

    // Adds the drag on displacements since `from`, times a factor, to the forces on the nodes.
    void add_forces(double factor,
                    const std::vector<NodeMotion>& from,
                    const std::vector<NodeMotion>& motions,
                    std::vector<Vec6>& nodal) const;
    // Makes its symmetric matrix for small motions, times a factor, on the system's pattern.
    std::vector<double> make_matrix(double factor = 1.0) const;

  private:
    struct Pair {
        int first, second;  // neighbours along a rod
        double bending;
    };

    const System* system_;
    double share_;
    std::vector<double> turning_;  // drag on the rotation of each node
    std::vector<Pair> pairs_;
};

// A step of backward Euler's method in pseudo-time: residual(x) + stiffness × drag (x − from) = 0.
class PseudoStep {
  public:
    // The drag must outlive it; the stiffness is one over the length of the step.
    PseudoStep(const PseudoDrag& drag, double stiffness, std::vector<NodeMotion> from)
        : drag_(&drag), stiffness_(stiffness), from_(std::move(from)) {}

    double stiffness() const { return stiffness_; }
    void add_forces(const State& state, Residual& residual) const;
    // Makes the derivative of the forces, for small rotations.
    std::vector<double> make_tangent() const;

  private:
    const PseudoDrag* drag_;
    double stiffness_;
    std::vector<NodeMotion> from_;
};

// Solves such a step in statics by Newton's method, from the trial motions instead of a prediction. Not for
// models with contact.
EquilibriumReport solve_pseudo_step(const SolverSetup& setup,
                                    const Stage& stage,
                                    const PseudoStep& step,
                                    SolverWorkspace& workspace,
                                    State& state);

}  // namespace gxrod
