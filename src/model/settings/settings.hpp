#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/model.hpp"
#include "model/settings/eigenvalue_settings.hpp"
#include "model/settings/response_settings.hpp"
#include "rotation/types.hpp"

// The requests for a model: how to integrate and what to record. The defaults here are the deck's defaults.
namespace gxrod {

enum class Scheme {
    newmark_simplified,
    newmark_ibrahimbegovic,
    generalized_alpha,
    sdirk_4,
    radau_5,
    gauss_4,
    energy_momentum,
    runge_kutta_4
};

enum class TangentKind {
    automatic,   // mixed or consistent, by the model
    consistent,  // the exact derivative
    mixed,       // its geometric part by independent resultants (Magisano et al. 2017)
    paper,       // Rubin (2007), (5.6), with its additive update; rigid bodies under newmark_simplified
    difference   // central differences of the residual
};

enum class LinearSolverKind {
    automatic,  // by the matrix
    chains,     // by blocks, the insides of chains first, then their junctions by fronts
    klu,
    umfpack
};

// Newton's tolerance unless a smaller one is needed.
inline constexpr double usual_newton_tolerance = 1e-8;

struct NewtonSettings {
    // The tolerance of the residual, relative to the largest force and moment at any node. None: as the steps
    // need it.
    std::optional<double> tolerance;
    int max_iterations = 20;
    TangentKind tangent = TangentKind::automatic;
    // If positive, the largest residual component must fall below this instead, in the deck's units.
    double absolute_residual = 0.0;
};

// Steps chosen by an estimate of their error; for schemes that have one.
struct AdaptiveSettings {
    // The tolerance of one step: displacements relative to the model's length, rotations in rad.
    double tolerance = 1e-4;
    double min_step = 0.0;
    double max_step = std::numeric_limits<double>::infinity();
};

struct DynamicSettings {
    double end_time = 0.0;
    long steps = 0;  // equal steps from 0 to end_time
    Scheme scheme = Scheme::newmark_simplified;
    std::string chosen_for;  // the reason for this scheme, if the deck leaves it open; else ""
    double beta = 0.25;
    double gamma = 0.5;
    double spectral_radius = 0.9;              // at infinite frequency, for generalized_alpha
    std::optional<AdaptiveSettings> adaptive;  // then time_step() is the first step
    // Whether initial velocities are projected to the nearest ones that joints allow.
    bool projects_start = false;
    // Whether there is inertia; without, the motion is quasi-static (kind quasi-static).
    bool has_inertia = true;
    NewtonSettings newton;
    LinearSolverKind linear_solver = LinearSolverKind::automatic;

