#include "deck/contact/build_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "deck/checks/check_moves.hpp"
#include "deck/contact/build_contact_exceptions.hpp"
#include "deck/contact/contact_bodies.hpp"
#include "deck/contact/obstacle_tables.hpp"
#include "deck/joints/ends.hpp"
#include "deck/loads/acting.hpp"
#include "deck/rods/rod_table.hpp"
#include "deck/schema/choices.hpp"
#include "model/settings/scheme_card.hpp"

namespace gxrod {
namespace {

const CheckedTable& only(const CheckedTable& table, const char* key) { return table.tables(key).front(); }

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

void set_radii(const CheckedTable* table, Contact& contact, const BuildContext& context) {
    const std::vector<Rod>& rods = context.model.rods;
    contact.radii.assign(rods.size(), 0.0);
    std::vector<std::size_t> touching(rods.size());
    std::iota(touching.begin(), touching.end(), std::size_t{0});
    if (table != nullptr && table->gives("rods")) {
        touching.clear();
        for (const CheckedWord& word : table->get<std::vector<CheckedWord>>("rods")) {
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

std::optional<Vec3> find_direction(const CheckedTable& table, const char* key, const BuildContext& context) {
    const Vec3& direction = table.get<Vec3>(key);
    if (!direction.isZero(0.0)) return direction.stableNormalized();
    context.add_fault(table, key, "expected a direction, found a vector of zero length");
    return std::nullopt;
}

// Points of a smooth curve so close that cubic pieces between them are the curve but for 1e-8 of its bends.
void set_curve(const CurveTable& table, TubeShape& tube, const BuildContext& context) {
    const std::optional<Centreline> line = find_centreline(table, context);
    if (!line) return;
    constexpr double most_turn = 0.05;
    const double turn = line->turn(0, 0.0, 1.0);
    const int pieces = std::max(8, static_cast<int>(std::ceil(turn / most_turn)));
    for (int i = 0; i <= pieces; ++i) {
        const double fraction = static_cast<double>(i) / pieces;
        tube.line.push_back(line->position(0, fraction));
        tube.tangents.push_back(line->transport(0, fraction) * line->start_tangent());
    }
}

// The radius and the side of a round shape.
template <class Shape>
Shape make_round(const CheckedTable& table) {
    Shape shape;
    shape.radius = table.get<double>("radius");
    shape.is_hollow = value_of(obstacle_side_choices, table.get<std::string>("side")) == ObstacleSide::inside;
    return shape;
}

ObstacleShape build_shape(const CheckedTable& table, const BuildContext& context) {
    if (table.gives("plane")) {
        const CheckedTable& plane = only(table, "plane");
        return PlaneShape{plane.get<Vec3>("point"),
                          find_direction(plane, "normal", context).value_or(Vec3::UnitZ())};
    }
    if (table.gives("mesh")) {
        if (table.gives("stiffness"))
            context.add_fault(table,
                              "stiffness",
                              "a mesh does not yield, since neither side of it is inside; expected none");
        return MeshShape{context.obstacle_meshes.at(table.name)};
    }
    if (table.gives("sphere")) {
        const CheckedTable& given = only(table, "sphere");
        auto sphere = make_round<SphereShape>(given);
        sphere.centre = given.get<Vec3>("centre");
        return sphere;
    }
    if (table.gives("cylinder")) {
        const CheckedTable& given = only(table, "cylinder");
        auto cylinder = make_round<CylinderShape>(given);
        cylinder.from = given.get<Vec3>("from");
        cylinder.to = given.get<Vec3>("to");
        if (cylinder.from == cylinder.to)
            context.add_fault(given, "to", "expected an end away from its start");
        return cylinder;
    }
    const auto& given = static_cast<const TubeObstacleTable&>(*only(table, "tube").record);
    TubeShape tube;
    tube.radius = given.radius;
    tube.is_hollow = given.side == ObstacleSide::inside;
    set_curve(given, tube, context);
    return tube;
}

void check_room(const CheckedTable& table, std::size_t index, const BuildContext& context) {
    const Contact& contact = context.model.contact;
    const RoundShape* round = contact.obstacles[index].round();
    if (round == nullptr || !round->is_hollow) return;
    double thickest = 0.0;
    for (std::size_t rod = 0; rod < contact.radii.size(); ++rod) {
        if (!is_left_out(contact, static_cast<int>(rod), -1 - static_cast<int>(index)))
            thickest = std::max(thickest, contact.radii[rod]);
    }
    if (thickest < round->radius) return;
    context.faults.add(
        table.place,
        table.path,
        fmt::format("a rod of radius {:.6g} is to be inside, which is no narrower than its radius "
                    "{:.6g}",
                    thickest,
                    round->radius));
}

// A component of a motion in the stage at hand: f(t) after what earlier stages have moved.
TimeFunction continue_motion(const CheckedTimeFunction& given, const BuildContext& context) {
    std::vector<std::pair<TimeFunction, std::shared_ptr<const double>>> earlier;
    for (std::size_t i = 0; i < context.stage; ++i) {
        const StagePlan& stage = context.stages[i];
        if (has_steps(stage.analysis)) earlier.emplace_back(given.function, stage.end);
    }
    TimeFunction own = find_acting(context).apply(given.function);
    if (earlier.empty()) return own;
    return TimeFunction([own, earlier](double t) {
        double sum = own(t);
        for (const auto& [function, end] : earlier) sum += function(*end);
        return sum;
    });
}

void set_motion(const CheckedTable& table, Obstacle& obstacle, const BuildContext& context) {
    if (!table.gives("move")) return;
    const CheckedTable& given = only(table, "move");
    std::array<TimeFunction, 6> components;
    const double size = measure_size(context.model, {});
    for (std::size_t i = 0; i < 6; ++i) {
        const std::string name(component_names[i]);
        if (!given.gives(name)) continue;
        const auto& value = given.get<CheckedTimeFunction>(name);
        if (context.stages.size() > 1 && !value.function.has_time()) {
            context.faults.add(
                value.place, value.path, "with several stages expected an expression of t, 0 at t = 0");
            continue;
        }
        check_move(value, i < 3 ? size : 1.0, context);
        components[i] = continue_motion(value, context);
    }
    obstacle.motion = ObstacleMotion{TimeVector(std::array{components[0], components[1], components[2]}),
                                     TimeVector(std::array{components[3], components[4], components[5]}),
                                     given.get<Vec3>("about")};
}

// What cannot be had together with contact, at the keys that ask for it.
void check_stage(const CheckedTable& table,
                 const AnalysisSettings& analysis,
                 bool turns,
                 const BuildContext& context) {
    if (is_path(analysis))
        context.add_fault(
            table,
            "kind",
            "a path cannot be followed with contact yet; expected static, or dynamic with damping");
    const Contact& contact = context.model.contact;
    if (!has_steps(analysis) && (contact.between_rods || contact.within_rods))
        context.add_fault(
            table,
            "kind",
            "shapes of rods that touch each other cannot be found yet; expected each_other = false "
            "and self = false in [contact]");
    if (turns)
        context.add_fault(
            table, "kind", "contact does not turn with a frame; expected a stage without [rotation]");
    const auto* timed = std::get_if<DynamicSettings>(&analysis);
    if (timed == nullptr || !timed->has_inertia) return;
    if (card_of(timed->scheme).takes_contact) {
        // docs/theory/contact.md#time
        constexpr double rounding = 1e-12;
        if (std::abs(timed->beta - 0.5 * timed->gamma) > rounding)
            context.add_fault(table,
                              table.gives("beta") ? "beta" : "gamma",
                              fmt::format("with contact and damping this scheme can gain energy; expected "
                                          "beta = {}, half of gamma",
                                          0.5 * timed->gamma));
        return;
    }
    context.add_fault(table,
                      table.gives("integrator") ? "integrator"
                      : table.gives("accuracy") ? "accuracy"
                                                : "kind",
                      "this scheme cannot take the impulses of contact; expected integrator = "
                      "\"newmark-simplified\", with a time_step or `adaptive`; gamma = 0.6 and beta = 0.3 "
                      "damp what is faster than the steps");
}

}  // namespace

void build_contact(BuildContext& context) {
    const std::vector<CheckedTable>& settings = context.deck.tables("contact");
    const std::vector<CheckedTable>& obstacles = context.deck.tables("obstacle");
    const CheckedTable* table = settings.empty() ? nullptr : &settings.front();
    if (obstacles.empty() && table == nullptr) return;
    Contact& contact = context.model.contact;
    const auto is_on = [&](const char* key) { return !table->gives(key) || table->get<bool>(key); };
    if (table != nullptr) {
        contact.between_rods = is_on("each_other");
        contact.within_rods = is_on("self");
        contact.skin = table->get<double>("skin");
        contact.dissipation = table->get<double>("dissipation");
        contact.damping = table->get<double>("damping");
        contact.friction = table->get<double>("friction");
    }
    set_radii(table, contact, context);
    for (const double radius : contact.radii)
        contact.bend_radii.push_back(table != nullptr && table->gives("bend_radius")
                                         ? table->get<double>("bend_radius")
                                         : 10.0 * radius);
    for (const CheckedTable& given : obstacles) {
        Obstacle obstacle;
        obstacle.name = given.name;
        obstacle.shape = build_shape(given, context);
        obstacle.friction = given.gives("friction") ? given.get<double>("friction") : contact.friction;
        if (given.gives("stiffness")) obstacle.stiffness = given.get<double>("stiffness");
        set_motion(given, obstacle, context);
        contact.obstacles.push_back(std::move(obstacle));
    }
    set_contact_bodies(contact, context);
    if (table != nullptr) contact.exceptions = build_contact_exceptions(*table, context);
    for (std::size_t i = 0; i < obstacles.size(); ++i) check_room(obstacles[i], i, context);
    if (context.stage == 0 && contact.is_empty())
        context.faults.add(table->place, table->path, "nothing to touch: no rods, and no [obstacle.NAME]");
}

void check_contact(const BuildContext& context) {
    check_contact_bodies(context);
    if (context.model.contact.is_empty()) return;
    const std::vector<CheckedTable>& tables = context.deck.tables("stage");
    for (std::size_t i = 0; i < context.stages.size(); ++i) {
        const StagePlan& stage = context.stages[i];
        const auto& rotation = i == 0 ? context.model.rotation : stage.actions.rotation;
        check_stage(tables.empty() ? context.deck.tables("analysis").front() : tables[i],
                    stage.analysis,
                    rotation.has_value(),
                    context);
    }
}

}  // namespace gxrod
