#include "deck/places/plane.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "deck/rods/rod_table.hpp"
#include "deck/schema/choices.hpp"
#include "deck/schema/top_level.hpp"

namespace gxrod {
namespace {

// Relative to the model's size, or of the components of a unit vector.
constexpr double in_plane = 1e-9;

std::string name_plane(const Plane& plane) {
    return word_of(plane_choices, static_cast<PlaneAcross>(plane.normal));
}

// Which of the axes is along the normal; −1: none.
int find_normal(const Mat3& axes, const Plane& plane) {
    for (int i = 0; i < 3; ++i) {
        if (std::abs(std::abs(axes(plane.normal, i)) - 1.0) < in_plane) return i;
    }
    return -1;
}

void check_rod(const Rod& rod, const TableHead& table, const Plane& plane, const BuildContext& context) {
    const auto height = [&](int node) { return context.model.nodes[node].position[plane.normal]; };
    const double size = std::max(rod.length, std::abs(height(rod.nodes.front())));
    for (const int node : rod.nodes) {
        if (std::abs(height(node) - height(rod.nodes.front())) <= in_plane * size) continue;
        return context.faults.add(table.place,
                                  table.path,
                                  fmt::format("leaves the plane {} of the deck: {} is off it by {:.4g}",
                                              name_plane(plane),
                                              context.model.nodes[node].name,
                                              height(node) - height(rod.nodes.front())));
    }
    for (const Quat& triad : rod.triads) {
        if (find_normal(triad.toRotationMatrix(), plane) >= 1) continue;
        return context.faults.add(
            table.place,
            table.path,
            fmt::format("its section leans out of the plane {} of the deck; expected the "
                        "section's y or z across it",
                        name_plane(plane)));
    }
}

}  // namespace

void build_plane(BuildContext& context) {
    const std::optional<PlaneAcross>& given = top_level_of(context.deck).plane;
    if (!given) return;
    const Plane plane{static_cast<int>(*given)};
    context.model.plane = plane;
    const auto tables = rods_of(context.deck);
    for (std::size_t i = 0; i < context.model.rods.size(); ++i) {
        const Rod& rod = context.model.rods[i];
        if (!rod.nodes.empty()) check_rod(rod, tables[i], plane, context);
    }
}

void hold_plane(NodeSupport& supported, const BuildContext& context) {
    const Plane& plane = *context.model.plane;
    Support& support = supported.support;
    const SupportTable& table = *supported.tables.front();
    const int normal = find_normal(support.axes.toRotationMatrix(), plane);
    if (normal < 0) {
        return context.add_fault(
            table,
            table.axes,
            fmt::format("expected one of the axes across the plane {} of the deck", name_plane(plane)));
    }
    for (int i = 0; i < 6; ++i) {
        if (!Plane{normal}.holds(i)) continue;
        if (support.moved[i]) {
            const SupportTable& holder = *supported.holders[i];
            context.add_fault(holder,
                              holder.move,
                              fmt::format("{} moves out of the plane {} of the deck",
                                          component_names[static_cast<std::size_t>(i)],
                                          name_plane(plane)));
        }
        support.fixed[i] = true;
        if (supported.holders[i] == nullptr) supported.holders[i] = &table;
    }
}

}  // namespace gxrod
