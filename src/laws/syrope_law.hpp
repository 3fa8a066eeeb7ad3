#pragma once

#include <optional>
#include <string>

#include "laws/piecewise_line.hpp"
#include "laws/working_shape.hpp"
#include "model/sections/small_motion_law.hpp"

namespace gxrod {

// A fibre rope by the Syrope model: a slow spring with a dashpot, in series with a fast spring whose
// stiffness grows with the mean tension.
struct SyropeRope {
    PiecewiseLine original;  // mean tension over strain of a new rope, from (0, 0), rising
    WorkingShape shape = WorkingShape::linear;
    double k1 = 0.0;           // part of the largest strain that stays; of a linear curve from 1 on its slope
    double k2 = 0.0;           // how much the working curve bends
    double stiffness = 1.0;    // of the fast spring without mean tension
    double per_tension = 0.0;  // by which it grows, per mean tension
    double damping = 1.0;      // of the dashpot, force·time
    double largest = 0.0;      // strain of a new rope at the largest mean tension before the start
};

// Says where a rope's working curve is as steep as its fast spring, so that the two contradict each other.
struct SteepCurve {
    double largest = 0.0;  // strain of a new rope
    double slope = 0.0;
    double stiffness = 0.0;  // of the fast spring there
};

// A section with the axial force of a Syrope rope and C for all other strains; docs/theory/laws.md, (L35) to
// (L39). Strains are of the rope as the largest mean tension before the start has left it, without tension.
// It remembers its strain, the strain of its curve at the mean tension, and the largest one.
class SyropeLaw final : public SmallMotionLaw {
  public:
    // C does not couple the axial strain with another one.
    SyropeLaw(const Mat6& C, SyropeRope rope);

    int memory_size() const override { return 3; }
    bool has_derivatives() const override { return false; }
    std::string describe() const override { return "rope, Syrope"; }
    SectionResponse respond(const Vec6& strain,
                            std::span<const double> memory,
                            double elapsed,
                            std::span<double> after) const override;
    Mat6 elastic_tangent(const Vec6& strain, std::span<const double> memory) const override;
    bool is_at_limit(const Vec6& strain, std::span<const double> memory) const override;

    const SyropeRope& rope() const { return rope_; }

  private:
    // A point of the curves: of the strain there, mean tension, its slope, and the energy of the rope.
    struct Point {
        double tension, slope, energy;
    };
    // A stage of the step: its strain, the point of the curves at its end, and the rate of the slow spring.
    struct RopeStage {
        double at = 0.0;         // strain on the curves
        double by_strain = 0.0;  // its derivative by the strain at the end of the step
        double rate = 0.0, rate_by_strain = 0.0;
        double lost = 0.0;  // power of dissipation
    };

    double find_slack(double largest) const;
    Point find_point(double at, double largest) const;
    double fast_stiffness(double tension) const;
    double fast_strain(double tension) const;
    // Solves for a stage at a strain: slow strain = `start` + `weight` × rate.
    RopeStage solve_stage(double strain, double start, double weight, double from, double largest) const;

    Mat6 others_;  // C without the axial stiffness
    SyropeRope rope_;
    double scale_ = 1.0;  // length as it is over length of a new rope
};

// Finds the first place, over all largest strains up to twice that of the table's end, at which the curves
// are too steep; nullopt if they are nowhere.
std::optional<SteepCurve> find_steep_curve(const SyropeRope& rope);

}  // namespace gxrod
