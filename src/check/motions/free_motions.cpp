#include "check/motions/free_motions.hpp"

#include "rotation/vector_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gxrod {

namespace {

constexpr double unresisted = 1e-12;  // of the stiffest unknown
constexpr double aligned = 1e-6;      // what counts as zero in a unit vector
constexpr double near = 1e-3;         // of the model's length: what counts as on an axis

std::string describe_vector(Vec3 direction) {
    static constexpr const char* axes[3] = {"x", "y", "z"};
    direction.normalize();
    for (int i = 0; i < 3; ++i) {
        if (std::abs(direction[i]) > 1.0 - aligned) return axes[i];
    }
    for (int i = 0; i < 3; ++i) {
        if (std::abs(direction[i]) < aligned) continue;
        if (direction[i] < 0.0) direction = -direction;
        break;
    }
    const Vec3 rounded = (direction * 1000.0).array().round() / 1000.0;
    return in_parentheses(rounded, 3);
}

// A straight line in space.
struct Axis {
    Vec3 point, direction;
    double distance(const Vec3& r) const { return direction.cross(r - point).norm(); }
};

// How a turning part's axis is said: its own if all nodes lie on it, else with a node or point on it.
std::string describe_axis(const Axis& axis, const ModelPart& part, const System& system, const State& state) {
    const double tolerance = near * system.length_scale();
    const auto is_on_axis = [&](int node) { return axis.distance(state.trial[node].r) < tolerance; };
    std::string direction = describe_vector(axis.direction);
    if (part.nodes.size() == 1) return direction;
    const auto first = std::find_if(part.nodes.begin(), part.nodes.end(), is_on_axis);
    if (first != part.nodes.end()) {
        if (std::all_of(first, part.nodes.end(), is_on_axis) && first == part.nodes.begin())
            return "its own axis";
        return fmt::format("{} through {}", direction, system.model().nodes[*first].name);
    }
    const double rounding = 1e-9 * system.length_scale();
    const auto component = [&](int i) { return std::abs(axis.point[i]) < rounding ? 0.0 : axis.point[i]; };
    return fmt::format(
        "{} through ({:.4g}, {:.4g}, {:.4g})", direction, component(0), component(1), component(2));
}

bool is_held(const std::vector<Vec6>& direction, const ModelPart& part, const System& system) {
    for (const int node : part.nodes) {
        const Vec6 own = system.equations().to_own_axes(node, direction[node]);
        for (int i = 0; i < 6; ++i) {
            if (system.supports().held(node)[i] && std::abs(own[i]) > aligned) return true;
        }
    }
    return false;
}

std::vector<Vec3> find_points(const ModelPart& part, const System& system, const State& state) {
    constexpr std::size_t most_points = 4;
    std::vector<Vec3> points;
    for (const int node : part.nodes) {
        const HeldComponents& held = system.supports().held(node);
        if (points.size() < most_points && std::find(held.begin(), held.end(), true) != held.end()) {
            points.push_back(state.trial[node].r);
        }
    }
    if (points.empty()) points.push_back(compute_centre(part, state));
    return points;
}

std::string join_or(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) text += i + 1 == words.size() ? " or " : ", ";
        text += words[i];
    }
    return text;
}

}  // namespace

std::string describe_rigid_motion(const RigidMotion& motion,
                                  const ModelPart& part,
                                  const System& system,
                                  const State& state) {
    const double length = system.length_scale();
    const double turn = motion.rotation.norm();
    if (turn <= near * motion.displacement.norm() / length) {
        return "moves along " + describe_vector(motion.displacement);
    }
    const Vec3 direction = motion.rotation / turn;
    if (std::abs(motion.displacement.dot(direction)) > near * turn * length)
        return "moves and turns as a whole";
    const Axis axis{motion.point + motion.rotation.cross(motion.displacement) / (turn * turn), direction};
    return "turns about " + describe_axis(axis, part, system, state);
}

std::string describe_free_motions(const ModelPart& part,
                                  const ScaledTangent& tangent,
                                  const System& system,
                                  const State& state) {
    const double length = system.length_scale();
    const auto is_free = [&](const RigidMotion& motion) {
        const std::vector<Vec6> direction = compute_direction(motion, part, state, length);
        if (is_held(direction, part, system)) return false;
        const Eigen::VectorXd x = gather(direction, system.equations());
        return tangent.multiply(x).norm() <= unresisted * x.norm();
    };
    std::vector<std::string> displacements, rotations;
    for (int i = 0; i < 3; ++i) {
        if (is_free({length * Vec3::Unit(i), Vec3::Zero(), Vec3::Zero()})) {
            displacements.push_back(describe_vector(Vec3::Unit(i)));
        }
    }
    std::vector<Axis> axes;
    for (const Vec3& point : find_points(part, system, state)) {
        for (int i = 0; i < 3; ++i) {
            const RigidMotion motion{Vec3::Zero(), Vec3::Unit(i), point};
            const bool is_known = std::any_of(axes.begin(), axes.end(), [&](const Axis& axis) {
                return axis.direction == motion.rotation && axis.distance(point) < near * length;
            });
            if (is_known || !is_free(motion)) continue;
            axes.push_back({point, motion.rotation});
            rotations.push_back(displacements.empty() ? describe_axis(axes.back(), part, system, state)
                                                      : describe_vector(motion.rotation));
        }
    }
    std::string text;
    if (!displacements.empty()) text += "moves along " + join_or(displacements);
    if (!displacements.empty() && !rotations.empty()) text += ", or ";
    if (!rotations.empty()) text += "turns about " + join_or(rotations);
    return text;
}

}  // namespace gxrod
