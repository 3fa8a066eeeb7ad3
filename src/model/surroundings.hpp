#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "model/time/time_function.hpp"
#include "rotation/types.hpp"

// What is around rods and bodies: water with currents and waves, air, the ground
// (docs/theory/surroundings.md). Where there is a surface or waves, up is z.
namespace gxrod {

// What water and air see of a rod's section. Forces are per reference length and in section axes.
struct SectionInFluid {
    double area = 0.0;               // that displaces water
    double diameter = 0.0;           // of drag and of what touches the ground; not 0
    Vec3 drag = Vec3::Zero();        // Cx of the surface π D, Cy, Cz of the projected width D
    Vec3 added_mass = Vec3::Zero();  // Ca of the displaced mass, along x, y, z
    double contents_area = 0.0;      // across; the mass of the contents is in Section::mass
    double contents_density = 0.0;
    double contents_pressure = 0.0;  // at the surface, or at z = 0
    double poisson = 0.5;            // of the wall: ½ leaves no strain by pressure
};

// What water and air see of a body; in its axes.
struct BodyInFluid {
    double volume = 0.0;             // that displaces water
    Vec3 centre = Vec3::Zero();      // of buoyancy and of the other forces, from the node
    double height = 0.0;             // over which it sinks in: of the wet fraction
    Vec3 drag_area = Vec3::Zero();   // Cd A along x, y, z
    Mat6 added_mass = Mat6::Zero();  // about the centre, order x y z rx ry rz
};

// A velocity by time and place. Not for two threads at once.
using VelocityField = std::function<Vec3(double time, const Vec3& position)>;

// A plane velocity that follows the height: `speeds` at `heights`, increasing, linear between, constant
// beyond.
struct SpeedProfile {
    std::vector<double> heights;
    std::vector<double> speeds;
    Vec3 direction = Vec3::UnitX();  // of length 1
    TimeFunction factor{1.0};
};

// How a fluid flows when it has no waves: the sum of both.
struct Flow {
    std::optional<SpeedProfile> profile{};
    VelocityField field{};  // empty without one

    bool is_still() const { return !profile && !field; }
};

// A train of Airy waves: the surface η = a cos(k (x cos θ + y sin θ) − ω t + φ).
struct WaveTrain {
    double amplitude = 0.0;  // a
    double frequency = 0.0;  // ω, rad a time
    double number = 0.0;     // k
    double direction = 0.0;  // θ, where they go: from x towards y
    double phase = 0.0;      // φ
};

// How linear waves are continued to the moving surface.
enum class Stretching {
    wheeler,      // the profile from bed to still water is drawn out to the surface
    vertical,     // above still water as at it
    extrapolate,  // above still water along the tangent there
    none          // the formulas, above still water too
};

struct Water {
    double density = 0.0;
    std::optional<double> surface{};  // z of still water; without one water is everywhere
    std::optional<double> depth{};    // of waves; without one they are those of deep water
    Flow current{};
    std::vector<WaveTrain> waves{};
    Stretching stretching = Stretching::wheeler;
    bool stretches_current = false;  // Wheeler's, of the current's profile
    // Waves grow from `ramp_start` on over `ramp`, by q³(10 − 15 q + 6 q²).
    double ramp_start = 0.0;
    double ramp = 0.0;
};

struct Air {
    double density = 0.0;
    Flow wind{};
};

// Heights z on a grid, linear between its four corners; continued by its edges.
struct GroundGrid {
    std::vector<double> x, y;  // increasing, two or more
    std::vector<double> z;     // of (x[i], y[j]) at i + j x.size()
    double turn = 0.0;         // of these x and y about z, against the global axes
};

// The ground: a plane, or heights on a grid.
struct Seabed {
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ();       // out of the ground, of length 1
    std::optional<GroundGrid> grid{};  // in place of the plane
    double stiffness = 0.0;            // force per area and depth; the area is the diameter times the length
    double damping = 0.0;              // force per area and speed into the ground
    double axial_friction = 0.0;       // coefficients of Coulomb's friction, along a rod
    double lateral_friction = 0.0;     // and across it
    double friction_stiffness = 0.0;   // force per area and displacement, of what sticks

    bool has_friction() const {
        return friction_stiffness > 0.0 && (axial_friction > 0.0 || lateral_friction > 0.0);
    }
};

struct Surroundings {
    std::optional<Water> water{};
    std::optional<Air> air{};
    std::optional<Seabed> seabed{};

    bool is_empty() const { return !water && !air && !seabed; }
};

}  // namespace gxrod
