#pragma once

#include <cmath>

#include "geometry/curve.hpp"
#include "geometry/line_equilibrium.hpp"

namespace gxrod {

// A weight that hangs on a line between its ends, so that the line kinks there.
struct LineKink {
    double bending;  // least bending stiffness of the line there
    double reach;    // length over which a kink is drawn round at least
};

// A line in equilibrium between two points in space, along −z: its places are by its length free of stress,
// so that it is longer than length() where it stretches. Kinks at weights are drawn round, as bending
// stiffness makes them.
class SectionedLine final : public Curve {
  public:
    struct Ends {
        Vec3 from = Vec3::Zero(), to = Vec3::Zero();
        std::vector<LineStretch> stretches{};    // their end weights by z
        std::optional<double> bed{}, surface{};  // z
        LineKink kink{};
    };
    // Throws std::invalid_argument, as find_line_equilibrium does, and for ends below the bed.
    explicit SectionedLine(const Ends& ends);

    double length() const override { return length_; }
    Vec3 position(double s) const override;
    Vec3 tangent(double s) const override;
    Quat transport(double s) const override;
    double turn(double s) const override;

    // Computes the tension at a place.
    double tension(double s) const;

  private:
    using Shift = Eigen::Vector2d;  // level and up
    // A kink drawn round: half its angle is taken from the tangent on both sides, less with the distance.
    struct Round {
        double s, length;              // over which it bends
        double half;                   // angle
        Shift behind = Shift::Zero();  // of all that follows, as a round is shorter than a kink

        double fade(double place) const { return std::exp(-std::abs(place - s) / length); }
        double turn_at(double place) const { return (place < s ? half : -half) * fade(place); }
        double turned_up_to(double place) const {
            return std::abs(half) * (place < s ? fade(place) : 2.0 - fade(place));
        }
    };
    Shift gather(const Round& round, double place, bool is_before) const;
    Shift shift_at(const Round& round, double place) const;
    double plain_angle(double s) const;
    const LinePiece& piece_at(double s) const;
    double angle(double s) const;  // angle of the tangent, from level up
    void hang(const SuspendedLine& line, const LineKink& kink);
    void find_rounds(const LineKink& kink);
    void sum_turns();

    Vec3 from_, to_, level_;  // level_: from one end to the other, horizontal, of length 1
    double length_ = 0.0;
    LineEquilibrium line_;
    std::vector<Round> rounds_;
    std::vector<double> turns_;  // to the starts of the pieces
};

}  // namespace gxrod
