#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "geometry/curve.hpp"

namespace gxrod {

// The cubic r(u) = c₀ + c₁ u + c₂ u² + c₃ u³, u from 0 to 1.
struct Cubic {
    std::array<Vec3, 4> c;

    Vec3 position(double u) const { return c[0] + u * (c[1] + u * (c[2] + u * c[3])); }
    Vec3 slope(double u) const { return c[1] + u * (2.0 * c[2] + u * (3.0 * c[3])); }
    Vec3 bend(double u) const { return 2.0 * c[2] + u * (6.0 * c[3]); }
};

// Returns the polynomial through 2, 3 or 4 points at equal distances of u, the first at 0 and the last at 1.
Cubic interpolate(std::span<const Vec3> points);

// Finds a place where a chain of cubics stops or turns back on itself, so that it has no tangent: the index
// of the cubic plus its u. Returns nullopt if there is none.
std::optional<double> find_fold(std::span<const Cubic> cubics);

// A chain of cubics; each continues at the end and in the direction of the one before, without a fold.
// Lengths and transports are quadratures to round-off. The parameter of a point is the index of its cubic
// plus u.
class PolynomialCurve final : public Curve {
  public:
    explicit PolynomialCurve(std::span<const Cubic> cubics);

    double length() const override { return length_; }
    Vec3 position(double s) const override;
    Vec3 tangent(double s) const override;
    Quat transport(double s) const override;
    double turn(double s) const override;

    double arc_length_at(double parameter) const;

  private:
    // A part of a cubic short enough for one quadrature rule.
    struct Segment {
        Cubic cubic;             // by the segment's own u
        double first_parameter;  // parameter of the curve at u = 0
        double parameter_width;
        double start;  // arc length of the curve at u = 0
        double length;
        Quat transport;  // from the start of the curve to u = 0
        double turn;     // the same
    };
    struct Place {
        const Segment& segment;
        double u;
    };

    void add_segments(const Cubic& cubic, double first_parameter, double parameter_width, int depth);
    void add_segment(const Cubic& cubic, double first_parameter, double parameter_width);
    Place place_of(double s) const;

    std::vector<Segment> segments_;
    double length_ = 0.0;
    Quat end_transport_ = Quat::Identity();
    double end_turn_ = 0.0;
};

}  // namespace gxrod
