#include "deck/checks/check_conserving.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/analyses/analysis_table.hpp"
#include "model/parts.hpp"
#include "model/settings/scheme_card.hpp"

namespace gxrod {
namespace {

bool is_moved(const Support& support) {
    return std::ranges::any_of(support.moved, [](bool moves) { return moves; });
}

bool has_motor(const Joint& joint) { return joint.turn.motion || joint.slide.motion; }

// What stands in the way, as the end of "the model has …"; "" if nothing does.
std::string find_obstacle(const Model& model) {
    if (model.rods.empty() && !is_held(model)) return "no rods, and nothing holds it";
    if (std::ranges::any_of(model.supports, is_moved)) return "supports that move";
    if (std::ranges::any_of(model.joints, has_motor)) return "motors";
    if (find_parts(model).size() > 1) return "several parts";
    return "";
}

}  // namespace

void check_conserving(const BuildContext& context) {
    const auto* dynamic = std::get_if<DynamicSettings>(&context.analysis());
    if (dynamic == nullptr || !card_of(dynamic->scheme).conserves_energy) return;
    const std::string obstacle = find_obstacle(context.model);
    if (obstacle.empty()) return;
    const AnalysisTable& table = list_analyses(context.deck)[context.stage];
    context.add_fault(
        table,
        table.integrator,
        fmt::format(
            "\"{}\" scales rates so that energy balances: those of one model of rods, without motors and "
            "supports that move; this model has {}; expected another integrator, such as \"{}\"",
            card_of(dynamic->scheme).word,
            obstacle,
            card_of(Scheme::gauss_4).word));
}

}  // namespace gxrod
