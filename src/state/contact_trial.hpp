#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "rotation/types.hpp"

namespace gxrod {

// Two pieces of rods, by their indices among all pieces, so near to each other that they can touch.
struct NearPieces {
    std::uint32_t first = 0, second = 0;  // first < second

    auto operator<=>(const NearPieces&) const = default;
};

// State of contact within Newton's method in addition to motions, found anew for each equilibrium.
struct ContactTrial {
    // Whether tangents treat contact forces as unknowns of their own, by the parameters; if not, by gaps.
    bool has_parameters = false;
    // The gap of each place's point on the curve of force over gap (contact/impact_law.hpp), from which
    // tangents with forces as unknowns of their own are computed.
    std::vector<double> parameters;
    // The direction of traction at each place that is taken to slide; zero where it is taken to stick. Empty
    // without friction.
    std::vector<Vec3> sliding;
    // The fraction, 0 … 1, of their way since the last accepted step that moving obstacles have covered.
    double progress = 1.0;
    // Pairs of pieces that were nearer than `margin` when they were sought, sorted. Since then the trial has
    // moved by at most `travelled`. All pairs that touch are among them.
    std::vector<NearPieces> pieces;
    std::vector<Vec3> pieces_sliding;  // for each of these pairs, as `sliding`
    // For each of these pairs, the parameter ζ of its force (contact/contact_law.hpp) if an increment has
    // taken it into contact before its gap closes; else no_contact.
    std::vector<double> pieces_expected;
    double margin = 0.0;
    double travelled = 0.0;
    // Energy of pairs at the start of a step.
    double energy_before = 0.0;
    // Force per distance that pieces in contact moved past each other since the start of a step, where their
    // impulses would add energy (docs/theory/contact.md, (C22)).
    double drag = 0.0;
};

}  // namespace gxrod
