#pragma once

#include <Eigen/Core>
#include <vector>

#include "solvers/equilibrium.hpp"

// Pseudo-time, in which a model falls to a stable equilibrium: drag x′ = −residual(x). It has no physical
// meaning (docs/theory/stability.md).
namespace gxrod {

// What resists motion in pseudo-time: each node's displacement by 1/N of the model's N nodes, and its
// rotation by the square of an arm over N, the arm a tenth of the length of the node's part. Along rods
// bending and twist are resisted too, the more the sharper, so that slack lines swing round before they fold.
class PseudoDrag {
  public:
    // The system must outlive it.
    explicit PseudoDrag(const System& system);

    // The drag on displacements since `from`, times a factor, is added to the forces on the nodes.
    void add_forces(double factor,
                    const std::vector<NodeMotion>& from,
                    const std::vector<NodeMotion>& motions,
                    std::vector<Vec6>& nodal) const;
    // Its matrix for small motions, symmetric, times a factor, on the system's pattern.
    std::vector<double> make_matrix(double factor = 1.0) const;

  private:
    struct Pair {
        int first, second;  // next to each other along a rod
        double bending;
    };

    const System* system_;
    double share_;
    std::vector<double> turning_;  // of each node
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
    // The derivative of the forces, for small rotations.
    std::vector<double> make_tangent() const;

  private:
    const PseudoDrag* drag_;
    double stiffness_;
    std::vector<NodeMotion> from_;
};

// Newton's method on such a step in statics, from the trial motions instead of a prediction. Models with
// contact have none.
EquilibriumReport solve_pseudo_step(const System& system,
                                    const Integrator& integrator,
                                    const NewtonSettings& settings,
                                    const Stage& stage,
                                    const PseudoStep& step,
                                    SolverWorkspace& workspace,
                                    State& state);

}  // namespace gxrod
