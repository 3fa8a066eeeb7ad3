#include "deck/analyses/build_initial.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/places/part.hpp"
#include "deck/schema/schema_tables.hpp"
#include "rotation/vector_text.hpp"

namespace gxrod {
namespace {

struct SpinTable : TableHead {
    Vec3 axis = Vec3::Zero();
    Vec3 through = Vec3::Zero();
    double rate = 0.0;
};

struct InitialTable : TableHead {
    TableNames on;
    std::optional<CheckedPlaceVector> velocity, angular_velocity;
    std::optional<SpinTable> spin;
};

const TableSpec& spin_table() {
    using T = SpinTable;
    // clang-format off
    static const TableSpec table = Table<T>("initial.spin", "")
        .key("axis", &T::axis, "Its direction, of any length.")
            .unit("1").required()
        .key("through", &T::through, "A point of the axis.")
            .unit("length")
        .key("rate", &T::rate, "Right-handed about the axis.")
            .unit("angle/time").required();
    // clang-format on
    return table;
}

}  // namespace

const TableSpec& initial_table() {
    using T = InitialTable;
    // clang-format off
    static const TableSpec table = Table<T>("[[initial]]",
            "The velocities of the nodes of rods and bodies at t = 0. For dynamic analyses.")
        .key("on", &T::on, "The name of a rod or body, or a list of them.")
            .required().names_of({"rod", "body"}).also("at rod body part")
        .key("velocity", &T::velocity,
             "Global components; x, y, z is the place at t = 0, and s the arc length from a rod's start.")
            .unit("length/time").otherwise("[0, 0, 0]").also("v")
        .key("angular_velocity", &T::angular_velocity, "Global components, in the same variables.")
            .unit("angle/time").otherwise("[0, 0, 0]").also("omega w")
        .key("spin", &T::spin, spin_table(),
             "Turns all of them as one rigid body about an axis, in addition to velocity.")
        .not_here("displacement", "a deck says where things are at t = 0, so that there is no other displacement: "
             "draw the rods where they start, and what is not free of stress there comes from a static analysis")
        .not_here("position pos", "a deck says where things are at t = 0: the line of a rod, the `at` of a body")
        .not_here("rotation", "a deck says where things are at t = 0: the line of a rod, the rotation_vector of a body")
        .not_here("acceleration", "accelerations at t = 0 follow from the loads")
        .at_least_one_of({"velocity", "angular_velocity", "spin"})
        .at_most_one_of({"angular_velocity", "spin"})
        .shown_by(
            "[[initial]]\n"
            "on = \"tail\"\n"
            "angular_velocity = [0, 0, \"2*s\"]\n");
    // clang-format on
    return table;
}

namespace {

// Velocities of one node nearer than this, relative to the largest that either key gives, are the same.
constexpr double same_velocity = 1e-9;

// A node of the part, where expressions are evaluated.
struct Station {
    int node = 0;
    double s = 0.0;
};

// Every node of a rod at least once; that of a corner, or where the rod closes, as often as elements meet
// there.
std::vector<Station> find_stations(const Part& part, const BuildContext& context) {
    std::vector<Station> stations;
    if (part.body >= 0) {
        if (context.body_nodes[part.body] >= 0) stations.push_back({context.body_nodes[part.body], 0.0});
        return stations;
    }
    const Rod& rod = context.model.rods[part.rod];
    for (std::size_t i = 0; i < rod.element_nodes.size(); ++i) {
        stations.push_back({rod.element_nodes[i], rod.arc_length[i]});
    }
    return stations;
}

// The values at the stations; none, and a fault, if one is not finite.
std::vector<Vec3> evaluate(const CheckedPlaceVector& components,
                           const std::vector<Station>& stations,
                           const BuildContext& context) {
    std::vector<Vec3> values(stations.size());
    for (int i = 0; i < 3; ++i) {
        try {
            for (std::size_t k = 0; k < stations.size(); ++k) {
                const Vec3& position = context.model.nodes[stations[k].node].position;
                values[k][i] = components[i].expression.function(position, stations[k].s);
            }
        } catch (const EvaluationError& error) {
            context.add_evaluation_fault(components[i].place, components[i].path, error);
            return {};
        }
    }
    return values;
}

bool check_variables(const CheckedPlaceVector& components, const Part& part, const BuildContext& context) {
    bool is_valid = true;
    for (const CheckedPlaceFunction& component : components) {
        if (part.rod >= 0 || !component.expression.has_arc_length) continue;
        context.faults.add(
            component.place, component.path, "s is the arc length along a rod; this is a body");
        is_valid = false;
    }
    return is_valid;
}

// One of the two velocities of nodes.
struct Velocity {
    std::optional<CheckedPlaceVector> InitialTable::*field;
    Vec3 Node::*member;
    std::size_t setting;  // index in BuildContext::velocity_settings

