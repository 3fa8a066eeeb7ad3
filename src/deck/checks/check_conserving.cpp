#include "deck/checks/check_conserving.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/analyses/analysis_table.hpp"
#include "model/parts.hpp"
#include "model/settings/scheme_card.hpp"
#include "model/ties/ties.hpp"

namespace gxrod {
namespace {

bool is_damped(const Section& section) {
    return section.kelvin_voigt > 0.0 || section.mass_proportional > 0.0;
}

bool has_damping(const Model& model) {
    return std::ranges::any_of(model.sections, is_damped) ||
           std::ranges::any_of(model.rods,
                               [](const Rod& rod) {
                                   return std::ranges::any_of(rod.varying.at_forces, is_damped) ||
                                          std::ranges::any_of(rod.varying.at_nodes, is_damped);
                               }) ||
           any_element_tie(model, [](const auto& tie) { return tie.has_damping(); });
}

bool has_laws(const Model& model) {
    return std::ranges::any_of(model.sections,
                               [](const Section& section) { return section.law != nullptr; }) ||
           std::ranges::any_of(model.springs, [](const Spring& spring) { return spring.law != nullptr; });
}

bool has_forces_by_motion(const Model& model) {
    return std::ranges::any_of(model.loads,
                               [](const NodalLoad& load) { return static_cast<bool>(load.motion_force); });
}

// What stands in the way, as the end of "the model has …"; "" if nothing does.
std::string find_obstacle(const Model& model) {
    if (model.rods.empty()) return "no rods";
    if (model.plane) return "a plane in which it stays";
    if (!model.supports.empty()) return "supports";
    if (!model.joints.empty() || !model.gears.empty() || !model.sleeves.empty()) return "joints";
    if (!model.tendons.empty() || !model.actuations.empty()) return "tendons or strains of their own";
    if (!model.surroundings.is_empty()) return "water, air or ground around it";
    if (has_laws(model)) return "sections or springs with a law";
    if (has_damping(model)) return "damping";
    if (has_forces_by_motion(model)) return "forces that depend on the motion of their point";
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
        fmt::format("\"{}\" is for one free elastic body of rods, without supports, joints or damping; this "
                    "model has {}; expected another integrator, such as \"{}\"",
                    card_of(dynamic->scheme).word,
                    obstacle,
                    card_of(Scheme::gauss_4).word));
}

}  // namespace gxrod
