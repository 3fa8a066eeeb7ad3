#include "deck/contact/contact_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "deck/bodies/body_table.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/schema/top_level.hpp"

namespace gxrod {
namespace {

// A shape of a body, as the deck has it and as contact sees it, without its force.
struct GivenShape {
    const BodyShapeTable* table;
    ContactBody shape{};
};

// The spheres of a body, then its capsules.
std::vector<GivenShape> list_shapes(const BodyTable& body) {
    std::vector<GivenShape> shapes;
    const auto add = [&](const BodyShapeTable& table, const Vec3& from, const Vec3& to) {
        shapes.push_back({&table, {.ends = {from, to}, .radius = table.radius}});
    };
    for (const BodySphereTable& one : body.spheres) add(one, one.centre, one.centre);
    for (const BodyCapsuleTable& one : body.capsules) add(one, one.from, one.to);
    return shapes;
}

// The largest of gravity and of a rotation there, at a few times: they can be ramped up.
double find_acceleration(const Vec3& place, const BuildContext& context) {
    double largest = 0.0;
    for (const double t : {0.0, 0.5, 1.0}) {
        if (top_level_of(context.deck).gravity) largest = std::max(largest, context.model.gravity(t).norm());
        if (const auto& frame = context.model.rotation; frame && !frame->is_at_rest()) {
            const Vec3 spin = frame->spin(t);
            largest = std::max(largest, spin.cross(spin.cross(place - frame->through)).norm());
        }
    }
    return largest;
}

// Of the rods that touch: the least concentrated force that leaves half of their skin; 0 without a rod.
double find_force_of_rods(const Contact& contact, const Model& model) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t rod = 0; rod < contact.radii.size(); ++rod) {
        if (contact.radii[rod] == 0.0) continue;
        const auto section = static_cast<std::size_t>(model.rods[rod].section);
        least = std::min(least, model.sections[section].stiffness(0, 0) / 1000.0);
    }
    return std::isinf(least) ? 0.0 : least;
}

// That leaves half the skin: so large that the skin can take the weight, and the energy of the velocity at
// t = 0.
double find_force(const Body& body, double skin, const Contact& contact, const BuildContext& context) {
    const Node& node = context.model.nodes[static_cast<std::size_t>(body.node)];
    const double speed = node.velocity.norm();
    return std::max({1000.0 * body.mass * find_acceleration(node.position, context),
                     4.0 * body.mass * speed * speed / skin,
                     find_force_of_rods(contact, context.model)});
}

// A hollow obstacle that is no wider than the body.
void check_room(const BodyShapeTable& shape,
                const ContactBody& own,
                const Contact& contact,
                const BuildContext& context) {
    for (const Obstacle& obstacle : contact.obstacles) {
        const RoundShape* round = obstacle.round();
        if (round == nullptr || !round->is_hollow || own.radius < round->radius) continue;
        context.add_fault(
            shape,
            shape.radius,
            fmt::format("this body is to be inside of \"{}\", which is no wider: its radius is {:.6g}",
                        obstacle.name,
                        round->radius));
    }
}

}  // namespace

void set_contact_bodies(Contact& contact, const BuildContext& context) {
    int body = -1;
    for (const BodyTable& given : tables_of<BodyTable>(context.deck, body_table())) {
        ++body;
        if (context.body_nodes[static_cast<std::size_t>(body)] < 0) continue;
        for (const BodyCapsuleTable& capsule : given.capsules) {
            if (capsule.from == capsule.to)
                context.add_fault(
                    capsule, capsule.to, "expected an end away from its start; a `sphere` has no length");
        }
        const Body& built = context.model.bodies[static_cast<std::size_t>(body)];
        for (auto& [table, own] : list_shapes(given)) {
            own.body = body;
            own.force =
                table->force ? *table->force : find_force(built, contact.skin * own.radius, contact, context);
            if (own.force == 0.0 && context.stage == 0)
                context.add_fault(
                    *table,
                    table->force,
                    "missing: neither weight nor velocity, nor rods that touch, say how large forces "
                    "are; expected that which leaves half the skin, well above the largest to expect");
            check_room(*table, own, contact, context);
            contact.bodies.push_back(own);
        }
    }
}

void check_contact_bodies(const BuildContext& context) {
    const Contact& contact = context.model.contact;
    std::vector<const BodyShapeTable*> shapes;  // of each body the first
    for (const BodyTable& given : tables_of<BodyTable>(context.deck, body_table())) {
        const std::vector<GivenShape> all = list_shapes(given);
        if (all.empty()) continue;
        const BodyShapeTable* shape = all.front().table;
        shapes.push_back(shape);
        if (contact.obstacles.empty() && !contact.between_rods)
            context.faults.add(
                shape->place,
                shape->path,
                "touches nothing; expected an [obstacle.NAME], or [contact], by which bodies touch "
                "rods and each other");
    }
    if (shapes.empty()) return;
    const bool has_rods = !context.model.rods.empty();
    if (!contact.between_rods && (has_rods || shapes.size() > 1))
        context.notes.push_back(
            fmt::format("bodies with a sphere or capsule pass through {}{}{}: only {} lets them touch",
                        has_rods ? "rods" : "",
                        has_rods && shapes.size() > 1 ? " and " : "",
                        shapes.size() > 1 ? "each other" : "",
                        "each_other of [contact]"));
    const auto find_tangent = [](const AnalysisSettings& analysis) {
        return std::visit(
            [](const auto& settings) {
                if constexpr (requires { settings.newton.tangent; }) return settings.newton.tangent;
                return TangentKind::automatic;
            },
            analysis);
    };
    for (const StagePlan& stage : context.stages) {
        if (find_tangent(stage.analysis) != TangentKind::paper) continue;
        context.faults.add(shapes.front()->place,
                           shapes.front()->path,
                           "what turns by newton.tangent = \"paper\" cannot be kept from obstacles; expected "
                           "another tangent");
    }
}

}  // namespace gxrod