    bool is_angular() const { return setting == 1; }
};

// How a rigid body turns about a line.
struct Spin {
    Vec3 rate = Vec3::Zero();     // angular velocity
    Vec3 through = Vec3::Zero();  // a point of the line
};

// nullopt without one, or with a fault.
std::optional<Spin> find_spin(const InitialTable& given, const BuildContext& context) {
    if (!given.spin) return std::nullopt;
    const Vec3& axis = given.spin->axis;
    if (axis.isZero(0.0)) {
        context.add_fault(*given.spin, axis, "expected a direction, found a vector of zero length");
        return std::nullopt;
    }
    return Spin{given.spin->rate * axis.stableNormalized(), given.spin->through};
}

// What the spin adds to a velocity at each station.
void add_spin(const Spin& spin,
              const Velocity& velocity,
              const std::vector<Station>& stations,
              const BuildContext& context,
              std::vector<Vec3>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Vec3& position = context.model.nodes[stations[i].node].position;
        values[i] += velocity.is_angular() ? spin.rate : spin.rate.cross(position - spin.through);
    }
}

void set_velocity(const InitialTable& given,
                  const Part& part,
                  const Velocity& velocity,
                  const std::optional<Spin>& spin,
                  BuildContext& context) {
    const std::optional<CheckedPlaceVector>& field = given.*velocity.field;
    if (!field && !spin) return;
    const std::vector<Station> stations = find_stations(part, context);
    std::vector<Vec3> values(stations.size(), Vec3::Zero());
    if (field) {
        if (!check_variables(*field, part, context)) return;
        values = evaluate(*field, stations, context);
    }
    if (spin) add_spin(*spin, velocity, stations, context, values);
    const void* own = field ? static_cast<const void*>(&field) : &given.spin;
    double size = 0.0;
    for (const Vec3& value : values) size = std::max(size, value.norm());
    for (std::size_t i = 0; i < values.size(); ++i) {
        Node& node = context.model.nodes[stations[i].node];
        VelocitySetting& setting = context.velocity_settings[stations[i].node][velocity.setting];
        if (setting.table == nullptr) {
            setting = {&given, own, size};
            node.*velocity.member = values[i];
        } else if ((node.*velocity.member - values[i]).norm() >
                   same_velocity * std::max(size, setting.size)) {
            return context.faults.add(
                given.place_of(own),
                given.path_of(own),
                fmt::format("gives {} to {}, to which {} gives {}; a node has one velocity",
                            in_brackets(values[i]),
                            node.name,
                            setting.table->path_of(setting.field),
                            in_brackets(node.*velocity.member)));
        }
    }
}

}  // namespace

void build_initial(BuildContext& context) {
    context.velocity_settings.resize(context.model.nodes.size());
    for (const InitialTable& given : tables_of<InitialTable>(context.deck, initial_table())) {
        if (!context.has_velocities()) {
            context.reject_velocities(given.place, given.path);
            continue;
        }
        const std::optional<Spin> spin = find_spin(given, context);
        for (const Part& part : find_parts(given, given.on, context)) {
            set_velocity(given, part, {&InitialTable::velocity, &Node::velocity, 0}, spin, context);
            set_velocity(
                given, part, {&InitialTable::angular_velocity, &Node::angular_velocity, 1}, spin, context);
        }
    }
}

}  // namespace gxrod
