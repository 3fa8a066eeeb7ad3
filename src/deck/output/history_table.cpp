#include "deck/output/history_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

#include "cross_section/cross_section.hpp"
#include "deck/contact/build_contact_exceptions.hpp"
#include "deck/output/history_place.hpp"
#include "deck/output/stress_checks.hpp"
#include "deck/output/stress_criterion.hpp"
#include "deck/rods/rod_table.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/schema/suggestion.hpp"
#include "deck/schema/synonyms.hpp"
#include "deck/sections/section_axes.hpp"
#include "model/sections/section_at.hpp"
#include "watch/quantities.hpp"
#include "watch/quantity_tables.hpp"
#include "watch/signless_words.hpp"

namespace gxrod {

const TableSpec& history_table() {
    using T = HistoryKeys;
    // clang-format off
    static const TableSpec table = Table<T>("[[history]]",
            "Quantities of a point, a spring, a bushing, a joint, a gear, a tendon, an obstacle or a rod that touches "
            "something, recorded at every step, and at times of their own if output.history_interval is given.")
        .key("name", &T::name, "The name of its group in the results: letters, digits, _ and -, each name once.")
            .required().also("id label")
        .key("at", &T::at, "A point of a rod, between nodes too, a body, a spring, a bushing, a joint, a gear, a "
             "tendon or an obstacle; a rod, for what touches it and where it lies on the ground.")
            .required().also("pos position node location where on")
        .key("with", &T::with, "Of a rod: the obstacle or the rod (itself, too) whose contact alone counts.")
            .otherwise("all that touches")
        .key("relative_to", &T::relative_to, "A point whose section axes (body axes of a body) the components are in, "
             "and from which positions count; it moves. For position, displacement, velocity, acceleration, "
             "centre_of_mass and rotations.")
            .otherwise("the global axes and the origin")
        .key("axes", &T::axes, "Those of relative_to that the components are in. untwisted: its section axes turned "
             "back by the twist there, so y_axis carried along the rod.")
            .only_with("relative_to")
        .key("about", &T::about, "The point, fixed in space, about which reaction_moment is: the moment of the "
             "support and that of its force.")
            .unit("length").otherwise("the point itself")
        .key("no_load", &T::no_load, "The direction, global at t = 0, to which no_load_angle is the angle of the rod's axis "
             "(from its start to its end): where an end fitting bends nothing. relative_to carries it.")
            .unit("1").otherwise("the axis at t = 0").also("no_load_direction no_moment_direction fitting_axis")
        .key("point", &T::point, "Where in the section, [y, z] in its axes, stresses are recorded: at the nearest node "
             "of the cells, at most a tenth of the section's extent away.")
            .unit("length").otherwise("where they are worst")
        .key("criterion", &T::criterion, "Which exposure is recorded, and where stresses are worst: \"von-mises\" with "
             "yield_stress of the material; \"tsai-wu\", \"hashin\" or \"max-stress\" with its strength, of materials "
             "without it von-mises. One material at least must have what it needs.")
            .otherwise("exposure by von-mises; stresses where the von Mises stress is largest")
        .key("quantities", &T::quantities, "rotation_vector and quaternion are the rotation since t = 0 of a rod's "
             "point, the attitude of a body; orientation is that of section or body axes for both. force, moment "
             "(section axes), force_spatial, moment_spatial, strain and curvature are a rod's, centre_of_mass is a "
             "body's, reactions are a support's. elongation (length less that of the free spring) and axial_force "
             "(tension positive, with damping) are a spring's. Of a bushing displacement and rotation_vector are "
             "those of B against A, force and moment what the bushing resists them with, all in its axes; "
             "force_spatial and moment_spatial are global. A joint has angle, slide and their rates since t = 0, "
             "force and moment (what A exerts on B, moment about the joint, global), force_a and moment_a (in the "
             "joint's axes on A, along its axis first), drive (moment or force of its motor, or its key drive), "
             "friction, play (of a joint with clearance) and gap. A gear has drive (moment or force on its second joint), "
             "play and gap. effective_tension, "
             "wall_tension, water_velocity, bed_force, shear_force, bending_moment, axis_x (along the rod) and no_load_angle are a rod's; a "
             "rod as a whole has touch_down_start and touch_down_end, the arc lengths where it lies on the ground "
             "first and last, and their positions; stress (xx, yy, zz, yz, xz, xy in section axes), "
             "von_mises, principal_stress, exposure (1/(factor on the resultants at which the material fails)) and "
             "stress_place that of a rod whose section has a shape and no law. wet_fraction and fluid_force are those "
             "of what has a key fluid, forces per length of a rod and whole of a body.")
            .required().words(list_quantity_words())
            .also("variables outputs record output values fields")
        .with(add_copies<T>)
        .shown_by(
            "[[history]]\n"
            "name = \"tip\"\n"
            "at   = \"flyer.end\"\n"
            "quantities = [\"position\", \"velocity\"]\n");
    // clang-format on
    return table;
}

namespace {

bool is_group_name(const std::string& name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](char letter) {
        return letter == '_' || letter == '-' || std::isalnum(static_cast<unsigned char>(letter)) != 0;
    });
}

