#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "assembly/constraint_request.hpp"
#include "assembly/equation_numbers.hpp"
#include "assembly/residual.hpp"
#include "assembly/scale_groups.hpp"
#include "linear/sparse_pattern.hpp"
#include "state/motion.hpp"
#include "state/state.hpp"
#include "state/values/point_values.hpp"

namespace gxrod {

// The places at which a contribution adds, once equations are numbered. All must outlive it.
struct Layout {
    const EquationNumbers& equations;
    const SparsePattern& pattern;
    const ScaleGroups& groups;
    double length;             // the model's length for scaling
    std::size_t first_memory;  // start of the contribution's slice of State::memory
};

// Anything but elements that pushes the nodes of a system: loads, surroundings, contact, joints. Forces
// belong to the trial motions; tangents are their derivatives by Newton's unknowns.
class Contribution {
  public:
    virtual ~Contribution() = default;

    virtual void lay_out(const Layout& layout) = 0;
    // Subtracts the forces on the nodes from the residual, and raises its scales.
    virtual void subtract_forces(const State& state,
                                 double time,
                                 const ConstraintRequest& request,
                                 Residual& residual) const = 0;
    virtual void add_tangents(const State& state,
                              double time,
                              const ConstraintRequest& request,
                              const std::vector<NodeLinearization>& linearizations,
                              std::vector<double>& values) const = 0;

    // The numbers in State::memory, which only a commit changes, before the trial motions become the last
    // accepted step.
    virtual std::size_t memory_count() const { return 0; }
    virtual void commit(State& /*state*/, double /*time*/) const {}
    // Forgets cached values because a number other than the time has changed on which functions depend.
    virtual void forget() const {}
    // Subtracts the forces along one element of a rod, six per node.
    virtual void subtract_element_forces(const State& /*state*/,
                                         double /*time*/,
                                         const RodPlace& /*place*/,
                                         Eigen::Ref<Eigen::VectorXd> /*forces*/) const {}  // NOLINT: a view
};

}  // namespace gxrod
