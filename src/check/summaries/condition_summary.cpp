#include "check/summaries/condition_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "check/summaries/tendon_summary.hpp"
#include "check/surroundings/fluid_summary.hpp"
#include "model/evaluation_error.hpp"
#include "rotation/vector_text.hpp"

namespace gxrod {
namespace {

constexpr double round_off = 1e-15;  // of a component of a direction
constexpr std::array<const char*, 3> frames{"spatial", "follower", "body"};

// Nodes that several rods share.
ItemList list_connections(const Model& model) {
    std::vector<std::vector<int>> rods(model.nodes.size());
    for (int i = 0; i < static_cast<int>(model.rods.size()); ++i) {
        for (const int node : model.rods[i].nodes) rods[node].push_back(i);
    }
    ItemList list{"connections", {}};
    for (std::size_t node = 0; node < rods.size(); ++node) {
        if (rods[node].size() < 2) continue;
        std::vector<std::string> names;
        for (const int rod : rods[node]) names.push_back(model.rods[rod].name);
        list.items.push_back(fmt::format(
            "connection: {} is one node of rods {}\n", model.nodes[node].name, fmt::join(names, ", ")));
    }
    return list;
}

std::string describe_support(const Model& model, const Support& support) {
    std::string fixed, moved;
    for (std::size_t i = 0; i < component_names.size(); ++i) {
        if (support.fixed[i]) fixed.append(" ").append(component_names[i]);
        if (support.moved[i]) moved.append(" ").append(component_names[i]);
    }
    std::string text = fmt::format("support at {}:", model.nodes[support.node].name);
    if (!fixed.empty()) text += " fixes" + fixed;
    if (!moved.empty()) text += (fixed.empty() ? " moves" : ", moves") + moved;
    if (!support.axes.isApprox(Quat::Identity(), 0.0)) {
        const Mat3 axes = support.axes.toRotationMatrix().unaryExpr(
            [](double x) { return std::abs(x) < round_off ? 0.0 : x; });
        text += fmt::format("; x {}, y {}, z {}",
                            in_parentheses(axes.col(0)),
                            in_parentheses(axes.col(1)),
                            in_parentheses(axes.col(2)));
    }
    return text + "\n";
}

std::string describe_load(const Model& model, const NodalLoad& load) {
    return fmt::format("{} at {}:{}{}, {}\n",
                       load.key,
                       model.nodes[load.node].name,
                       load.has_force() ? " force" : "",
                       load.has_moment() ? " moment" : "",
                       frames[static_cast<std::size_t>(load.frame)]);
}

std::string describe_load(const Model& model, const DistributedLoad& load) {
    if (load.field)
        return fmt::format("{} on rod {}: in a {}magnetic field\n",
                           load.key,
                           model.rods[load.rod].name,
                           load.field->by_place ? "" : "uniform ");
    return fmt::format("{} on rod {}:{}{}, {}\n",
                       load.key,
                       model.rods[load.rod].name,
                       load.has_force() ? " force per length" : "",
                       load.has_moment() ? " moment per length" : "",
                       frames[static_cast<std::size_t>(load.frame)]);
}

// The largest velocities of some nodes; "" if all are at rest.
std::string describe_velocities(const Model& model, const std::string& name, const std::vector<int>& nodes) {
    double velocity = 0.0;
    double spin = 0.0;
    double strain_rate = 0.0;  // of extension and shear
    const Node* before = nullptr;
    for (const int node : nodes) {
        const Node& here = model.nodes[node];
        velocity = std::max(velocity, here.velocity.norm());
        spin = std::max(spin, here.angular_velocity.norm());
        if (before != nullptr) {
            const Vec3 chord = here.position - before->position;
            const Vec3 turning = 0.5 * (here.angular_velocity + before->angular_velocity).cross(chord);
            strain_rate =
                std::max(strain_rate, (here.velocity - before->velocity - turning).norm() / chord.norm());
        }
        before = &here;
    }
    if (velocity == 0.0 && spin == 0.0) return "";
    const bool is_rigid = strain_rate <= 1e-6 * spin;
    return fmt::format("initial velocities of {}: up to {:.6g}, angular velocities up to {:.6g}{}\n",
                       name,
                       velocity,
                       spin,
                       is_rigid ? "" : fmt::format(", stretched and sheared at up to {:.3g}", strain_rate));
}

std::string describe_gravity(const Model& model) {
    constexpr std::array<double, 4> times{0.0, 0.11, 0.37, 0.83};
    constexpr double near = 1e-12;
    const Vec3 end = model.gravity(1.0);
    const auto is_part = [&](const auto& part_at) {
        return std::ranges::all_of(times, [&](double t) {
            return (model.gravity(t) - part_at(t) * end).norm() <= near * end.norm();
        });
    };
    try {
        if (is_part([](double) { return 1.0; })) return fmt::format("gravity {}\n", in_parentheses(end));
        if (is_part([](double t) { return t; }))
            return fmt::format("gravity grows with t, to {} at t = 1\n", in_parentheses(end));
    } catch (const EvaluationError&) {
        // Between steps, where no function need have a value.
    }
    return fmt::format("gravity changes with t; at t = 1 it is {}\n", in_parentheses(end));
}

}  // namespace

std::vector<ItemList> list_conditions(const Model& model, const DeckWords& words) {
    ItemList supports{"supports", {}};
    if (model.plane) {
        std::vector<std::string_view> held;
        for (std::size_t i = 0; i < component_names.size(); ++i) {
            if (model.plane->holds(static_cast<int>(i))) held.push_back(component_names[i]);
        }
        supports.items.push_back(fmt::format("plane: {} held at every node\n", fmt::join(held, ", ")));
    }
    for (const Support& support : model.supports) supports.items.push_back(describe_support(model, support));
    ItemList velocities{"initial velocities", {}};
    const auto add_velocities = [&](const std::string& name, const std::vector<int>& nodes) {
        const std::string text = describe_velocities(model, name, nodes);
        if (!text.empty()) velocities.items.push_back(text);
    };
    for (const Rod& rod : model.rods) add_velocities("rod " + rod.name, rod.nodes);
    for (const Body& body : model.bodies) add_velocities("body " + body.name, {body.node});
    ItemList loads{"loads", {}};
    for (const NodalLoad& load : model.loads) loads.items.push_back(describe_load(model, load));
    for (const DistributedLoad& load : model.distributed_loads) {
        loads.items.push_back(describe_load(model, load));
    }
    ItemList gravity{"fields", {}};
    if (!model.gravity.is_zero()) gravity.items.push_back(describe_gravity(model));
    for (const std::string& text : list_surroundings(model.surroundings)) gravity.items.push_back(text);
    return {list_connections(model),
            supports,
            velocities,
            loads,
            list_tendons(model, words),
            list_inputs(model, words),
            gravity};
}

}  // namespace gxrod
