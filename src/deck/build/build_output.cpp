#include "deck/build/build_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <span>

#include "deck/build/build_output_times.hpp"
#include "deck/build/part.hpp"
#include "deck/schema/choices.hpp"
#include "deck/schema/suggestion.hpp"
#include "deck/sections/section_axes.hpp"
#include "mesh/rod_mesh.hpp"
#include "model/frame_interval.hpp"

namespace gxrod {
namespace {

bool is_group_name(const std::string& name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](char letter) {
        return letter == '_' || letter == '-' || std::isalnum(static_cast<unsigned char>(letter)) != 0;
    });
}

void check_name(const CheckedTable& history, std::set<std::string>& taken, const BuildContext& context) {
    const std::string& name = history.get<std::string>("name");
    if (!is_group_name(name)) {
        return context.add_fault(
            history, "name", fmt::format("expected a name of letters, digits, _ and -, found \"{}\"", name));
    }
    constexpr std::array taken_words{"time", "stage", "load_factor", "branch"};
    if (std::find(taken_words.begin(), taken_words.end(), name) != taken_words.end()) {
        return context.add_fault(
            history, "name", fmt::format("\"{}\" is taken: a column of all histories has it", name));
    }
    if (!taken.insert(name).second) {
        context.add_fault(history, "name", fmt::format("an earlier history is named \"{}\" too", name));
    }
}

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

bool is_of_joints(Quantity quantity) {
    switch (quantity) {
        case Quantity::angle:
        case Quantity::angle_rate:
        case Quantity::slide:
        case Quantity::slide_rate:
        case Quantity::force:
        case Quantity::moment:
        case Quantity::force_a:
        case Quantity::moment_a:
        case Quantity::drive:
        case Quantity::friction:
        case Quantity::gap:
            return true;
        default:
            return false;
    }
}

bool is_of_springs(Quantity quantity) {
    return quantity == Quantity::elongation || quantity == Quantity::axial_force;
}

bool is_of_tendons(Quantity quantity) {
    return quantity == Quantity::tendon_length || quantity == Quantity::tendon_tension ||
           quantity == Quantity::tendon_end_tension;
}

bool is_of_obstacles(Quantity quantity) {
    return quantity == Quantity::contact_force || quantity == Quantity::contact_friction ||
           quantity == Quantity::least_gap;
}

bool is_of_bushings(Quantity quantity) {
    switch (quantity) {
        case Quantity::displacement:
        case Quantity::rotation_vector:
        case Quantity::force:
        case Quantity::moment:
        case Quantity::force_spatial:
        case Quantity::moment_spatial:
            return true;
        default:
            return false;
    }
}

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

// Where a history looks.
struct HistoryPlace {
    int node;  // -1: between nodes, a spring, a bushing, a joint or a tendon
    int body;  // -1: of a rod, a spring, a bushing, a joint or a tendon
    std::optional<RodPlace> place;
    int spring = -1;
    int bushing = -1;
    int joint = -1;
    int gear = -1;
    int sleeve = -1;
    int tendon = -1;
    int obstacle = -1;
    int touching_rod = -1;
};

// The index of what has the name, as the model is built; nullopt without it.
template <class Tie>
std::optional<int> find_tie(const std::vector<Tie>& ties, const std::string& name) {
    const auto found = std::ranges::find(ties, name, &Tie::name);
    if (found == ties.end()) return std::nullopt;
    return static_cast<int>(found - ties.begin());
}

// A node's place in the rod; where elements meet, in the first of them.
RodPlace place_in_rod(const PlacedPoint& point, const Rod& rod) {
    const auto per_element = static_cast<std::size_t>(rod.order) + 1;
    if (point.end_element >= 0) {
        return {point.rod, point.end_element, point.is_end_of_rod ? 1.0 : -1.0};
    }
    const auto found = std::find(rod.element_nodes.begin(), rod.element_nodes.end(), point.node);
    const auto entry = static_cast<std::size_t>(found - rod.element_nodes.begin());
    const double fraction = compute_element_nodes(rod.order)[entry % per_element];
    return {point.rod, static_cast<int>(entry / per_element), 2.0 * fraction - 1.0};
}

