#pragma once

#include <limits>

#include "assembly/system.hpp"
#include "solvers/equilibrium.hpp"

namespace gxrod {

// Decides when Newton's method stops (see solve_equilibrium), from each residual and each increment.
class ConvergenceTest {
  public:
    // Takes the level of the equations of joints. The system must outlive it.
    ConvergenceTest(const System& system,
                    const NewtonSettings& settings,
                    ConstraintLevel level = ConstraintLevel::position);

    // Sets the report's residual. Call it before the report's gap of joints is set.
    void measure(const Residual& residual, EquilibriumReport& report);
    // Notes the larger of |δr| relative to its scale and |δφ| of all nodes.
    void add_increment(const std::vector<Vec6>& deltas, const State& state);
    double last_increment() const { return last_increment_; }
    // Returns whether the residual last measured is small, or as small as round-off allows.
    bool is_met(const Residual& residual, const EquilibriumReport& report) const;

  private:
    bool are_closed(const EquilibriumReport& report) const;
    bool has_reached_round_off(const Residual& residual, const EquilibriumReport& report) const;

    const System* system_;
    double tolerance_;
    double absolute_residual_;
    bool of_accelerations_;
    double first_gap_ = 0.0;                                       // before the first increment
    double gap_before_ = std::numeric_limits<double>::infinity();  // gap of the previous iteration
    // Increments of the last two iterations.
    double last_increment_ = std::numeric_limits<double>::infinity();
    double increment_before_ = std::numeric_limits<double>::infinity();
    double residual_before_ = std::numeric_limits<double>::infinity();  // residual of the last iteration
};

}  // namespace gxrod