void check_name(const HistoryKeys& history,
                const std::string& name,
                std::set<std::string>& taken,
                const BuildContext& context) {
    if (!is_group_name(name)) {
        return context.add_fault(
            history,
            history.name,
            fmt::format("expected a name of letters, digits, _ and -, found \"{}\"", name));
    }
    constexpr std::array taken_words{"time", "stage", "load_factor", "limit_load_factor", "branch"};
    if (std::find(taken_words.begin(), taken_words.end(), name) != taken_words.end()) {
        return context.add_fault(
            history, history.name, fmt::format("\"{}\" is taken: a column of all histories has it", name));
    }
    if (!taken.insert(name).second) {
        context.add_fault(history, history.name, fmt::format("an earlier history is named \"{}\" too", name));
    }
}

// Sets what the quantities are relative to; nothing if the deck does not say.
void set_reference(const HistoryKeys& table, HistoryRequest& request, const BuildContext& context) {
    if (!table.relative_to) return;
    const std::optional<PlacedPoint> point = context.place(table.relative_to->word);
    if (!point) return;
    request.relative_to = table.relative_to->word;
    request.relative_node = point->node;
    request.relative_axes = context.axes_at(*point);
    if (table.axes == HistoryAxes::section) return;
    if (point->body >= 0)
        context.add_fault(table, table.axes, "only sections of rods have a twist; this point is a body's");
    if (point->rod >= 0 && rods_of(context.deck)[static_cast<std::size_t>(point->rod)].get().mesh)
        context.add_fault(table, table.axes, "a rod from a mesh has its section axes only");
    request.relative_to += ", untwisted";
    request.relative_axes = twisted(request.relative_axes, -context.twist_at(*point));
}

template <class Predicate>
bool asks_for(const HistoryRequest& request, Predicate&& is_meant) {
    return std::ranges::any_of(request.quantities, [&](const std::string& word) {
        const Quantity* quantity = find_quantity(request.target, word);
        return is_meant(quantity != nullptr ? *quantity : *find_quantity(word));
    });
}

void set_about(const HistoryKeys& table, HistoryRequest& request, const BuildContext& context) {
    if (!table.about) return;
    request.about = table.about;
    if (!asks_for(request, [](const Quantity& one) { return one.is_about; }))
        context.add_fault(table, table.about, "goes with reaction_moment, which is not among the quantities");
}

void set_no_load(const HistoryKeys& table, HistoryRequest& request, const BuildContext& context) {
    if (!table.no_load) return;
    request.no_load = table.no_load;
    if (!asks_for(request, [](const Quantity& one) { return one.is_from_no_load; }))
        context.add_fault(table, table.no_load, "goes with no_load_angle, which is not among the quantities");
    if (table.no_load->isZero(0.0))
        context.add_fault(table, table.no_load, "expected a direction, found a vector of zero length");
}

// Where the exposure of a history is by a criterion that none of the materials there allows.
void check_exposure(const HistoryKeys& table,
                    const HistoryRequest& request,
                    const CrossSection& shape,
                    const BuildContext& context) {
    if (table.criterion)
        return check_materials_of(*table.criterion,
                                  shape.materials,
                                  table.place_of(&table.criterion),
                                  table.path_of(&table.criterion),
                                  context);
    const auto exposure = std::ranges::find_if(table.quantities.words, is_exposure, &CheckedWord::word);
    if (exposure == table.quantities.words.end() ||
        !explain_missing(exposure->word, request.target, context.model).empty())
        return;
    check_materials_of("von-mises", shape.materials, exposure->place, exposure->path, context);
}

