#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/model.hpp"
#include "model/settings/eigenvalue_settings.hpp"
#include "model/settings/history_request.hpp"
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
    difference,  // central differences of the residual
    kept         // the exact derivative, computed again only where the residual falls too slowly; motions
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
    // The criterion of failure, by its word, by which stresses of all rods are recorded; "": they are not.
    std::string stresses = {};
    std::vector<HistoryRequest> histories;
};

}  // namespace gxrod
