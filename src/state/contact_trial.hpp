#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "rotation/types.hpp"

namespace gxrod {

// Two pieces of rods that are so near that they can touch, by their index among all of them.
struct NearPieces {
    std::uint32_t first = 0, second = 0;  // first < second

    auto operator<=>(const NearPieces&) const = default;
};

// What Newton's method knows of contact in addition to motions, found anew for each equilibrium.
struct ContactTrial {
    // Whether tangents are those of forces as unknowns of their own, by the parameters; else by gaps.
    bool has_parameters = false;
    // The gap of the point that each place has on the curve of force and gap (contact/impact_law.hpp): with
    // these the tangent is that of forces as unknowns of their own.
    std::vector<double> parameters;
    // Whether each place is taken to slide there, and the direction of its traction then; zero where it is
    // taken to stick. Empty without friction.
    std::vector<Vec3> sliding;
    // How far moved obstacles are on their way from the last accepted step, 0 … 1.
    double progress = 1.0;
    // Pieces that were nearer than `margin` where the trial was, sorted; since then it has moved by no more
    // than `travelled`. All that touch are among them.
    std::vector<NearPieces> pieces;
    std::vector<Vec3> pieces_sliding;  // of each of these, as `sliding`
    // Of each of these, that increments have taken into touch before it touches: the parameter ζ of its force
    // (contact/contact_law.hpp), no_contact of others.
    std::vector<double> pieces_expected;
    double margin = 0.0;
    double travelled = 0.0;
    // Of pieces at the start of a step.
    double energy_before = 0.0;
    // Force by the way of pieces that touch past each other since the start of a step, where their impulses
    // would give energy (docs/theory/contact.md, (C22)).
    double drag = 0.0;
};

}  // namespace gxrod
