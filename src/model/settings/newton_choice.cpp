#include "model/settings/newton_choice.hpp"

#include <algorithm>

#include "model/settings/analysis_traits.hpp"

namespace gxrod {

const NewtonSettings& newton_of(const AnalysisSettings& analysis) {
    static const NewtonSettings none;
    return std::visit(
        [](const auto& settings) -> const NewtonSettings& {
            if constexpr (requires { settings.newton; }) return settings.newton;
            return none;
        },
        analysis);
}

TangentChoice choose_tangent(const Model& model, const AnalysisSettings& analysis) {
    const NewtonSettings& newton = newton_of(analysis);
    if (newton.tangent != TangentKind::automatic) return {newton.tangent};
    if (!is_timed(analysis)) return {TangentKind::mixed};
    const std::optional<StiffnessRatio> ratio = find_stiffness_ratio(model);
    const bool has_inertia = std::get<DynamicSettings>(analysis).has_inertia;
    if (!ratio || ratio->ratio < mixed_from_ratio)
        return {has_inertia ? TangentKind::consistent : TangentKind::automatic};
    return {TangentKind::mixed, ratio};
}

double derive_newton_tolerance(const AnalysisSettings& analysis) {
    const auto* dynamic = std::get_if<DynamicSettings>(&analysis);
    if (dynamic == nullptr || !dynamic->adaptive) return usual_newton_tolerance;
    return std::min(usual_newton_tolerance, newton_part * dynamic->adaptive->tolerance);
}

double choose_newton_tolerance(const AnalysisSettings& analysis) {
    return newton_of(analysis).tolerance.value_or(derive_newton_tolerance(analysis));
}

NewtonSettings choose_newton(const Model& model, const AnalysisSettings& analysis) {
    NewtonSettings newton = newton_of(analysis);
    newton.tangent = choose_tangent(model, analysis).tangent;
    newton.tolerance = choose_newton_tolerance(analysis);
    return newton;
}

}  // namespace gxrod
