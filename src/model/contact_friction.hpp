#pragma once

namespace gxrod {

// How Coulomb friction depends on the direction and the speed of slip, as shares of a coefficient, which is
// the largest of all (docs/theory/contact.md, (C28), (C30)).
struct FrictionShape {
    double forward = 1.0;         // of a rod that slides along itself, towards its end
    double backward = 1.0;        // towards its start
    double across = 1.0;          // of a rod that slides across itself, and of bodies in every direction
    double kinetic = 1.0;         // share of all of these at great speed; 1: at every speed
    double stribeck_speed = 0.0;  // speed at which 1/e of the difference is left; positive if kinetic < 1

    bool is_directed() const { return forward != across || backward != across; }
    bool weakens() const { return kinetic < 1.0; }
    bool is_plain() const { return across == 1.0 && !is_directed() && !weakens(); }
    bool operator==(const FrictionShape&) const = default;
};

}  // namespace gxrod