// The arc length at a fraction 0 … 1 of an element's interval of ξ; elements from meshes have their nodes at
// any.
double arc_length_at(const std::vector<double>& nodes, std::span<const double> arc_lengths, double fraction) {
    double sum = 0.0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        double shape = 1.0;
        for (std::size_t j = 0; j < nodes.size(); ++j) {
            if (j != i) shape *= (fraction - nodes[j]) / (nodes[i] - nodes[j]);
        }
        sum += shape * arc_lengths[i];
    }
    return sum;
}

// At a fraction of the length where there is no node.
RodPlace place_between_nodes(const RodPoint& point, const Rod& rod) {
    const double at = point.fraction * rod.length;
    const auto per_element = static_cast<std::size_t>(rod.order) + 1;
    const auto arc_lengths_of = [&](int element) {
        return std::span(rod.arc_length)
            .subspan(static_cast<std::size_t>(element) * per_element, per_element);
    };
    int element = 0;
    const auto has_it = [&](std::span<const double> s) { return s.front() <= at && at <= s.back(); };
    while (element + 1 < rod.element_count() && !has_it(arc_lengths_of(element))) ++element;
    const std::vector<double> nodes = compute_element_nodes(rod.order);
    double low = 0.0;
    double high = 1.0;
    constexpr int halvings = 60;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (arc_length_at(nodes, arc_lengths_of(element), middle) < at ? low : high) = middle;
    }
    return {point.rod, element, low + high - 1.0};
}

std::optional<HistoryPlace> find_place(const std::string& text, const BuildContext& context) {
    if (find_index(context.deck.tables("spring"), text)) {
        const std::optional<int> spring = find_tie(context.model.springs, text);
        if (!spring) return std::nullopt;
        return HistoryPlace{-1, -1, std::nullopt, *spring};
    }
    if (find_index(context.deck.tables("bushing"), text)) {
        const std::optional<int> bushing = find_tie(context.model.bushings, text);
        if (!bushing) return std::nullopt;
        return HistoryPlace{-1, -1, std::nullopt, -1, *bushing};
    }
    if (find_index(context.deck.tables("joint"), text)) {
        HistoryPlace place{-1, -1, std::nullopt};
        if (const std::optional<int> joint = find_tie(context.model.joints, text)) {
            place.joint = *joint;
        } else if (const std::optional<int> sleeve = find_tie(context.model.sleeves, text)) {
            place.sleeve = *sleeve;
        } else {
            return std::nullopt;
        }
        return place;
    }
    if (find_index(context.deck.tables("gear"), text)) {
        const std::optional<int> gear = find_tie(context.model.gears, text);
        if (!gear) return std::nullopt;
        HistoryPlace place{-1, -1, std::nullopt};
        place.gear = *gear;
        return place;
    }
    if (find_index(context.deck.tables("tendon"), text)) {
        const std::optional<int> tendon = find_tie(context.model.tendons, text);
        if (!tendon) return std::nullopt;
        HistoryPlace place{-1, -1, std::nullopt};
        place.tendon = *tendon;
        return place;
    }
    if (find_index(context.deck.tables("obstacle"), text)) {
        const std::optional<int> obstacle = find_tie(context.model.contact.obstacles, text);
        if (!obstacle) return std::nullopt;
        HistoryPlace place{-1, -1, std::nullopt};
        place.obstacle = *obstacle;
        return place;
    }
    const std::optional<int> whole = find_tie(context.model.rods, text);
    if (whole && !context.model.contact.is_empty()) {
        HistoryPlace place{-1, -1, std::nullopt};
        place.touching_rod = *whole;
        return place;
    }
    const std::optional<PlacedPoint> placed = context.place(text);
    if (!placed) return std::nullopt;
    if (placed->body >= 0) return HistoryPlace{placed->node, placed->body, std::nullopt};
    const Rod& rod = context.model.rods[static_cast<std::size_t>(placed->rod)];
    if (!placed->between) return HistoryPlace{placed->node, -1, place_in_rod(*placed, rod)};
    return HistoryPlace{-1, -1, place_between_nodes(*placed->between, rod)};
}

