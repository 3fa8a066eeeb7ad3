#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "deck/reading/checked_deck.hpp"
#include "deck/schema/choices.hpp"
#include "deck/table/kinds.hpp"
#include "deck/table/table.hpp"
#include "model/settings/response_settings.hpp"
#include "model/settings/settings.hpp"

// [analysis] and [[stage]].
namespace gxrod {

enum class AnalysisKind {
    dynamic,
    statics,
    quasi_static,
    path,
    steady,
    modes,
    buckling,
    eigenvalues,
    response
};
inline constexpr std::array<Choice<AnalysisKind>, 9> analysis_kind_choices{
    {{"dynamic", AnalysisKind::dynamic},
     {"static", AnalysisKind::statics},
     {"quasi-static", AnalysisKind::quasi_static},
     {"path", AnalysisKind::path},
     {"steady", AnalysisKind::steady},
     {"modes", AnalysisKind::modes},
     {"buckling", AnalysisKind::buckling},
     {"eigenvalues", AnalysisKind::eigenvalues},
     {"response", AnalysisKind::response}}};
inline constexpr const auto& choices_of(AnalysisKind) { return analysis_kind_choices; }

// The velocities at t = 0.
enum class StartVelocities { given, project };
inline constexpr std::array<Choice<StartVelocities>, 2> start_choices{
    {{"given", StartVelocities::given}, {"project", StartVelocities::project}}};
inline constexpr const auto& choices_of(StartVelocities) { return start_choices; }

// The steps between numbers that are listed by their ends.
enum class Spacing { linear, log };
inline constexpr std::array<Choice<Spacing>, 2> spacing_choices{
    {{"linear", Spacing::linear}, {"log", Spacing::log}}};
inline constexpr const auto& choices_of(Spacing) { return spacing_choices; }

// Whether a sweep looks for values at which motions begin to grow.
enum class OnsetSearch { locate, off };
inline constexpr std::array<Choice<OnsetSearch>, 2> onset_choices{
    {{"locate", OnsetSearch::locate}, {"off", OnsetSearch::off}}};
inline constexpr const auto& choices_of(OnsetSearch) { return onset_choices; }

// The points that a path can follow.
enum class FollowedPoint { limit };
inline constexpr std::array<Choice<FollowedPoint>, 1> follow_choices{{{"limit", FollowedPoint::limit}}};
inline constexpr const auto& choices_of(FollowedPoint) { return follow_choices; }

inline constexpr const auto& choices_of(OpenScheme) { return scheme_choices; }
inline constexpr const auto& choices_of(TangentKind) { return tangent_choices; }
inline constexpr const auto& choices_of(LinearSolverKind) { return linear_solver_choices; }
inline constexpr const auto& choices_of(CriticalSearch) { return critical_search_choices; }
inline constexpr const auto& choices_of(Linearization) { return linearization_choices; }
inline constexpr const auto& choices_of(Direction) { return direction_choices; }

struct NewtonTable : TableHead {
    std::optional<double> tolerance;
    long max_iterations = NewtonSettings{}.max_iterations;
    TangentKind tangent = NewtonSettings{}.tangent;
};

struct AdaptiveTable : TableHead {
    double tolerance = AdaptiveSettings{}.tolerance;
    double min_step = AdaptiveSettings{}.min_step;
    std::optional<double> max_step;
};

struct UntilTable : TableHead {
    std::optional<Bounds> t;
    std::optional<double> arc;
    std::optional<long> steps, points;
};

struct PathTargetTable : TableHead {
    std::optional<PointName> of;
    Direction displacement = Direction::x;
    std::vector<double> values;
    std::optional<std::vector<double>> t;
};

struct PathControlTable : TableHead {
    PointName of;
    std::optional<Direction> displacement, rotation;
    std::optional<double> to;
};

// Numbers by their ends, or listed.
struct NumbersTable : TableHead {
    std::optional<double> from;
    double to = 0.0;
    long count = 100;
    Spacing spacing = Spacing::linear;
    std::optional<std::vector<double>> values;
};

struct SweepTable : NumbersTable {
    SweepTable() { count = 21; }
    std::string key;
    OnsetSearch onset = OnsetSearch::locate;
    bool shapes = false;
};

struct ExcitationTable : TableHead {
    PointName at;
    Vec3 force = Excitation{}.force;
    Vec3 moment = Excitation{}.moment;
    double phase = Excitation{}.phase;
};

struct AnalysisTable : TableHead {
    std::string stage_name;
    AnalysisKind kind = AnalysisKind::dynamic;
    double end_time = 0.0;
    std::optional<double> accuracy, time_step;
    std::optional<long> steps;
    // These are for motions.
    OpenScheme integrator{DynamicSettings{}.scheme};
    double beta = DynamicSettings{}.beta;
    double gamma = DynamicSettings{}.gamma;
    double spectral_radius = DynamicSettings{}.spectral_radius;
    StartVelocities start = StartVelocities::given;
    std::optional<AdaptiveTable> adaptive;
    std::optional<NewtonTable> newton;
    LinearSolverKind linear_solver = LinearSolverKind::automatic;
    // These are for paths.
    std::optional<UntilTable> until;
    std::optional<double> step;
    double max_step = PathSettings{}.max_step;
    double min_step = PathSettings{}.min_step;
    std::vector<PathTargetTable> at;
    std::optional<PathControlTable> control;
    CriticalSearch critical = PathSettings{}.critical;
    long branches = PathSettings{}.branches;
    std::optional<FollowedPoint> follow;
    // These are for shapes.
    std::optional<long> count;
    std::optional<double> below;
    Linearization linearization = ModesSettings{}.linearization;
    std::optional<SweepTable> sweep;
    // These are for responses.
    std::optional<NumbersTable> omega, frequency;
    std::vector<ExcitationTable> excite;
    std::optional<Vec3> gravity;
};

// Declare the keys of one kind of analysis.
void add_path_keys(Table<AnalysisTable>& table);
void add_shape_keys(Table<AnalysisTable>& table);
void add_response_keys(Table<AnalysisTable>& table);

// Lists [analysis], or each [[stage]].
std::vector<std::reference_wrapper<const AnalysisTable>> list_analyses(const CheckedTable& deck);

}  // namespace gxrod
