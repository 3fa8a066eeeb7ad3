#include "deck/analyses/build_initial.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/places/part.hpp"
#include "deck/schema/schema_tables.hpp"
#include "rotation/vector_text.hpp"

namespace gxrod {
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
    const char* key;
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
std::optional<Spin> find_spin(const CheckedTable& table, const BuildContext& context) {
    if (!table.gives("spin")) return std::nullopt;
    const CheckedTable& spin = table.tables("spin").front();
    const Vec3& axis = spin.get<Vec3>("axis");
    if (axis.isZero(0.0)) {
        context.add_fault(spin, "axis", "expected a direction, found a vector of zero length");
        return std::nullopt;
    }
    return Spin{spin.get<double>("rate") * axis.stableNormalized(), spin.get<Vec3>("through")};
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

void set_velocity(const CheckedTable& table,
                  const Part& part,
                  const Velocity& velocity,
                  const std::optional<Spin>& spin,
                  BuildContext& context) {
    const bool is_given = table.gives(velocity.key);
    if (!is_given && !spin) return;
    const std::vector<Station> stations = find_stations(part, context);
    std::vector<Vec3> values(stations.size(), Vec3::Zero());
    if (is_given) {
        const auto& components = table.get<CheckedPlaceVector>(velocity.key);
        if (!check_variables(components, part, context)) return;
        values = evaluate(components, stations, context);
    }
    if (spin) add_spin(*spin, velocity, stations, context, values);
    const std::string key = is_given ? velocity.key : "spin";
    double size = 0.0;
    for (const Vec3& value : values) size = std::max(size, value.norm());
    for (std::size_t i = 0; i < values.size(); ++i) {
        Node& node = context.model.nodes[stations[i].node];
        VelocitySetting& setting = context.velocity_settings[stations[i].node][velocity.setting];
        if (setting.table == nullptr) {
            setting = {&table, key, size};
            node.*velocity.member = values[i];
        } else if ((node.*velocity.member - values[i]).norm() >
                   same_velocity * std::max(size, setting.size)) {
            return context.add_fault(
                table,
                key,
                fmt::format("gives {} to {}, to which {} gives {}; a node has one velocity",
                            in_brackets(values[i]),
                            node.name,
                            setting.table->path_of(setting.key),
                            in_brackets(node.*velocity.member)));
        }
    }
}

}  // namespace

void build_initial(BuildContext& context) {
    context.velocity_settings.resize(context.model.nodes.size());
    for (const CheckedTable& table : context.deck.tables("initial")) {
        if (!context.has_velocities()) {
            context.faults.add(table.place, table.path, context.explain_no_velocities());
        }
        const std::optional<Spin> spin = find_spin(table, context);
        for (const Part& part : find_parts(table, *initial_table().find("on"), context)) {
            set_velocity(table, part, {"velocity", &Node::velocity, 0}, spin, context);
            set_velocity(table, part, {"angular_velocity", &Node::angular_velocity, 1}, spin, context);
        }
    }
}

}  // namespace gxrod
