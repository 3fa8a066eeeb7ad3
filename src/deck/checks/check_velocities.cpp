#include "deck/checks/check_velocities.hpp"

#include <fmt/format.h>

#include "deck/schema/choices.hpp"

namespace gxrod {
namespace {

// Velocities below this, relative to the largest that the key gives anywhere, are round-off of an attitude or
// of an expression such as sin(pi*s) at the end of a rod.
constexpr double round_off = 1e-12;
// A difference quotient is as exact as this, relative to the largest velocity that the key gives.
constexpr double same_rate = 1e-5;
// Of the difference quotient, in steps of the analysis.
constexpr double rate_step = 1e-3;

// The rate at t = 0 of a function that is 0 there, from later times alone: an extrapolated difference
// quotient.
double compute_start_rate(const TimeFunction& function, const BuildContext& context) {
    const auto& analysis = std::get<DynamicSettings>(context.analysis());
    const double step = rate_step * analysis.time_step();
    return (4.0 * function(0.5 * step) - function(step) - 3.0 * function(0.0)) / step;
}

// Three components of a support, those of the position or those of the rotation.
struct Components {
    const Support& support;
    std::size_t first;  // 0 or 3

    bool is_fixed(int i) const { return support.fixed[first + static_cast<std::size_t>(i)]; }
    bool is_moved(int i) const { return support.moved[first + static_cast<std::size_t>(i)]; }
    const TimeFunction& motion(int i) const { return support.motion[first + static_cast<std::size_t>(i)]; }
};

// What the support says of the velocity (in its own axes) that it does not allow, or "".
std::string explain(const Components& components,
                    const Vec3& velocity,
                    double size,
                    const BuildContext& context) {
    const bool has_own_axes = !components.support.axes.isApprox(Quat::Identity(), 0.0);
    const char* axes = has_own_axes ? " of its own axes" : "";
    const std::string& node = context.model.nodes[components.support.node].name;
    for (int i = 0; i < 3; ++i) {
        const auto name = component_names[components.first + static_cast<std::size_t>(i)];
        if (components.is_fixed(i) && std::abs(velocity[i]) > round_off * size) {
            return fmt::format("a [[support]] fixes {}{} at {}; expected 0 along it, found {:.6g}",
                               name,
                               axes,
                               node,
                               velocity[i]);
        }
        if (!components.is_moved(i)) continue;
        const double rate = compute_start_rate(components.motion(i), context);
        if (std::abs(velocity[i] - rate) > same_rate * std::max(size, std::abs(rate))) {
            return fmt::format(
                "a [[support]] moves {}{} at {}; expected the rate of its motion at t = 0, "
                "{:.6g}, found {:.6g}",
                name,
                axes,
                node,
                rate,
                velocity[i]);
        }
    }
    return "";
}

void check(const Components& components,
           const VelocitySetting& setting,
           Vec3& velocity,
           const BuildContext& context) {
    if (setting.table == nullptr) return;
    const Mat3 axes = components.support.axes.toRotationMatrix();
    Vec3 own = axes.transpose() * velocity;
    try {
        const std::string reason = explain(components, own, setting.size, context);
        if (!reason.empty())
            return context.faults.add(
                setting.table->place_of(setting.field), setting.table->path_of(setting.field), reason);
    } catch (const EvaluationError&) {
        return;  // check_functions reports it
    }
    bool changed = false;
    for (int i = 0; i < 3; ++i) {
        if (!components.is_fixed(i) || own[i] == 0.0) continue;
        own[i] = 0.0;
        changed = true;
    }
    if (changed) velocity = axes * own;
}

}  // namespace

void check_velocities(BuildContext& context) {
    if (context.stage > 0 || !context.has_velocities()) return;
    for (const Support& support : context.model.supports) {
        const auto& [of_position, of_rotation] = context.velocity_settings[support.node];
        Node& node = context.model.nodes[support.node];
        check({support, 0}, of_position, node.velocity, context);
        check({support, 3}, of_rotation, node.angular_velocity, context);
    }
}

}  // namespace gxrod
