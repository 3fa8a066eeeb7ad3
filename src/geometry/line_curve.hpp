#pragma once

#include "geometry/curve.hpp"

namespace gxrod {

// A straight line between two different points.
class LineCurve final : public Curve {
  public:
    LineCurve(Vec3 from, Vec3 to)
        : from_(std::move(from)),
          to_(std::move(to)),
          tangent_((to_ - from_).stableNormalized()),
          length_((to_ - from_).stableNorm()) {}

    double length() const override { return length_; }
    Vec3 position(double s) const override {
        const double fraction = s / length_;
        return (1.0 - fraction) * from_ + fraction * to_;
    }
    Vec3 tangent(double /*s*/) const override { return tangent_; }
    Quat transport(double /*s*/) const override { return Quat::Identity(); }
    double turn(double /*s*/) const override { return 0.0; }

  private:
    Vec3 from_, to_, tangent_;
    double length_;
};

}  // namespace gxrod
