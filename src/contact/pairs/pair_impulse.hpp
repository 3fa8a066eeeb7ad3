#pragma once

#include "contact/pairs/open_contact.hpp"
#include "contact/pairs/pair_energy.hpp"

// Impulses: the forces of pairs over a time step (docs/theory/contact.md, (C16) to (C22)).
namespace gxrod {

// The closest places of two lines at the start of a step, in parameters of the segments that are closest at
// its end.
struct PairStart {
    double s = 0.0, t = 0.0;     // for straight lines, as in OpenContact
    Vec3 offset = Vec3::Zero();  // between these places
    double distance = 0.0;       // distance of the actual lines
    Vec12 ends;                  // positions of these segments' ends
};

// Returns the positions of both segments' ends.
Vec12 find_ends(const Segment& a, const Segment& b);

// Makes the forces between two segments impulses, (C20): in the mean direction of the normals between their
// closest points at the start and at the end, and half way between the places there, and with (C21). Rods
// that slide around or along each other thus keep their energy and angular momentum, and gain none when one
// passes to the other's opposite side. `radii` is the sum of both. The Hessian becomes the derivative.
void turn_impulse(const Segment& a,
                  const Segment& b,
                  const OpenEnds& open,
                  const PairStart& start,
                  double radii,
                  PairEnergy& pair);

// Damps the forces and their derivatives. With the motion of the ends since the start of a step, G · motion
// is the pair's growth of energy, |F| the force on a, and (G · motion)/|F| the approach. G becomes (1 +
// damping (G · motion)/|F|) G, and 0 if that factor is negative; the Hessian becomes its derivative, which is
// not symmetric.
void damp(PairEnergy& pair, const Vec12& motion, double damping);
// Does the same by the rates of the ends in place of their motion. The Hessian becomes the derivative for
// fixed rates; the derivative of G by the rates is the damped G Gᵀ times the number that is returned.
double damp_by_rates(PairEnergy& pair, const Vec12& rates, double damping);

// Computes the relative displacement of two places since the start of a step: (1 − s) Δx_0 + s Δx_1 − (1 − t)
// Δx_2 − t Δx_3, from the motion of the ends.
Vec3 find_relative_way(const PairStart& start, const Vec12& way);

// Adds a drag against this displacement, (C22): f = −drag · way at the places that were closest at the start,
// and its derivatives.
void add_drag(PairEnergy& pair, const PairStart& start, const Vec12& way, double drag);

}  // namespace gxrod
