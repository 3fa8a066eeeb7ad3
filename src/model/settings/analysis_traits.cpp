#include "model/settings/analysis_traits.hpp"

namespace gxrod {
namespace {

struct Traits {
    AnalysisTraits operator()(const DynamicSettings& settings) const {
        return {.kind = settings.has_inertia ? "dynamic" : "quasi-static",
                .has_steps = true,
                .is_timed = true,
                .needs_inertia = settings.has_inertia,
                .uses_mass = settings.has_inertia};
    }
    AnalysisTraits operator()(const StaticSettings&) const { return {}; }
    AnalysisTraits operator()(const SteadySettings&) const { return {.kind = "steady", .uses_mass = true}; }
    AnalysisTraits operator()(const PathSettings&) const { return {.kind = "path"}; }
    AnalysisTraits operator()(const ModesSettings&) const {
        return {.kind = "modes", .has_steps = false, .uses_mass = true};
    }
    AnalysisTraits operator()(const BucklingSettings&) const {
        return {.kind = "buckling", .has_steps = false};
    }
    AnalysisTraits operator()(const EigenvalueSettings&) const {
        return {.kind = "eigenvalues", .has_steps = false, .uses_mass = true};
    }
    AnalysisTraits operator()(const ResponseSettings&) const {
        return {.kind = "response", .has_steps = false, .uses_mass = true};
    }
};

struct End {
    double operator()(const DynamicSettings& dynamic) const { return dynamic.end_time; }
    double operator()(const StaticSettings&) const { return 1.0; }
    double operator()(const SteadySettings&) const { return 1.0; }
    double operator()(const PathSettings& path) const {
        return path.greatest_load.value_or(path.least_load.value_or(1.0));
    }
    template <class Shapes>
    double operator()(const Shapes&) const {
        return 0.0;
    }
};

struct Steps {
    long operator()(const DynamicSettings& dynamic) const { return dynamic.adaptive ? 0 : dynamic.steps; }
    long operator()(const StaticSettings& settings) const { return settings.steps; }
    long operator()(const SteadySettings& settings) const { return settings.steps; }
    long operator()(const PathSettings& path) const { return path.steps.value_or(0); }
    template <class Other>
    long operator()(const Other&) const {
        return 0;
    }
};

}  // namespace

AnalysisTraits traits_of(const AnalysisSettings& analysis) { return std::visit(Traits{}, analysis); }

std::optional<double> limit_load_factor_of(const AnalysisSettings& analysis) {
    const auto* path = std::get_if<PathSettings>(&analysis);
    if (path == nullptr || !path->limit_load_factor) return std::nullopt;
    return *path->limit_load_factor;
}

double end_of(const AnalysisSettings& analysis) { return std::visit(End{}, analysis); }

long steps_of(const AnalysisSettings& analysis) { return std::visit(Steps{}, analysis); }

}  // namespace gxrod
