#pragma once

#include "contact/contact_law.hpp"
#include "contact/pairs/closest_points.hpp"

// The contact energy of two straight parts of round rods: a double integral over both lines,
//   E = c ∫∫ Φ(|x(s) − y(t)|² − R²) ds dt,   Φ(u) = (1 − u/w)³ (w/u)² below w = (R + ĝ)² − R², else 0,
// where R is the sum of the radii and ĝ the skin. It is additive: it does not change if a line is cut in two,
// or if the contact passes a joint of pieces; and one formula holds from crossing to parallel lines. c = κ
// ĝ/(π w): two long lines at the distance d that cross at the angle θ repel each other with c 2 π d Φ/sin θ,
// about κ (1 − x)³/x² of x = u/w. (Φ ∝ 1/u would have the contact law itself, but leaves corners and ends
// without an infinite energy.)
namespace gxrod {

using Mat12 = Eigen::Matrix<double, 12, 12>;

struct PairLaw {
    double radii = 0.0;  // R
    ContactLaw law;
};

// The energy and its derivatives by the ends, in the order a.start, a.end, b.start, b.end.
struct PairEnergy {
    double energy = 0.0;
    Vec12 gradient = Vec12::Zero();  // exact gradient of `energy`; the forces on the ends are its negative
    Mat12 hessian = Mat12::Zero();   // exact Hessian of `energy`, or the derivative of impulses

    // The force on a.
    Vec3 force() const { return -(gradient.segment<3>(0) + gradient.segment<3>(3)); }
};

// Computes the energy. Lengths are in the reference state, by which the integral counts. The distance must
// exceed R.
PairEnergy compute_pair_energy(
    const PairLaw& pair, const Segment& a, const Segment& b, double length_a, double length_b);

// Computes the energy of a point and a line of `length`: E = c ∫ Φ dt over the line, with Φ(u) as above,
// which is infinite at its ends, too. With this c the point and a long line repel each other by the law's
// force at half the skin. The first of the ends is the point.
PairEnergy compute_point_energy(const PairLaw& pair, const Vec3& point, const Segment& line, double length);

// Computes the energy of two points by the law of the gap, V(|a − b| − R), by the ends a.start and b.start.
PairEnergy compute_points_energy(const PairLaw& pair, const Vec3& a, const Vec3& b);

}  // namespace gxrod
