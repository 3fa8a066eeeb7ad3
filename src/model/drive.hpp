#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>

#include "model/time/time_function.hpp"
#include "rotation/types.hpp"

// Actions within the sections of rods (docs/theory/drives.md).
namespace gxrod {

// Stress-free strains of a rod's sections, material, f(t, s): from muscles, growth and heat. They add to the
// strains of the stress-free shape.
struct Actuation {
    std::string key;  // place in the deck, "actuation[0]"
    int rod = 0;
    std::array<LineFunction, 6> strain{};  // Γx Γy Γz Kx Ky Kz
    // The temperature above that of the stress-free shape: on the line, and its gradients along y and z. It
    // acts by Section::expansion.
    LineFunction temperature{};
    std::array<LineFunction, 2> temperature_gradient{};
};

// The place of a tendon in a section, in its axes; x is zero.
struct TendonPlace {
    Vec3 at = Vec3::Zero();     // d
    Vec3 slope = Vec3::Zero();  // d′, by the reference arc length
};

// A closed amount of gas in a chamber, whose volume V sets its pressure p above the ambient one:
// (ambient + p) Vⁿ = (ambient + pressure(t)) volumeⁿ.
struct ClosedGas {
    TimeFunction pressure{};            // above the ambient one, of the gas in `volume`
    double ambient = 0.0;               // absolute
    double exponent = 1.0;              // n: 1 at constant temperature, 1.4 for air without heat
    std::optional<double> volume = {};  // nullopt: the chamber's at t = 0
};

// A winch at one end of a tendon. Of the length ℓ₀ at t = 0 of the tendon's part within the rod it leaves ℓ₀
// − shortening(t), or ℓ₀ + share(t) (length(t) − ℓ₀).
struct TendonWinch {
    TimeFunction shortening{};
    std::optional<TimeFunction> length = {};
    TimeFunction share{1.0};
    double stiffness = 0.0;             // EA of the tendon; 0: inextensible
    bool pulls_only = true;             // the tendon is slack if it is longer than the winch leaves
    bool is_released = false;           // in the present stage
    std::optional<ClosedGas> gas = {};  // in place of a winch, of a chamber
};

// Friction of a tendon in its duct: |dT| ≤ coefficient T |dφ| along it, φ the turning of its direction.
struct CapstanFriction {
    double coefficient = 0.0;        // not negative
    double stiffness = 0.0;          // EA, with which the tension follows its stretch while it sticks
    bool is_pulled_at_start = true;  // whether it is pulled at its start, not its end
};

// A tendon that slides along a path in a rod, fixed to it at both ends. The rod is one line, with nodes at
// both ends of the tendon and at kinks of its path.
struct Tendon {
    std::string name;
    int rod = 0;
    double from = 0.0;       // arc length
    double to = 0.0;         // greater
    TimeFunction tension{};  // for a chamber of cross-section A under the pressure p: −p A
    double area = 0.0;       // A of a chamber; 0: a string
    std::function<TendonPlace(double s)> path{};   // by arc length between from and to, not at kinks
    std::optional<TendonWinch> winch = {};         // for a tendon without prescribed tension
    std::optional<CapstanFriction> friction = {};  // for a tendon with prescribed tension at its pulled end
};

}  // namespace gxrod
