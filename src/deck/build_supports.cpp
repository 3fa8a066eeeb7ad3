#include "deck/build_supports.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/choices.hpp"
#include "deck/suggestion.hpp"

namespace gxrod {
namespace {

// Velocities below this, relative to the largest component, are round-off of a body's attitude.
constexpr double round_off = 1e-12;

using Components = std::array<bool, 6>;

Components components_of(const std::string& word) {
    if (word == "all") return {true, true, true, true, true, true};
    if (word == "position") return {true, true, true, false, false, false};
    if (word == "rotation") return {false, false, false, true, true, true};
    Components components{};
    const auto name = std::find(component_names.begin(), component_names.end(), word);
    components[name - component_names.begin()] = true;
    return components;
}

// A node's support with the tables of the deck that make it.
struct NodeSupport {
    Support support;
    std::vector<const CheckedTable*> tables;
};

void add_support(int node, const CheckedTable& table, std::vector<NodeSupport>& supports) {
    auto found = std::find_if(supports.begin(), supports.end(), [&](const NodeSupport& existing) {
        return existing.support.node == node;
    });
    if (found == supports.end()) found = supports.insert(supports.end(), {{.node = node}, {}});
    found->tables.push_back(&table);
    for (const CheckedWord& word : table.get<std::vector<CheckedWord>>("fix")) {
        const Components components = components_of(word.word);
        for (int i = 0; i < 6; ++i) found->support.fixed[i] = found->support.fixed[i] || components[i];
    }
}

// Fixing one rotation alone would leave open what the other two mean once the point has turned.
void check_rotations(const NodeSupport& supported, const BuildContext& context) {
    const Components& fixed = supported.support.fixed;
    if (fixed[3] + fixed[4] + fixed[5] != 1) return;
    const auto alone = component_names[static_cast<std::size_t>(
        std::find(fixed.begin() + 3, fixed.end(), true) - fixed.begin())];
    for (const CheckedTable* table : supported.tables) {
        for (const CheckedWord& word : table->get<std::vector<CheckedWord>>("fix")) {
            if (word.word != alone) continue;
            return context.faults.add(
                word.place,
                word.path,
                fmt::format("{} alone cannot be fixed: what stays free would depend on the path of the "
                            "motion; expected "
                            "two of rx, ry, rz (a hinge about the third axis), all three or none",
                            alone));
        }
    }
}

// Takes round-off off a velocity that a support holds. The first component that is held and moves, or -1.
int find_held_motion(const bool* fixed, Vec3& motion) {
    const double size = motion.cwiseAbs().maxCoeff();
    int held = -1;
    for (int i = 0; i < 3; ++i) {
        if (!fixed[i]) continue;
        if (std::abs(motion[i]) > round_off * size && held < 0) held = i;
        if (std::abs(motion[i]) <= round_off * size) motion[i] = 0.0;
    }
    return held;
}

void check_velocities(const CheckedTable& body,
                      int node,
                      const std::vector<NodeSupport>& supports,
                      BuildContext& context) {
    for (const NodeSupport& supported : supports) {
        if (supported.support.node != node) continue;
        const bool* fixed = supported.support.fixed.data();
        const auto check = [&](const char* key, const bool* held_components, Vec3& motion, const char* axes) {
            if (!body.gives(key)) return;
            const int held = find_held_motion(held_components, motion);
            if (held < 0) return;
            context.add_fault(
                body,
                key,
                fmt::format("{} holds this body's {}{}", supported.tables.front()->path, axes, "xyz"[held]));
        };
        Node& moved = context.model.nodes[node];
        check("velocity", fixed, moved.velocity, "");
        check("angular_velocity", fixed + 3, moved.angular_velocity, "r");
        check("angular_velocity_material", fixed + 3, moved.angular_velocity, "r");
    }
}

}  // namespace

void build_supports(BuildContext& context) {
    std::vector<NodeSupport> supports;
    for (const CheckedTable& table : context.deck.tables("support")) {
        const std::optional<PlacedPoint> point = context.place(table.get<std::string>("at"));
        if (point) add_support(point->node, table, supports);
    }
    for (const NodeSupport& supported : supports) {
        check_rotations(supported, context);
        context.model.supports.push_back(supported.support);
    }
    const std::vector<CheckedTable>& bodies = context.deck.tables("body");
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (context.body_nodes[i] >= 0) check_velocities(bodies[i], context.body_nodes[i], supports, context);
    }
}

}  // namespace gxrod
