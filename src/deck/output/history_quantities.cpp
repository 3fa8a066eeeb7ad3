#include "deck/output/history_quantities.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/schema/choices.hpp"
#include "deck/schema/history_words.hpp"
#include "deck/schema/synonyms.hpp"

namespace gxrod {
namespace {

bool is_of_rods(Quantity quantity) {
    switch (quantity) {
        case Quantity::force:
        case Quantity::moment:
        case Quantity::force_spatial:
        case Quantity::moment_spatial:
        case Quantity::strain:
        case Quantity::curvature:
            return true;
        default:
            return false;
    }
}

bool is_reaction(Quantity quantity) {
    return quantity == Quantity::reaction_force || quantity == Quantity::reaction_moment;
}

bool is_of_joints(Quantity quantity) { return has_quantity(HistoryKind::joint, quantity); }

bool is_of_springs(Quantity quantity) { return has_quantity(HistoryKind::spring, quantity); }

bool is_of_tendons(Quantity quantity) { return has_quantity(HistoryKind::tendon, quantity); }

bool is_of_bushings(Quantity quantity) { return has_quantity(HistoryKind::bushing, quantity); }

bool is_of_surroundings(Quantity quantity) {
    switch (quantity) {
        case Quantity::effective_tension:
        case Quantity::wall_tension:
        case Quantity::water_velocity:
        case Quantity::wet_fraction:
        case Quantity::fluid_force:
        case Quantity::bed_force:
            return true;
        default:
            return false;
    }
}

// Why the joint has no such quantity, or "". What drives a coordinate, or rubs there, is 0 where nothing
// does.
std::string explain_missing(Quantity quantity, const Joint& joint) {
    const auto count = [&](const auto& has) { return int(has(joint.turn)) + int(has(joint.slide)); };
    const int motors =
        count([](const JointCoordinate& one) { return one.motion.has_value() || !one.drive.is_zero(); });
    const int frictions = count([](const JointCoordinate& one) { return one.friction.acts(); });
    const bool has_coordinate = joint.has_turn() || joint.has_slide();
    switch (quantity) {
        case Quantity::angle:
        case Quantity::angle_rate:
            return joint.has_turn() ? "" : "this joint has no turn about one axis";
        case Quantity::slide:
        case Quantity::slide_rate:
            return joint.has_slide() ? "" : "this joint has no slide";
        case Quantity::drive:
            if (motors > 1)
                return "this joint has two motors; force_a and moment_a show both, along the axis";
            return has_coordinate ? ""
                                  : "this joint has no turn about one axis and no slide that it could drive";
        case Quantity::friction:
            if (frictions > 1) return "this joint has two frictions; expected one";
            return has_coordinate ? "" : "this joint has no turn about one axis and no slide that could rub";
        default:
            if (is_of_joints(quantity)) return "";
            return is_of_springs(quantity) ? "only springs have it; this is a joint"
                                           : "only points have it; this is a joint";
    }
}

std::string explain_missing(Quantity quantity, const Sleeve& sleeve) {
    Joint joint;
    joint.kind = JointKind::sleeve;
    joint.slide = sleeve.slide;
    return explain_missing(quantity, joint);
}

// Why the point of a rod or a body has no such quantity of water, air or ground, or "".
std::string explain_missing_surroundings(Quantity quantity, const HistoryPlace& point, const Model& model) {
    const bool is_of_body = point.body >= 0;
    if (is_of_body && (quantity == Quantity::effective_tension || quantity == Quantity::wall_tension ||
                       quantity == Quantity::water_velocity || quantity == Quantity::bed_force))
        return "only points of rods have it; this one is a body";
    if (quantity == Quantity::effective_tension) return "";
    const Surroundings& around = model.surroundings;
    if (quantity == Quantity::bed_force && !around.seabed) return "the deck has no [seabed]";
    const bool needs_water = quantity == Quantity::wall_tension || quantity == Quantity::water_velocity ||
                             quantity == Quantity::wet_fraction;
    if (needs_water && !around.water) return "the deck has no [fluid]";
    if (quantity == Quantity::fluid_force && !around.water && !around.air)
        return "the deck has no [fluid] and no [air]";
    if (is_of_body)
        return model.bodies[static_cast<std::size_t>(point.body)].fluid ? "" : "this body has no `fluid`";
    const auto rod = static_cast<std::size_t>(point.place->rod);
    const Section& section = model.sections[static_cast<std::size_t>(model.rods[rod].section)];
    return section.fluid ? "" : "the section of this rod has no `fluid`";
}

}  // namespace

bool is_of_obstacles(Quantity quantity) { return has_quantity(HistoryKind::touching, quantity); }

bool touches(const HistoryPlace& point, const Model& model) {
    return std::ranges::any_of(model.contact.bodies,
                               [&](const ContactBody& one) { return one.body == point.body; });
}

std::string explain_missing(Quantity quantity, const HistoryPlace& point, const Model& model) {
    if (point.tendon >= 0)
        return is_of_tendons(quantity)
                   ? ""
                   : "a tendon has tendon_length, tendon_tension and tendon_end_tension only";
    if (is_of_tendons(quantity)) return "only tendons have it";
    if (point.obstacle >= 0)
        return is_of_obstacles(quantity)
                   ? ""
                   : "an obstacle has contact_force, contact_friction and least_gap only";
    if (point.touching_rod >= 0)
        return is_of_obstacles(quantity) ? ""
                                         : "a rod as a whole has contact_force, contact_friction and "
                                           "least_gap only; expected a point of it, as in \"ROD@0.5\"";
    if (is_of_obstacles(quantity)) {
        if (touches(point, model)) return "";
        return point.body >= 0 ? "this body touches nothing; expected its `sphere` or `capsule`"
                               : "only obstacles have it, and rods as a whole, and bodies that touch";
    }
    if (point.gear >= 0) {
        return has_quantity(HistoryKind::gear, quantity)
                   ? ""
                   : "a gear has drive and gap only; its joints have the rest";
    }
    if (point.bushing >= 0) return is_of_bushings(quantity) ? "" : "a bushing does not have it";
    if (point.joint >= 0)
        return explain_missing(quantity, model.joints[static_cast<std::size_t>(point.joint)]);
    if (point.sleeve >= 0)
        return explain_missing(quantity, model.sleeves[static_cast<std::size_t>(point.sleeve)]);
    if (point.spring >= 0) return is_of_springs(quantity) ? "" : "only points have it; this is a spring";
    if (is_of_springs(quantity)) return "only springs have it; this is a point";
    if (is_of_surroundings(quantity)) return explain_missing_surroundings(quantity, point, model);
    if (is_of_joints(quantity) && !is_of_rods(quantity)) return "only joints have it; this is a point";
    if (is_of_rods(quantity) && !point.place) return "only points of rods have it; this one is a body";
    if (quantity == Quantity::centre_of_mass && point.body < 0) {
        return "only bodies have it; this is a point of a rod";
    }
    if (!is_reaction(quantity)) return "";
    const bool is_supported = std::any_of(model.supports.begin(),
                                          model.supports.end(),
                                          [&](const Support& support) { return support.node == point.node; });
    return is_supported ? "" : "only a supported point has it; no [[support]] is at this one";
}

std::string suggest_quantity(const std::string& word, const HistoryPlace& point, const Model& model) {
    std::vector<std::string> there;
    for (const Choice<Quantity>& choice : quantity_choices) {
        if (explain_missing(choice.value, point, model).empty()) there.emplace_back(choice.word);
    }
    const std::string meant = find_choice(word, there);
    return meant.empty() ? "" : fmt::format("; did you mean \"{}\"?", meant);
}

bool can_be_relative(Quantity quantity) {
    switch (quantity) {
        case Quantity::position:
        case Quantity::displacement:
        case Quantity::rotation_vector:
        case Quantity::quaternion:
        case Quantity::orientation:
        case Quantity::velocity:
        case Quantity::angular_velocity:
        case Quantity::acceleration:
        case Quantity::centre_of_mass:
            return true;
        default:
            return false;
    }
}

}  // namespace gxrod
