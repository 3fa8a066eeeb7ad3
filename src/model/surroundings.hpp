#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "model/time/time_function.hpp"
#include "rotation/types.hpp"

// The surroundings of rods and bodies: water with currents and waves, air, the ground
// (docs/theory/surroundings.md). With a surface or waves, up is z.
namespace gxrod {

// The data of a rod's section for water and air. Forces are per reference length and in section axes.
struct SectionInFluid {
    double area = 0.0;               // area that displaces water
    double diameter = 0.0;           // for drag and contact with the ground; not 0
    Vec3 drag = Vec3::Zero();        // Cx for the surface π D, Cy, Cz for the projected width D
    Vec3 added_mass = Vec3::Zero();  // Ca for the displaced mass, along x, y, z
    double contents_area = 0.0;      // cross-section of the contents, whose mass is in Section::mass
    double contents_density = 0.0;
    double contents_pressure = 0.0;  // at the surface, or at z = 0
    double poisson = 0.5;            // Poisson's ratio of the wall: ½ leaves no strain by pressure
};

// The data of a body for water and air, in its axes.
struct BodyInFluid {
    double volume = 0.0;             // volume that displaces water
    Vec3 centre = Vec3::Zero();      // centre of buoyancy and of the other forces, from the node
    double height = 0.0;             // height over which it sinks in, for the wet fraction
    Vec3 drag_area = Vec3::Zero();   // Cd A along x, y, z
    Mat6 added_mass = Mat6::Zero();  // about the centre, order x y z rx ry rz
};

// A velocity by time and place. Not for two threads at once.
using VelocityField = std::function<Vec3(double time, const Vec3& position)>;

// A plane velocity that depends on height: `speeds` at `heights`, increasing, linear in between, constant
// beyond.
struct SpeedProfile {
    std::vector<double> heights;
    std::vector<double> speeds;
    Vec3 direction = Vec3::UnitX();  // unit vector
    TimeFunction factor{1.0};
};

// The flow of a fluid without waves: the sum of both parts.
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
    double direction = 0.0;  // θ, direction of travel: from x towards y
    double phase = 0.0;      // φ
};

// Ways to continue linear waves to the moving surface.
enum class Stretching {
    wheeler,      // the profile from bed to still water is stretched to the surface
    vertical,     // above still water the value at still water
    extrapolate,  // above still water along the tangent at still water
    none          // the formulas, also above still water
};

struct Water {
    double density = 0.0;
    // Multiplies the forces of the water, as if its density were multiplied; 0 in stages without water.
    TimeFunction factor{1.0};
    bool changes = false;             // whether the factor is another one in some stage or at some time
    std::optional<double> surface{};  // z of still water; without one water is everywhere
    std::optional<double> depth{};    // depth for waves; without one the formulas of deep water
    Flow current{};
    std::vector<WaveTrain> waves{};
    Stretching stretching = Stretching::wheeler;
    bool stretches_current = false;  // Wheeler stretching of the current's profile
    // Waves grow from `ramp_start` on over `ramp`, by q³(10 − 15 q + 6 q²).
    double ramp_start = 0.0;
    double ramp = 0.0;

    // Whether there is water in this stage.
    bool acts() const { return !factor.is_zero(); }
    double density_at(double time) const { return factor(time) * density; }
};

struct Air {
    double density = 0.0;
    Flow wind{};
};

// Heights z on a grid, linear between its four corners; constant beyond its edges.
struct GroundGrid {
    std::vector<double> x, y;  // increasing, two or more
    std::vector<double> z;     // height at (x[i], y[j]): entry i + j x.size()
    double turn = 0.0;         // turn of these x and y about z from the global axes
};

// The ground: a plane, or heights on a grid.
struct Seabed {
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ();       // out of the ground, of length 1
    std::optional<GroundGrid> grid{};  // instead of the plane
    double stiffness = 0.0;            // force per area and depth; the area is the diameter times the length
    double damping = 0.0;              // force per area and speed into the ground
    double axial_friction = 0.0;       // Coulomb's coefficient along a rod
    double lateral_friction = 0.0;     // Coulomb's coefficient across a rod
    double friction_stiffness = 0.0;   // force per area and displacement, while it sticks
    // Multiplies the force of the ground; 0 in stages without ground.
    TimeFunction factor{1.0};

    // Whether there is ground in this stage.
    bool acts() const { return !factor.is_zero(); }
    bool has_friction() const {
        return acts() && friction_stiffness > 0.0 && (axial_friction > 0.0 || lateral_friction > 0.0);
    }
};

struct Surroundings {
    std::optional<Water> water{};
    std::optional<Air> air{};
    std::optional<Seabed> seabed{};

    bool is_empty() const { return !water && !air && !seabed; }
};

}  // namespace gxrod
