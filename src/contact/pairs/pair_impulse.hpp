#pragma once

#include "contact/pairs/open_contact.hpp"
#include "contact/pairs/pair_energy.hpp"

// What makes the forces of pairs those of a step of time (docs/theory/contact.md, (C16) to (C22)).
namespace gxrod {

// Where two lines were closest at the start of a step, in parts of the segments that are closest at its end.
struct PairStart {
    double s = 0.0, t = 0.0;     // of straight lines, as OpenContact has them
    Vec3 offset = Vec3::Zero();  // of these
    double distance = 0.0;       // of the lines as they are
    Vec12 ends;                  // of these segments
};

// Their positions.
Vec12 find_ends(const Segment& a, const Segment& b);

// Makes the forces between two segments impulses, (C20): in the mean direction of the normals between their
// closest points at the start and at the end, and half way between the places there, and with (C21). So what
// slides around a rod, or along it, keeps its energy and its angular momentum, and what passes to its other
// side gains none. `radii` is the sum of both. The Hessian becomes the derivative.
void turn_impulse(const Segment& a,
                  const Segment& b,
                  const OpenEnds& open,
                  const PairStart& start,
                  double radii,
                  PairEnergy& pair);

// Damps the forces, and their derivatives with them: with the motion of the ends since the start of a step,
// G · motion is what the pair stores more, |F| the force on a, and (G · motion)/|F| how far the pair came
// closer. G becomes (1 + damping (G · motion)/|F|) G, and 0 where that factor is negative; the Hessian its
// derivative, which is not symmetric.
void damp(PairEnergy& pair, const Vec12& motion, double damping);

// How far two places have moved past each other since the start of a step: (1 − s) Δx_0 + s Δx_1 − (1 − t)
// Δx_2 − t Δx_3, by the motion of the ends.
Vec3 find_relative_way(const PairStart& start, const Vec12& way);

// Adds a drag on this way, (C22): f = −drag · way at the places that were closest at the start, and its
// derivatives.
void add_drag(PairEnergy& pair, const PairStart& start, const Vec12& way, double drag);

}  // namespace gxrod
