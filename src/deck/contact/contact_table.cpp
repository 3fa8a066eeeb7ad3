#include "deck/contact/contact_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "deck/analyses/analysis_table.hpp"
#include "deck/contact/build_contact_exceptions.hpp"
#include "deck/contact/contact_bodies.hpp"
#include "deck/contact/obstacle_table.hpp"
#include "deck/rods/rod_table.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/table/table.hpp"
#include "model/settings/scheme_card.hpp"

namespace gxrod {
namespace {

const TableSpec& contact_pair_table() {
    using T = ContactPairTable;
    static const TableSpec friction = contact_friction_table("contact.pair");
    // clang-format off
    static const TableSpec table = Table<T>("[[contact.pair]]",
            "What is different for some of what touches; of those that fit, the last one counts.")
        .key("between", &T::between, "Rods and obstacles; a rod twice for what touches itself. Elements of the rod end "
             "where a part of it ends; on a rod from a mesh a part ends where elements do.")
            .required().also("rods names of")
        .key("friction", &T::friction, friction, "Coulomb's coefficient there.")
            .unit("1").at_least(0).also("mu friction_coefficient")
        .key("restitution", &T::restitution, "Coefficient of impacts there, as in [contact].")
            .unit("1").above(0).at_most(1).also("e cor coefficient_of_restitution")
        .key("off", &T::off, "true: they pass through each other.")
            .also("ignore exclude disabled")
        .at_least_one_of({"friction", "restitution", "off"})
        .at_most_one_of({"friction", "off"})
        .at_most_one_of({"restitution", "off"});
    // clang-format on
    return table;
}

}  // namespace

const TableSpec& contact_table() {
    using T = ContactKeys;
    static const TableSpec friction = contact_friction_table("contact");
    // clang-format off
    static const TableSpec table = Table<T>("[contact]",
            "Rods touch each other, themselves and every [obstacle.NAME]; without it obstacles alone. So do bodies "
            "with a sphere or capsule.")
        .key("rods", &T::rods, "Which rods touch; their sections have a radius.")
            .otherwise("all rods").names_of({"rod"})
        .key("each_other", &T::each_other, "Whether different rods and bodies touch.")
            .otherwise("true")
        .key("self", &T::self, "Whether a rod touches itself.")
            .otherwise("true")
        .key("bend_radius", &T::bend_radius, "The tightest bend to expect of rods that touch each other: they touch as "
             "straight pieces, so short that their chords stay within a quarter of the skin.")
            .unit("length").above(0).otherwise("10 radii")
        .key("friction", &T::friction, friction, "Coulomb's coefficient of rods with each other, and of obstacles that have none "
             "of their own, on the surface.")
            .unit("1").at_least(0).otherwise("0").also("mu friction_coefficient")
        .key("skin", &T::skin, "Contact acts below this gap, times the radius of the rod; no gap ever closes.")
            .unit("1").above(0).at_most(1).also("gap thickness margin range")
        .key("dissipation", &T::dissipation, "Of impacts on obstacles: with 0 they keep their energy at every step "
             "size, with 1 contact gives back least.")
            .unit("1").between(0, 1).otherwise("1; 0 with a `restitution`").also("loss")
        .key("damping", &T::damping, "Of impacts: the force is multiplied by 1 − damping times the rate of the gap, "
             "and never pulls. Next to `dissipation`, whose loss depends on the step.")
            .unit("time/length").at_least(0).also("hunt_crossley damper viscosity c")
        .key("restitution", &T::restitution, "Coefficient of impacts, of obstacles that have none of their own and of "
             "bodies with each other: the speed of a rebound over that of the approach, once steps resolve it.")
            .unit("1").above(0).at_most(1).also("e cor coefficient_of_restitution bounce")
        .key("pair", &T::pairs, contact_pair_table(), "Exceptions.")
            .also("pairs exceptions exclude ignore")
        .at_most_one_of({"damping", "restitution"})
        .shown_by(
            "[contact]\n"
            "rods       = [\"spring\", \"bow\"]\n"
            "each_other = false\n"
            "friction   = 0.3\n"
            "\n"
            "[[contact.pair]]\n"
            "between  = [\"bow\", \"floor\"]\n"
            "friction = 0.6\n");
    // clang-format on
    return table;
}

namespace {

// Of a rod: that of its section, or the largest of its sections; 0 if one has none.
double find_radius(const Rod& rod, const Model& model) {
    if (!rod.has_varying_sections()) return model.sections[static_cast<std::size_t>(rod.section)].radius;
    double radius = 0.0;
    for (const Section& section : rod.varying.at_nodes) {
        if (section.radius == 0.0) return 0.0;
        radius = std::max(radius, section.radius);
    }
    return radius;
}

void set_radii(const ContactKeys* table, Contact& contact, const BuildContext& context) {
    const std::vector<Rod>& rods = context.model.rods;
    contact.radii.assign(rods.size(), 0.0);
    std::vector<std::size_t> touching(rods.size());
    std::iota(touching.begin(), touching.end(), std::size_t{0});
    if (table != nullptr && table->rods) {
        touching.clear();
        for (const CheckedWord& word : table->rods->names) {
            for (std::size_t i = 0; i < rods.size(); ++i) {
                if (rods[i].name == word.word) touching.push_back(i);
            }
        }
    }
    const auto tables = rods_of(context.deck);
    for (const std::size_t i : touching) {
        contact.radii[i] = find_radius(rods[i], context.model);
        if (contact.radii[i] > 0.0) continue;
        const RodTable& rod = tables[i];
        context.faults.add(rod.place,
                           rod.path,
                           "touches obstacles, but its section has no radius; expected `radius` in the "
                           "[section.NAME], or `rods` in [contact] without this one");
    }
}

// That of [contact], then that of each obstacle that has its own; what the deck says of pairs comes after
// them.
void add_usual_restitutions(const ContactKeys* table, Contact& contact, const BuildContext& context) {
    std::vector<ContactPart> touching, obstacles;
    const int rods = static_cast<int>(contact.radii.size());
    for (int rod = 0; rod < rods; ++rod) touching.push_back({.index = rod});
    for (const int body : contact.touching_bodies()) touching.push_back({.index = rods + body});
    for (int i = 0; i < static_cast<int>(contact.obstacles.size()); ++i)
        obstacles.push_back({.index = -1 - i});
    if (table != nullptr && table->restitution) {
        std::vector<ContactPart> others = touching;
        others.insert(others.end(), obstacles.begin(), obstacles.end());
        contact.exceptions.push_back({.between = {touching, others}, .restitution = table->restitution});
    }
    std::size_t index = 0;
    for (const ObstacleTable& given : tables_of<ObstacleTable>(context.deck, obstacle_table())) {
        const ContactPart own = obstacles[index++];
        if (given.restitution)
            contact.exceptions.push_back({.between = {touching, {own}}, .restitution = given.restitution});
    }
}

bool weakens(const Contact& contact) {
    const auto of = [](const auto& one) { return one.friction_shape.weakens(); };
    return of(contact) || std::ranges::any_of(contact.obstacles, of) ||
           std::ranges::any_of(contact.exceptions, of);
}

// The key that chose the scheme.
void add_scheme_fault(const AnalysisTable& table, const std::string& message, const BuildContext& context) {
    if (table.gives(table.integrator)) return context.add_fault(table, table.integrator, message);
    if (table.accuracy) return context.add_fault(table, table.accuracy, message);
    context.add_fault(table, table.kind, message);
}

// What cannot be had together with contact, at the keys that ask for it.
void check_stage(const AnalysisTable& table,
                 const AnalysisSettings& analysis,
                 bool spins,
                 const BuildContext& context) {
    if (const auto* path = std::get_if<PathSettings>(&analysis)) {
        for (const Obstacle& obstacle : context.model.contact.obstacles) {
            if (obstacle.motion)
                context.add_fault(
                    table,
                    table.kind,
                    fmt::format("a path cannot move obstacle {}: it solves for the load factor, "
                                "on which that would depend; expected static, or the obstacle at "
                                "rest and supports that move",
                                obstacle.name));
        }
        const std::vector<ContactBody>& shapes = context.model.contact.bodies;
        for (std::size_t i = 1; i < shapes.size(); ++i) {
            if (shapes[i].body != shapes[i - 1].body || shapes[i].radius == shapes[i - 1].radius) continue;
            const Body& body = context.model.bodies[static_cast<std::size_t>(shapes[i].body)];
            context.add_fault(table,
                              table.kind,
                              fmt::format("a path finds where contact begins by one skin for each body: "
                                          "expected one radius for all shapes of {}",
                                          body.name));
            break;
        }
        if (path->limit_load_factor)
            context.add_fault(
                table,
                table.kind,
                "limit points cannot be followed with contact yet; expected a path for each value");
    }
    if (spins)
        context.add_fault(table,
                          table.kind,
                          "what spins in a frame at rest touches nothing; expected a deck without contact");
    const auto* timed = std::get_if<DynamicSettings>(&analysis);
    if (timed == nullptr || !timed->has_inertia) return;
    const SchemeCard& card = card_of(timed->scheme);
    if (card.resolves_contact) {
        if (weakens(context.model.contact))
            add_scheme_fault(table,
                             "friction that falls with the speed (`kinetic`) does not go with schemes that "
                             "resolve impacts; expected integrator = \"generalized-alpha\" or "
                             "\"newmark-simplified\"",
                             context);
        return;
    }
    if (card.takes_contact) {
        // docs/theory/contact.md#time
        constexpr double rounding = 1e-12;
        if (card.parameters == SchemeParameters::newmark &&
            std::abs(timed->beta - 0.5 * timed->gamma) > rounding)
            context.add_fault(table,
                              table.gives(table.beta) ? table.beta : table.gamma,
                              fmt::format("with contact and damping this scheme can gain energy; expected "
                                          "beta = {}, half of gamma",
                                          0.5 * timed->gamma));
        return;
    }
    add_scheme_fault(
        table,
        "this scheme does not go with contact; expected integrator = \"generalized-alpha\", which damps what "
        "is faster than the steps, or \"newmark-simplified\"; or `accuracy`, \"radau-5\" or \"sdirk-4\", "
        "whose steps resolve impacts",
        context);
}

}  // namespace

const ContactKeys* find_contact(const CheckedTable& deck) {
    const auto tables = tables_of<ContactKeys>(deck, contact_table());
    return tables.empty() ? nullptr : &tables.front().get();
}

void build_contact(BuildContext& context) {
    const ContactKeys* table = find_contact(context.deck);
    if (table == nullptr && context.deck.tables("obstacle").empty()) return;
    Contact& contact = context.model.contact;
    if (table != nullptr) {
        contact.between_rods = table->each_other;
        contact.within_rods = table->self;
        contact.skin = table->skin;
        contact.damping = table->damping;
        const ContactFriction friction = find_contact_friction(table->friction, context);
        contact.friction = friction.coefficient;
        contact.friction_shape = friction.shape;
    }
    set_radii(table, contact, context);
    for (const double radius : contact.radii)
        contact.bend_radii.push_back(table != nullptr && table->bend_radius ? *table->bend_radius
                                                                            : 10.0 * radius);
    build_obstacles(contact, context);
    set_contact_bodies(contact, context);
    add_usual_restitutions(table, contact, context);
    if (table != nullptr) {
        for (ContactException& one : build_contact_exceptions(*table, context))
            contact.exceptions.push_back(std::move(one));
    }
    contact.dissipation = contact.has_restitution() ? 0.0 : 1.0;
    if (table != nullptr && table->dissipation) contact.dissipation = *table->dissipation;
    check_rooms(context);
    if (context.stage == 0 && contact.is_empty())
        context.faults.add(table->place, table->path, "nothing to touch: no rods, and no [obstacle.NAME]");
}

void check_contact(const BuildContext& context) {
    check_contact_bodies(context);
    if (context.model.contact.is_empty()) return;
    const auto tables = list_analyses(context.deck);
    for (std::size_t i = 0; i < context.stages.size(); ++i) {
        const StagePlan& stage = context.stages[i];
        const auto& rotation = i == 0 ? context.model.rotation : stage.actions.rotation;
        check_stage(tables[i], stage.analysis, rotation && rotation->is_at_rest(), context);
    }
}

}  // namespace gxrod
