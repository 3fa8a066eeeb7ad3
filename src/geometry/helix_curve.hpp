#pragma once

#include "geometry/curve.hpp"

namespace gxrod {

// A circular helix or arc.
struct HelixShape {
    Vec3 start;
    Vec3 axis;           // a unit vector
    Vec3 radius;         // from the axis to the start, across the axis
    double angle = 0.0;  // turned about the axis from start to end, right-handed
    double rise = 0.0;   // advance along the axis from start to end; 0 makes it an arc
};

class HelixCurve final : public Curve {
  public:
    explicit HelixCurve(const HelixShape& shape);

    double length() const override { return length_; }
    Vec3 position(double s) const override;
    Vec3 tangent(double s) const override;
    // Carried axes fall behind the curve's own frame (tangent, normal, binormal) by torsion × length.
    Quat transport(double s) const override;
    double turn(double s) const override;

  private:
    HelixShape shape_;
    Vec3 across_;  // axis × radius
    double length_;
};

}  // namespace gxrod