void set_stress_keys(const HistoryKeys& table, HistoryRequest& request, const BuildContext& context) {
    const bool has_stress = std::ranges::any_of(request.quantities, is_stress_quantity);
    const auto refuse = [&](const auto& key) {
        context.add_fault(
            table,
            key,
            "goes with stress, von_mises, principal_stress or exposure, which are not among the quantities");
    };
    if (table.point && !has_stress) refuse(table.point);
    if (table.criterion && !has_stress) refuse(table.criterion);
    if (table.point) request.section_point = Eigen::Vector2d((*table.point)[0], (*table.point)[1]);
    if (table.criterion) {
        request.criterion = *table.criterion;
        check_criterion(table, table.criterion, context);
    }
    const auto* point = std::get_if<WatchedPoint>(&request.target);
    if (!has_stress || point == nullptr) return;
    const std::shared_ptr<const CrossSection> shape = section_at(context.model, point->place).shape;
    if (!shape) return;  // the quantities are refused
    if (request.section_point)
        check_section_point(*request.section_point,
                            *shape,
                            table.place_of(&table.point),
                            table.path_of(&table.point),
                            context);
    check_exposure(table, request, *shape, context);
}

// A rod, or a body that touches, as ContactTouch has them.
std::optional<int> find_touching(const std::string& name, const Model& model) {
    if (const std::optional<int> rod = find_named(model.rods, name)) return rod;
    const std::optional<int> body = find_named(model.bodies, name);
    const auto& shapes = model.contact.bodies;
    if (!body || std::ranges::find(shapes, *body, &ContactBody::body) == shapes.end()) return std::nullopt;
    return static_cast<int>(model.rods.size()) + *body;
}

// Sets the only thing that counts as touching the rod or body `name`: the key `with`.
void set_other(const HistoryKeys& table,
               const std::string& name,
               bool is_body,
               ContactWatch& contact,
               const BuildContext& context) {
    const Model& model = context.model;
    const std::string& with = *table.with;
    if (const std::optional<int> obstacle = find_named(model.contact.obstacles, with)) {
        contact.other = -1 - *obstacle;
        if (is_left_out(model.contact, contact.rod, -1 - *obstacle))
            context.add_fault(
                table,
                table.with,
                fmt::format("\"{}\" does not touch \"{}\": [[contact.pair]] leaves it out", name, with));
    } else if (const std::optional<int> other = find_touching(with, model)) {
        contact.other = *other;
        const bool is_itself = *other == contact.rod;
        const bool is_off = is_left_out(model.contact, contact.rod, *other);
        if (is_itself && is_body)
            context.add_fault(table, table.with, "a body does not touch itself");
        else if (is_off || (is_itself ? !model.contact.within_rods : !model.contact.between_rods))
            context.add_fault(table,
                              table.with,
                              fmt::format("\"{}\" does not touch {}: {} leaves it out",
                                          name,
                                          is_itself ? "itself"
                                          : is_off  ? "\"" + with + "\""
                                                    : "other rods",
                                          is_off ? "[[contact.pair]]" : "[contact]"));
    } else {
        std::vector<std::string> names;
        for (const Obstacle& one : model.contact.obstacles) names.push_back(one.name);
        for (const Rod& one : model.rods) names.push_back(one.name);
        for (const int body : model.contact.touching_bodies())
            names.push_back(model.bodies[static_cast<std::size_t>(body)].name);
        context.add_fault(table,
                          table.with,
                          fmt::format("no obstacle and no rod \"{}\"{}", with, did_you_mean(with, names)));
    }
}

