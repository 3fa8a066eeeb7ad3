#include "deck/bodies/build_bodies.hpp"

#include <fmt/format.h>

#include "deck/schema/schema_tables.hpp"
#include "deck/surroundings/body_fluid.hpp"
#include "model/body_moments.hpp"
#include "numerics/eigenvalues.hpp"
#include "rotation/rotation_map.hpp"

namespace gxrod {
namespace {

// Relative to the largest entry: asymmetry of a matrix and excess of a principal moment that are round-off.
constexpr double round_off = 1e-9;
// A principal moment below this, relative to the largest, is zero.
constexpr double smallest_moment = 1e-15;

Mat3 inertia_of(const CheckedTable& body) {
    const auto& value = body.find("inertia")->value;
    if (const auto* principal = std::get_if<Vec3>(&value)) return principal->asDiagonal();
    return std::get<Mat3>(value);
}

// What an analysis asks of the inertia of a body.
enum class Need { any, definite };

// Why a body cannot have these principal moments, in rising order; "" if it can.
std::string explain_moments(const Vec3& moments, Need need) {
    const double size = moments.cwiseAbs().maxCoeff();
    const std::string principal = fmt::format("{:.6g}, {:.6g}, {:.6g}", moments[0], moments[1], moments[2]);
    if (need == Need::definite && !(moments[0] > smallest_moment * size)) {
        return "expected a positive definite inertia, found principal moments " + principal +
               "; a rotation without inertia cannot be integrated in time";
    }
    if (moments[0] < -round_off * size) {
        return "expected principal moments that are not negative, found " + principal;
    }
    if (is_beyond_rounding(moments)) {
        return fmt::format(
            "no body has the principal moments {}: the largest cannot be above the sum of the others; "
            "expected "
            "{:.6g} at most, or greater values of the others",
            principal,
            moments[0] + moments[1]);
    }
    return "";
}

// A node of the body's own has no other inertia, which a dynamic analysis needs.
Need find_need(const CheckedTable& body, const BuildContext& context) {
    const bool has_own_node = std::holds_alternative<Vec3>(body.find("at")->value);
    return has_own_node && context.needs_inertia() ? Need::definite : Need::any;
}

// The inertia, if a rigid body can have it.
std::optional<Mat3> find_inertia(const CheckedTable& body, const BuildContext& context) {
    if (!body.gives("inertia")) {
        if (find_need(body, context) == Need::definite) {
            context.add_fault(body,
                              "inertia",
                              fmt::format("missing; expected {}; a rotation without inertia cannot be "
                                          "integrated in time",
                                          describe_expected(*body_table().find("inertia"))));
        }
        return Mat3(Mat3::Zero());
    }
    const Mat3 given = inertia_of(body);
    const double size = given.cwiseAbs().maxCoeff();
    if ((given - given.transpose()).cwiseAbs().maxCoeff() > round_off * size) {
        context.add_fault(body, "inertia", "expected a symmetric matrix");
        return std::nullopt;
    }
    const Mat3 inertia = 0.5 * (given + given.transpose());
    const std::string reason =
        explain_moments(find_symmetric_eigen(inertia).values, find_need(body, context));
    if (reason.empty()) return inertia;
    context.add_fault(body, "inertia", reason);
    return std::nullopt;
}

// 0 where a static analysis has none.
double find_mass(const CheckedTable& body, const BuildContext& context) {
    if (body.gives("mass")) return body.get<double>("mass");
    if (context.needs_inertia()) {
        context.add_fault(body, "mass", "missing; expected " + describe_expected(*body_table().find("mass")));
    }
    return 0.0;
}

// The node of a body: that of a rod's point, or a new one. -1 if the rod has no mesh.
int find_node(const CheckedTable& body, BuildContext& context) {
    if (const auto* point = std::get_if<std::string>(&body.find("at")->value)) {
        const std::optional<PlacedPoint> placed = context.place(*point);
        return placed ? placed->node : -1;
    }
    context.model.nodes.push_back({body.name, body.get<Vec3>("at")});
    return static_cast<int>(context.model.nodes.size()) - 1;
}

// An initial velocity that a body gives its node.
struct Setting {
    const CheckedTable& body;
    const char* key;
    Vec3 value;
};

// `motion` is the velocity of the node that the setting is about.
void set_motion(const Setting& setting, VelocitySetting& record, Vec3& motion, const BuildContext& context) {
    if (!setting.body.gives(setting.key)) return;
    if (!context.has_velocities()) {
        return context.add_fault(setting.body, setting.key, context.explain_no_velocities());
    }
    if (record.table != nullptr) {
        const std::string message = record.table->path + " is at the same node and sets it too";
        return context.add_fault(setting.body, setting.key, message);
    }
    record = {&setting.body, setting.key, setting.value.norm()};
    motion = setting.value;
}

void set_velocities(const CheckedTable& table, const Body& body, BuildContext& context) {
    auto& [velocity, spin] = context.velocity_settings[body.node];
    Node& node = context.model.nodes[body.node];
    const Vec3& spatial = table.get<Vec3>("angular_velocity");
    set_motion({table, "velocity", table.get<Vec3>("velocity")}, velocity, node.velocity, context);
    set_motion({table, "angular_velocity", spatial}, spin, node.angular_velocity, context);
    if (!table.gives("angular_velocity_material")) return;
    const Vec3 turned = body.attitude * table.get<Vec3>("angular_velocity_material");
    set_motion({table, "angular_velocity_material", turned}, spin, node.angular_velocity, context);
}

}  // namespace

void build_bodies(BuildContext& context) {
    const std::vector<CheckedTable>& tables = context.deck.tables("body");
    context.body_nodes.assign(tables.size(), -1);
    for (std::size_t i = 0; i < tables.size(); ++i) {
        const CheckedTable& table = tables[i];
        Body body{.name = table.name, .mass = find_mass(table, context)};
        body.inertia = find_inertia(table, context).value_or(Mat3::Identity());
        body.centre_of_mass = table.get<Vec3>("centre_of_mass");
        body.attitude = exp_quaternion(table.get<Vec3>("rotation_vector"));
        body.fluid = find_body_fluid(table, context);
        const int node = find_node(table, context);
        context.body_nodes[i] = node;
        body.node = std::max(node, 0);
        context.model.bodies.push_back(body);
        context.velocity_settings.resize(context.model.nodes.size());
        if (node >= 0) set_velocities(table, body, context);
    }
}

}  // namespace gxrod
