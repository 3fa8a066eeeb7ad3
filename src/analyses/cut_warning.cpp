#include "analyses/cut_warning.hpp"

#include <fmt/format.h>

#include "model/settings/newton_choice.hpp"
#include "model/settings/scheme_card.hpp"

namespace gxrod {
namespace {

constexpr std::int64_t few = 5;
// Ratios of stiffnesses from here on are mentioned. One of 100 was seen to cut a step in ten.
constexpr double notable_ratio = 30.0;

std::string describe_ratio(const Model& model) {
    const std::optional<StiffnessRatio> ratio = find_stiffness_ratio(model);
    if (!ratio || ratio->ratio < notable_ratio) return "";
    return "; " + describe(*ratio, model);
}

std::string advise_on_motion(const Model& model, const DynamicSettings& settings) {
    const SchemeCard& card = card_of(settings.scheme);
    const std::string steps = settings.adaptive ? "a smaller max_step" : "a smaller time_step";
    if (card.is_explicit) return ". Try " + steps + ".";
    std::string remedy = ". Try " + steps;
    const TangentKind tangent = choose_tangent(model, settings).tangent;
    const bool is_consistent = tangent == TangentKind::consistent || tangent == TangentKind::kept;
    if (is_consistent && !model.rods.empty()) {
        remedy = ". Try newton.tangent = \"mixed\", which converges in longer steps, or " + steps;
    }
    if (!settings.has_inertia) return describe_ratio(model) + remedy + ".";
    if (!model.contact.is_empty()) {
        if (card.parameters == SchemeParameters::newmark && settings.gamma == DynamicSettings{}.gamma)
            remedy += ", or gamma = 0.6 and beta = 0.3, which damp what is too fast for the steps";
    } else {
        remedy += card.if_cut;
    }
    return describe_ratio(model) + remedy + ".";
}

}  // namespace

bool are_worth_telling(const StepCuts& cuts) {
    constexpr double tolerable = 0.2;  // of the steps
    const bool is_often_wrong =
        static_cast<double>(cuts.by_error) > tolerable * static_cast<double>(cuts.steps);
    return cuts.cuts - cuts.by_error > few || (cuts.by_error > few && is_often_wrong);
}

std::string count_cuts(const StepCuts& cuts) {
    return fmt::format("{} of {} steps were cut, {} times in all", cuts.cut_steps, cuts.steps, cuts.cuts);
}

std::string advise_on_cuts(const Model& model, const AnalysisSettings& analysis, bool is_unstable) {
    if (const auto* dynamic = std::get_if<DynamicSettings>(&analysis))
        return advise_on_motion(model, *dynamic);
    const bool is_consistent = choose_tangent(model, analysis).tangent == TangentKind::consistent;
    return std::string(". Try more steps") +
           (model.contact.is_empty() || is_unstable ? "" : ", or a thicker contact.skin") +
           (is_consistent ? ", or newton.tangent = \"mixed\", which converges in larger ones." : ".");
}

}  // namespace gxrod
