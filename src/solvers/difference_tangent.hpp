#pragma once

#include <vector>

#include "assembly/system.hpp"
#include "integrators/integrator.hpp"

namespace gxrod {

// Groups of equations whose columns share no row of the pattern, so that one difference of the residual gives
// all of them (Curtis, Powell & Reid 1974).
std::vector<std::vector<std::int64_t>> group_columns(const SparsePattern& pattern);

// The tangent by central differences of the residual, moving the nodes' (δr, δφ) through the integrator;
// values on the pattern; but for the rows and columns of joints' multipliers. Slow: for checking a tangent,
// or without one. Restores the state.
class DifferenceTangent {
  public:
    explicit DifferenceTangent(const System& system);

    void compute(const Integrator& integrator,
                 const Stage& stage,
                 State& state,
                 std::vector<double>& values,
                 const ConstraintRequest& request = {});

  private:
    const System* system_;
    std::vector<std::vector<std::int64_t>> groups_;
    Residual forward_, backward_;
};

}  // namespace gxrod
