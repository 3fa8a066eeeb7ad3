#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>

#include "model/time/time_function.hpp"
#include "rotation/types.hpp"

// What acts within the sections of rods (docs/theory/drives.md).
namespace gxrod {

// Strains that the sections of a rod would take by themselves, material, f(t, s): those of muscles, of
// growth and of heat. They add to the strains of the stress-free shape.
struct Actuation {
    std::string key;  // where the deck states it, "actuation[0]"
    int rod = 0;
    std::array<LineFunction, 6> strain{};  // Γx Γy Γz Kx Ky Kz
    // Above that of the stress-free shape: on the line, and how fast it rises along y and along z. It acts
    // by Section::expansion.
    LineFunction temperature{};
    std::array<LineFunction, 2> temperature_gradient{};
};

// Where a tendon passes through a section, in its axes; x is zero.
struct TendonPlace {
    Vec3 at = Vec3::Zero();     // d
    Vec3 slope = Vec3::Zero();  // d′, by the arc length of the reference
};

// What winds up one end of a tendon: of the tendon's part within the rod, ℓ₀ long at t = 0, it leaves
// ℓ₀ − shortening(t), or ℓ₀ + share(t) (length(t) − ℓ₀).
struct TendonWinch {
    TimeFunction shortening{};
    std::optional<TimeFunction> length = {};
    TimeFunction share{1.0};
    double stiffness = 0.0;    // EA of the tendon; 0: it does not stretch
    bool pulls_only = true;    // it hangs loose where it is longer than what the winch leaves
    bool is_released = false;  // in the stage at hand
};

// What rubs a tendon in its path: along it |dT| ≤ coefficient T |dφ|, φ the turning of its direction.
struct CapstanFriction {
    double coefficient = 0.0;        // not negative
    double stiffness = 0.0;          // EA, by which the tension follows its stretch where it sticks
    bool is_pulled_at_start = true;  // where its tension is given; it is anchored at its other end
};

// A tendon that slides along a path in a rod, fixed to it at both ends. The rod is one line, and has nodes
// where the tendon starts and ends, and where its path has a kink.
struct Tendon {
    std::string name;
    int rod = 0;
    double from = 0.0;       // arc length
    double to = 0.0;         // greater
    TimeFunction tension{};  // a chamber under the pressure p, of the area A across, has −p A
    std::function<TendonPlace(double s)> path{};   // of arc lengths between from and to, not at kinks
    std::optional<TendonWinch> winch = {};         // of one whose tension is not prescribed but follows
    std::optional<CapstanFriction> friction = {};  // of one whose tension is prescribed where it is pulled
};

}  // namespace gxrod
