#include "deck/build_analysis.hpp"

#include <fmt/format.h>

#include <cmath>

#include "deck/choices.hpp"
#include "deck/schema_tables.hpp"

namespace gxrod {
namespace {

// A step divides the time if it does so up to this, relative.
constexpr double divides = 1e-9;

long find_steps(const CheckedTable& table, double end_time, const BuildContext& context) {
    if (table.gives("steps")) return table.get<long>("steps");
    const double time_step = table.get<double>("time_step");
    const double ratio = end_time / time_step;
    const double nearest = std::max(1.0, std::round(ratio));
    const bool is_whole = std::abs(ratio - nearest) <= divides * nearest;
    const double steps = is_whole ? nearest : std::ceil(ratio);
    if (steps > static_cast<double>(largest_step_count)) {
        context.add_fault(
            table,
            "time_step",
            fmt::format("{:.3g} steps are too many; expected at most {}", steps, largest_step_count));
        return 1;
    }
    if (!is_whole) {
        context.notes.push_back(fmt::format("{}: {} does not divide {}; {:.0f} steps of {} are taken",
                                            table.path_of("time_step"),
                                            time_step,
                                            end_time,
                                            steps,
                                            end_time / steps));
    }
    return static_cast<long>(steps);
}

NewtonSettings build_newton(const CheckedTable& analysis, Scheme scheme, const BuildContext& context) {
    NewtonSettings newton;
    if (!analysis.gives("newton")) return newton;
    const CheckedTable& table = analysis.tables("newton").front();
    newton.tolerance = table.get<double>("tolerance");
    newton.max_iterations = static_cast<int>(table.get<long>("max_iterations"));
    newton.tangent = value_of(tangent_choices, table.get<std::string>("tangent"));
    if (newton.tangent != TangentKind::paper) return newton;
    const std::string paper = word_of(tangent_choices, TangentKind::paper);
    if (scheme != Scheme::newmark_simplified) {
        context.add_fault(table,
                          "tangent",
                          fmt::format("\"{}\" belongs to integrator \"{}\", not to \"{}\"",
                                      paper,
                                      word_of(scheme_choices, Scheme::newmark_simplified),
                                      word_of(scheme_choices, scheme)));
    }
    if (!context.deck.tables("rod").empty()) {
        context.add_fault(
            table, "tangent", fmt::format("\"{}\" is for decks of bodies alone; this one has rods", paper));
    }
    return newton;
}

}  // namespace

DynamicSettings build_analysis(const BuildContext& context) {
    const CheckedTable& table = context.deck.tables("analysis").front();
    DynamicSettings settings;
    settings.end_time = table.get<double>("end_time");
    settings.steps = find_steps(table, settings.end_time, context);
    settings.scheme = value_of(scheme_choices, table.get<std::string>("integrator"));
    settings.beta = table.get<double>("beta");
    settings.gamma = table.get<double>("gamma");
    settings.spectral_radius = table.get<double>("spectral_radius");
    settings.newton = build_newton(table, settings.scheme, context);
    settings.linear_solver = value_of(linear_solver_choices, table.get<std::string>("linear_solver"));
    return settings;
}

}  // namespace gxrod