// Why the joint has no such quantity, or "".
std::string explain_missing(Quantity quantity, const Joint& joint) {
    const auto count = [&](const auto& has) { return int(has(joint.turn)) + int(has(joint.slide)); };
    const int motors = count([](const JointCoordinate& one) { return one.motion.has_value(); });
    const int frictions = count([](const JointCoordinate& one) { return one.friction.acts(); });
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
            return motors == 1 ? "" : "only a joint with a motor has it; this one has no `move`";
        case Quantity::friction:
            if (frictions > 1) return "this joint has two frictions; expected one";
            return frictions == 1 ? "" : "this joint has no friction";
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

bool touches(const HistoryPlace& point, const Model& model) {
    return std::ranges::any_of(model.contact.bodies,
                               [&](const ContactBody& one) { return one.body == point.body; });
}

// Why the point has no such quantity, or "".
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
        const bool has_it = quantity == Quantity::drive || quantity == Quantity::gap;
        return has_it ? "" : "a gear has drive and gap only; its joints have the rest";
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

// Sets what the quantities are relative to; nothing if the deck does not say.
void set_reference(const CheckedTable& table, HistoryRequest& request, const BuildContext& context) {
    if (!table.gives("relative_to")) return;
    const std::optional<PlacedPoint> point = context.place(table.get<std::string>("relative_to"));
    if (!point) return;
    request.relative_to = table.get<std::string>("relative_to");
    request.relative_node = point->node;
    request.relative_axes = context.axes_at(*point);
    if (table.get<std::string>("axes") == section_axes_word) return;
    if (point->body >= 0)
        context.add_fault(table, "axes", "only sections of rods have a twist; this point is a body's");
    if (point->rod >= 0 && context.deck.tables("rod")[static_cast<std::size_t>(point->rod)].gives("mesh"))
        context.add_fault(table, "axes", "a rod from a mesh has its section axes only");
    request.relative_to += ", untwisted";
    request.relative_axes = twisted(request.relative_axes, -context.twist_at(*point));
}

void set_about(const CheckedTable& table, HistoryRequest& request, const BuildContext& context) {
    if (!table.gives("about")) return;
    request.about = table.get<Vec3>("about");
    if (std::ranges::find(request.quantities, Quantity::reaction_moment) == request.quantities.end())
        context.add_fault(table, "about", "goes with reaction_moment, which is not among the quantities");
}

// A rod, or a body that touches, as ContactTouch has them.
std::optional<int> find_touching(const std::string& name, const Model& model) {
    if (const std::optional<int> rod = find_tie(model.rods, name)) return rod;
    const std::optional<int> body = find_tie(model.bodies, name);
    const auto& shapes = model.contact.bodies;
    if (!body || std::ranges::find(shapes, *body, &ContactBody::body) == shapes.end()) return std::nullopt;
    return static_cast<int>(model.rods.size()) + *body;
}

void set_contact(const CheckedTable& table,
                 const HistoryPlace& point,
                 HistoryRequest& request,
                 const BuildContext& context) {
    const Model& model = context.model;
    const bool is_body = touches(point, model) && std::ranges::any_of(request.quantities, is_of_obstacles);
    if (point.touching_rod < 0 && !is_body) {
        if (table.gives("with"))
            context.add_fault(table,
                              "with",
                              "goes with a rod as a whole as `at`, or a body and contact quantities, in a "
                              "deck with contact");
        return;
    }
    const int index = is_body ? static_cast<int>(model.rods.size()) + point.body : point.touching_rod;
    if (!is_body && model.contact.radii[static_cast<std::size_t>(index)] == 0.0) {
        const std::string& name = model.rods[static_cast<std::size_t>(index)].name;
        context.add_fault(table,
                          "at",
                          fmt::format("\"{}\" touches nothing; expected a point of it, as in \"{}@0.5\", or "
                                      "this rod among `rods` of [contact]",
                                      name,
                                      name));
        return;
    }
    request.contact = ContactWatch{.rod = index};
    request.contact->wants_gap =
        std::ranges::find(request.quantities, Quantity::least_gap) != request.quantities.end();
    if (!table.gives("with")) return;
    request.with = table.get<std::string>("with");
    if (const std::optional<int> obstacle = find_tie(model.contact.obstacles, request.with)) {
        request.contact->other = -1 - *obstacle;
    } else if (const std::optional<int> other = find_touching(request.with, model)) {
        request.contact->other = *other;
        const bool is_itself = *other == index && !is_body;
        if (*other == index && is_body)
            context.add_fault(table, "with", "a body does not touch itself");
        else if (is_itself ? !model.contact.within_rods : !model.contact.between_rods)
            context.add_fault(table,
                              "with",
                              fmt::format("\"{}\" does not touch {}: [contact] leaves it out",
                                          table.get<std::string>("at"),
                                          is_itself ? "itself" : "other rods"));
    } else {
        std::vector<std::string> names;
        for (const Obstacle& one : model.contact.obstacles) names.push_back(one.name);
        for (const Rod& one : model.rods) names.push_back(one.name);
        for (const ContactBody& one : model.contact.bodies)
            names.push_back(model.bodies[static_cast<std::size_t>(one.body)].name);
        context.add_fault(
            table,
            "with",
            fmt::format("no obstacle and no rod \"{}\"{}", request.with, did_you_mean(request.with, names)));
    }
}

HistoryRequest build_history(const CheckedTable& table,
                             const HistoryPlace& point,
                             const BuildContext& context) {
    HistoryRequest request{.name = table.get<std::string>("name"),
                           .at = table.get<std::string>("at"),
                           .node = point.node,
                           .body = point.body,
                           .spring = point.spring,
                           .bushing = point.bushing,
                           .place = point.place,
                           .joint = point.joint,
                           .gear = point.gear,
                           .tendon = point.tendon,
                           .obstacle = point.obstacle};
    // Values of sleeves come behind those of joints and gears.
    if (point.sleeve >= 0) {
        const std::size_t before = context.model.joints.size() + context.model.gears.size();
        request.joint = static_cast<int>(before) + point.sleeve;
    }
    set_reference(table, request, context);
    for (const CheckedWord& word : table.get<std::vector<CheckedWord>>("quantities")) {
        const Quantity quantity = value_of(quantity_choices, word.word);
        const auto& listed = request.quantities;
        if (std::find(listed.begin(), listed.end(), quantity) != listed.end()) {
            context.faults.add(word.place, word.path, fmt::format("\"{}\" is listed twice", word.word));
            continue;
        }
        std::string reason = explain_missing(quantity, point, context.model);
        if (table.gives("relative_to") && (point.bushing >= 0 || point.tendon >= 0 || point.obstacle >= 0 ||
                                           point.touching_rod >= 0 || !can_be_relative(quantity))) {
            reason = "cannot be relative to a point; write another history for it";
        }
        if (!reason.empty()) {
            context.faults.add(word.place, word.path, fmt::format("\"{}\": {}", word.word, reason));
        }
        request.quantities.push_back(quantity);
    }
    set_about(table, request, context);
    set_contact(table, point, request, context);
    return request;
}

}  // namespace

OutputSettings build_output(const BuildContext& context) {
    OutputSettings output;
    output.every = context.stages.front().frame_interval;
    const std::vector<CheckedTable>& tables = context.deck.tables("output");
    if (!tables.empty()) {
        const CheckedTable& table = tables.front();
        build_output_times(table, context, output);
        output.compression = value_of(compression_choices, table.get<std::string>("compression"));
    }
    std::set<std::string> taken;
    for (const CheckedTable& table : context.deck.tables("history")) {
        check_name(table, taken, context);
        const std::optional<HistoryPlace> point = find_place(table.get<std::string>("at"), context);
        if (point) output.histories.push_back(build_history(table, *point, context));
    }
    return output;
}

}  // namespace gxrod
