#include "deck/build_bodies.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>

#include "rotation/rotation_map.hpp"

namespace gxrod {
namespace {

// Relative to the largest entry: asymmetry of a matrix and excess of a principal moment that are round-off.
constexpr double round_off = 1e-9;

Mat3 inertia_of(const CheckedTable& body) {
    const auto& value = body.find("inertia")->value;
    if (const auto* principal = std::get_if<Vec3>(&value)) return principal->asDiagonal();
    return std::get<Mat3>(value);
}

// The inertia, if a rigid body can have it.
std::optional<Mat3> find_inertia(const CheckedTable& body, const BuildContext& context) {
    const Mat3 given = inertia_of(body);
    const double size = given.cwiseAbs().maxCoeff();
    if ((given - given.transpose()).cwiseAbs().maxCoeff() > round_off * size) {
        context.add_fault(body, "inertia", "expected a symmetric matrix");
        return std::nullopt;
    }
    const Mat3 inertia = 0.5 * (given + given.transpose());
    const Vec3 moments = Eigen::SelfAdjointEigenSolver<Mat3>(inertia, Eigen::EigenvaluesOnly).eigenvalues();
    const std::string principal = fmt::format("{:.6g}, {:.6g}, {:.6g}", moments[0], moments[1], moments[2]);
    if (!(moments[0] > 1e-15 * size)) {
        context.add_fault(body,
                          "inertia",
                          "expected a positive definite inertia, found principal moments " + principal +
                              "; a rotation without inertia cannot be integrated in time");
        return std::nullopt;
    }
    if (moments[2] > moments[0] + moments[1] + round_off * size) {
        context.add_fault(body,
                          "inertia",
                          "no body has the principal moments " + principal +
                              ": the largest cannot be above the sum of the others");
        return std::nullopt;
    }
    return inertia;
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

// `setter` is the body that has set this motion of the node before, if one has.
void set_motion(const Setting& setting,
                const CheckedTable*& setter,
                Vec3& motion,
                const BuildContext& context) {
    if (!setting.body.gives(setting.key)) return;
    if (setter != nullptr) {
        const std::string message = setter->path + " is at the same node and sets it too";
        return context.add_fault(setting.body, setting.key, message);
    }
    setter = &setting.body;
    motion = setting.value;
}

}  // namespace

void build_bodies(BuildContext& context) {
    std::vector<const CheckedTable*> velocity_setters, spin_setters;
    for (const CheckedTable& table : context.deck.tables("body")) {
        Body body{.name = table.name, .mass = table.get<double>("mass")};
        body.inertia = find_inertia(table, context).value_or(Mat3::Identity());
        body.centre_of_mass = table.get<Vec3>("centre_of_mass");
        body.attitude = exp_quaternion(table.get<Vec3>("rotation_vector"));
        const int node = find_node(table, context);
        context.body_nodes.push_back(node);
        body.node = std::max(node, 0);
        context.model.bodies.push_back(body);
        if (node < 0) continue;

        velocity_setters.resize(context.model.nodes.size());
        spin_setters.resize(context.model.nodes.size());
        Node& moved = context.model.nodes[node];
        set_motion({table, "velocity", table.get<Vec3>("velocity")},
                   velocity_setters[node],
                   moved.velocity,
                   context);
        const Vec3& spatial = table.get<Vec3>("angular_velocity");
        set_motion({table, "angular_velocity", spatial}, spin_setters[node], moved.angular_velocity, context);
        if (!table.gives("angular_velocity_material")) continue;
        const Vec3 turned = body.attitude * table.get<Vec3>("angular_velocity_material");
        set_motion({table, "angular_velocity_material", turned},
                   spin_setters[node],
                   moved.angular_velocity,
                   context);
    }
}

}  // namespace gxrod