    double time_step() const { return end_time / static_cast<double>(steps); }
};

// Equilibria while the load factor t runs from 0 to 1.
struct StaticSettings {
    long steps = 10;  // equal steps, cut if Newton's method fails
    NewtonSettings newton;
    LinearSolverKind linear_solver = LinearSolverKind::automatic;
};

// The stiffness of sections, joints and contact that are about to yield or to slip: for unloading, or for
// continued loading.
enum class Linearization { elastic, loading };

// Small vibrations about a state.
struct ModesSettings {
    int count = 10;                    // the lowest ones
    std::optional<double> below = {};  // cycles per time: all of a lower frequency instead
    Linearization linearization = Linearization::elastic;
};

// Factors at which loads make a state unstable, by the resultants that the linear solution adds.
struct BucklingSettings {
    int count = 3;  // the smallest positive ones
    Linearization linearization = Linearization::elastic;
};

// Values of a component of a node's displacement, or of the load factor t, at which a path must have an
// equilibrium.
struct PathTarget {
    int node = -1;      // −1: t
    int component = 0;  // x, y or z
    std::vector<double> values;
};

// A quantity that each step of a path prescribes instead of the arc length.
struct PathControl {
    int node = -1;
    int component = 0;         // component of displacement, or, from 3 on, of rotation
    std::optional<double> to;  // displacement at which the path ends, and towards which it starts
};

// The treatment of limit points and bifurcations of a path: steps end on them, or the steps between which
// they lie are reported, or nothing.
enum class CriticalSearch { locate, report, off };

// Equilibria along a path on which the load factor t may turn back.
struct PathSettings {
    // The ends of the path; it ends at the first one, and needs at least one.
    std::optional<double> least_load, greatest_load;  // bounds of t
    std::optional<double> arc;
    std::optional<long> steps;
    std::optional<long> points;  // number of critical points
    // Arc lengths: about the mean displacement over the model's length, or the mean rotation times 0.2.
    std::optional<double> first_step;  // none: chosen by the model's response to its loads
    double max_step = 0.2;
    double min_step = 1e-7;
    std::vector<PathTarget> at;
    std::optional<PathControl> control;
    CriticalSearch critical = CriticalSearch::locate;
    int branches = 0;  // generations of branches to follow
    // If given, the path follows limit points while t advances, instead of equilibria at any load factor. It
    // is the load factor of an earlier path, on which loads of the model depend, and is solved for together
    // with the points.
    std::shared_ptr<double> limit_load_factor;
    NewtonSettings newton;
    LinearSolverKind linear_solver = LinearSolverKind::automatic;
};

// Equilibria in the frame that turns with Model::rotation, while the load factor t runs from 0 to 1.
struct SteadySettings : StaticSettings {};

using AnalysisSettings = std::variant<DynamicSettings,
                                      StaticSettings,
                                      SteadySettings,
                                      PathSettings,
                                      ModesSettings,
                                      BucklingSettings,
                                      EigenvalueSettings,
                                      ResponseSettings>;

// A quantity that a history can record.
enum class Quantity {
    position,
    displacement,
    rotation_vector,
    quaternion,
    orientation,
    velocity,
    angular_velocity,
    angular_velocity_material,
    acceleration,
    centre_of_mass,
    force,
    moment,
    force_spatial,
    moment_spatial,
    strain,
    curvature,
    reaction_force,
    reaction_moment,
    elongation,
    axial_force,
    angle,
    angle_rate,
    slide,
    slide_rate,
    force_a,
    moment_a,
    drive,
    friction,
    gap,
    effective_tension,
    wall_tension,
    water_velocity,
    wet_fraction,
    fluid_force,
    bed_force,
    tendon_length,
    tendon_tension,
    tendon_end_tension,
    contact_force,
    contact_friction,
    least_gap
};

// Names a point and what to record there at every accepted step.
struct HistoryRequest {
    std::string name;
    std::string at;    // as the deck has it
    int node = 0;      // -1: between nodes, a spring, a bushing, a joint, a gear or a tendon
    int body = -1;     // index in Model::bodies if the point is a body's
    int spring = -1;   // index in Model::springs if it is of a spring, which has no node
    int bushing = -1;  // index in Model::bushings if it is of a bushing, likewise
    // If the point is a rod's; where elements meet, in the first of them.
    std::optional<RodPlace> place = {};
    std::vector<Quantity> quantities = {};
    // Where the deck says relative_to: components are in the axes of this node, positions from its place.
    std::string relative_to = {};  // as the deck has it
    int relative_node = -1;
    Quat relative_axes = Quat::Identity();  // of section or body there at t = 0
    int joint = -1;                         // index in Model::joints if it is of a joint, which has no node
    int gear = -1;                          // index in Model::gears if it is of a gear, likewise
    // Where moments of reactions are about a point, fixed in space, and not about the support's.
    std::optional<Vec3> about = {};
    int tendon = -1;    // index in Model::tendons if it is of a tendon, which has no node
    int obstacle = -1;  // index in Contact::obstacles if it is of an obstacle, likewise
    // If it is of what a rod touches, likewise; and with what, as the deck has it.
    std::optional<ContactWatch> contact = {};
    std::string with = {};
};

// The compression of frames in the file; lossless.
enum class Compression { none, deflate };

struct OutputSettings {
    // Steps between frames; the first and the last are always written. 0: by the time
    // (model/settings/frame_interval.hpp).
    long every = 1;
    // Instead of it in stages with time, whatever their steps: the multiples of an interval in t of each
    // stage, or times on the axis that stages share, ascending. The first and the last frame are written
    // too.
    std::optional<double> interval;
    std::vector<double> times;
    // Histories are recorded at the multiples of it too, in addition to the ends of steps.
    std::optional<double> history_interval;
    Compression compression = Compression::none;
    std::vector<HistoryRequest> histories;
};

}  // namespace gxrod