void set_contact(const HistoryKeys& table, HistoryRequest& request, const BuildContext& context) {
    const Model& model = context.model;
    auto* body = std::get_if<WatchedBody>(&request.target);
    auto* rod = std::get_if<WatchedContacts>(&request.target);
    const bool is_body = body != nullptr && asks_for(request, [&](const Quantity& one) {
                             return part_of(one) == SnapshotPart::contact &&
                                    explain_missing(one.word, request.target, model).empty();
                         });
    if (rod == nullptr && !is_body) {
        if (table.with)
            context.add_fault(table,
                              table.with,
                              "goes with a rod as a whole as `at`, or a body and contact quantities, in a "
                              "deck with contact");
        return;
    }
    const int index = is_body ? static_cast<int>(model.rods.size()) + body->index : rod->contact.rod;
    const std::string& name = is_body ? model.bodies[static_cast<std::size_t>(body->index)].name
                                      : model.rods[static_cast<std::size_t>(index)].name;
    const bool asks_contact =
        asks_for(request, [](const Quantity& one) { return part_of(one) == SnapshotPart::contact; });
    if (!is_body && !asks_contact) {
        if (table.with) context.add_fault(table, table.with, "goes with contact quantities");
        return;
    }
    if (model.contact.is_empty()) return;  // the quantities are refused
    if (!is_body && model.contact.radii[static_cast<std::size_t>(index)] == 0.0) {
        context.add_fault(table,
                          table.at,
                          fmt::format("\"{}\" touches nothing; expected a point of it, as in \"{}@0.5\", or "
                                      "this rod among `rods` of [contact]",
                                      name,
                                      name));
        return;
    }
    ContactWatch& contact = is_body ? body->contact.emplace() : rod->contact;
    contact.rod = index;
    contact.wants_gap = asks_for(request, [](const Quantity& one) { return one.is_searched; });
    if (!table.with) return;
    request.with = *table.with;
    set_other(table, name, is_body, contact, context);
}

// '; did you mean "axial_force"?', of what the thing has instead of a word that means something else
// elsewhere; "" if nothing is meant.
std::string suggest_quantity(const std::string& word, const Watched& target, const Model& model) {
    std::vector<std::string> there = list_quantity_words();
    std::erase_if(there,
                  [&](const std::string& one) { return !explain_missing(one, target, model).empty(); });
    const std::string meant = find_choice(word, there);
    return meant.empty() ? "" : fmt::format("; did you mean \"{}\"?", meant);
}

void add_quantities(const HistoryKeys& table, HistoryRequest& request, const BuildContext& context) {
    for (const CheckedWord& word : table.quantities.words) {
        auto& listed = request.quantities;
        if (std::find(listed.begin(), listed.end(), word.word) != listed.end()) {
            context.faults.add(word.place, word.path, fmt::format("\"{}\" is listed twice", word.word));
            continue;
        }
        std::string reason = explain_missing(word.word, request.target, context.model);
        if (!reason.empty()) reason += suggest_quantity(word.word, request.target, context.model);
        if (table.relative_to && !can_be_relative(word.word, request.target))
            reason = "cannot be relative to a point; write another history for it";
        if (!reason.empty())
            context.faults.add(word.place, word.path, fmt::format("\"{}\": {}", word.word, reason));
        listed.push_back(word.word);
    }
}

HistoryRequest build_history(const HistoryKeys& table,
                             const WatchedText& watched,
                             const BuildContext& context) {
    HistoryRequest request{.name = table.name, .at = watched.text, .target = watched.thing};
    set_reference(table, request, context);
    add_quantities(table, request, context);
    set_about(table, request, context);
    set_no_load(table, request, context);
    set_contact(table, request, context);
    set_stress_keys(table, request, context);
    return request;
}

}  // namespace

std::vector<HistoryRequest> build_histories(const BuildContext& context) {
    std::vector<HistoryRequest> histories;
    std::set<std::string> taken;
    for (const HistoryKeys& table : tables_of<HistoryKeys>(context.deck, history_table())) {
        std::vector<WatchedText> watched;
        for (const CheckedWord& word : table.at.words) {
            for (WatchedText& one : find_watched(word.word, context)) watched.push_back(std::move(one));
        }
        const bool is_alone = table.at.words.size() == 1 &&
                              table.at.words.front().word.find('*') == std::string::npos &&
                              watched.size() < 2;
        if (is_alone || watched.empty()) check_name(table, table.name, taken, context);
        for (std::size_t i = 0; i < watched.size(); ++i) {
            HistoryRequest request = build_history(table, watched[i], context);
            if (!is_alone) {
                request.name = fmt::format("{}_{}", table.name, i + 1);
                check_name(table, request.name, taken, context);
            }
            histories.push_back(std::move(request));
        }
    }
    return histories;
}

}  // namespace gxrod
