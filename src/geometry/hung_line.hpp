#pragma once

#include <optional>

#include "geometry/catenary.hpp"
#include "geometry/curve.hpp"

namespace gxrod {

// The ends of an inextensible line with constant weight per length and no bending stiffness that hangs
// between them along −z: a catenary in an upright plane, which can lie in part on a level bed without
// friction.
struct HungLineEnds {
    Vec3 from = Vec3::Zero(), to = Vec3::Zero();
    double length = 0.0;          // length of the line
    std::optional<double> bed{};  // z of it; both ends are on or above it
};

class HungLine final : public Curve {
  public:
    // Throws std::invalid_argument, with the numbers, for a line that is shorter than the distance of its
    // ends; for one with ends above each other that is longer; for one so long that all but its upright parts
    // would lie loosely on the bed; and for ends below the bed. A line that exceeds the distance only by
    // round-off is straight.
    explicit HungLine(const HungLineEnds& ends);

    double length() const override { return length_; }
    Vec3 position(double s) const override;
    Vec3 tangent(double s) const override;
    Quat transport(double s) const override;
    double turn(double s) const override;

    // Returns the level part of the tension over the weight per length; infinite for a straight line. The
    // tension at s is this times √(1 + slope²).
    double level_tension() const;
    // The part of the line on the bed, by arc lengths.
    struct OnBed {
        double from, to;
    };
    const std::optional<OnBed>& on_bed() const { return on_bed_; }

  private:
    void hang_freely(double rise);
    bool finds_bed(double bed_rise) const;  // whether the lowest point of the free line is below it
    void lay_on_bed(double bed);
    double angle(double s) const;  // angle of the tangent, from level up
    Catenary::Point point_in_plane(double s) const;

    Vec3 from_, to_, level_;  // level_: from one end to the other, horizontal, of length 1
    double length_;
    double straight_angle_ = 0.0;  // if is_straight_
    bool is_straight_ = false;
    // The catenary from the start; with a bed, the one from the places where the line leaves it, to both
    // sides.
    Catenary catenary_{0.0};
    std::optional<OnBed> on_bed_{};
    double bed_rise_ = 0.0;                                 // height of the bed above the start
    double span_ = 0.0, leaves_at_ = 0.0, meets_at_ = 0.0;  // x of the ends of on_bed_, from the start
};

}  // namespace gxrod
