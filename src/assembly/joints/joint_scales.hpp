#pragma once

#include <vector>

namespace gxrod {

// D for the equations of one joint, docs/theory/joints.md (J19): for rows that are lengths, and for others.
struct JointScales {
    double length = 0.0;
    double turn = 0.0;

    double of(bool is_length) const { return is_length ? length : turn; }
};

namespace joint_scaling {

// Relative size of the entries on the diagonal, which make redundant equations solvable.
constexpr double regularization = 1e-8;
// D for rows of accelerations, relative to rows of positions. Redundant rows contradict each other in the
// inner stages of a step; with a smaller D, their multipliers grow less.
constexpr double acceleration_scale = 1e-2;

}  // namespace joint_scaling

// The mean size of entries on a tangent's diagonal, for displacements and for rotations.
class DiagonalMean {
  public:
    void add(int component, double value);
    JointScales mean() const;

  private:
    double sums_[2] = {0.0, 0.0};
    int counts_[2] = {0, 0};
};

// Raises all scales to at least a part of the largest; `length` is the model's length.
void bound_scales(double length, std::vector<JointScales>& scales);

}  // namespace gxrod
