#pragma once

#include <vector>

namespace gxrod {

// D of the equations of one joint, docs/theory/joints.md (J19): of rows that are lengths, and of others.
struct JointScales {
    double length = 0.0;
    double turn = 0.0;

    double of(bool is_length) const { return is_length ? length : turn; }
};

namespace joint_scaling {

// Of the entries on the diagonal; it makes redundant equations solvable.
constexpr double regularization = 1e-8;
// D of rows of accelerations, relative to that of rows of positions. Where some are redundant, they
// contradict each other in the inner stages of a step: with a smaller D, their multipliers grow less.
constexpr double acceleration_scale = 1e-2;

}  // namespace joint_scaling

// The mean size of entries on a tangent's diagonal, of displacements and of rotations.
class DiagonalMean {
  public:
    void add(int component, double value);
    JointScales mean() const;

  private:
    double sums_[2] = {0.0, 0.0};
    int counts_[2] = {0, 0};
};

// Raises all to a part of the largest at least; `length` is that of the model.
void bound_scales(double length, std::vector<JointScales>& scales);

}  // namespace gxrod
