#include "model/settings/scheme_choice.hpp"

namespace gxrod {
namespace {

// In fluids steps of order 2 were seen to be the cheaper ones down to here.
constexpr double loose_in_fluids = 1e-3;

bool has_rods_in_fluids(const Model& model) { return !model.rods.empty() && !model.surroundings.is_empty(); }

}  // namespace

std::string find_friction(const Model& model) {
    for (const Joint& joint : model.joints) {
        if (joint.turn.friction.acts() || joint.slide.friction.acts()) return "joint " + joint.name;
    }
    for (const Sleeve& sleeve : model.sleeves) {
        if (sleeve.slide.friction.acts()) return "joint " + sleeve.name;
    }
    for (const Tendon& tendon : model.tendons) {
        if (tendon.friction) return "tendon " + tendon.name;
    }
    return "";
}

SchemeChoice choose_scheme(const Model& model, std::optional<double> accuracy) {
    if (!model.contact.is_empty()) return {Scheme::generalized_alpha, "for what touches"};
    if (has_rods_in_fluids(model) && accuracy.value_or(loose_in_fluids) >= loose_in_fluids)
        return {Scheme::generalized_alpha, "for rods in water, in wind or on the ground"};
    if (const std::string rubs = find_friction(model); !rubs.empty())
        return {Scheme::generalized_alpha, "for friction, which " + rubs + " has"};
    if (model.rods.empty()) return {Scheme::radau_5, "for bodies"};
    return {Scheme::radau_5, "for rods, whose fastest vibrations steps do not resolve"};
}

}  // namespace gxrod
