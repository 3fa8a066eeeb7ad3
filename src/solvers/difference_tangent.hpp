#pragma once

#include <vector>

#include "assembly/system.hpp"
#include "integrators/integrator.hpp"

namespace gxrod {

// Returns groups of equations whose columns share no row of the pattern, so that one difference of the
// residual gives all of them (Curtis, Powell & Reid 1974).
std::vector<std::vector<std::int64_t>> group_columns(const SparsePattern& pattern);

// Computes the tangent by central differences of the residual, moving the nodes' (δr, δφ) through the
// integrator: values on the pattern, except rows and columns of joints' multipliers. Rods that touch each
// other are not in the pattern: leave contact out by its weight. It is slow: use it to check a tangent, or if
// there is none. Restores the state.
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
