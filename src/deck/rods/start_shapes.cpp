#include "deck/rods/start_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/curve.hpp"
#include "rotation/rotation_map.hpp"

namespace gxrod {
namespace {

// Adds the turn that takes a tangent to where a slope of its displacement takes it.
void turn_section(const Vec3& tangent, const Vec3& slope, Vec3& turn) {
    turn += log(smallest_rotation(tangent, (tangent + slope).normalized()));
}

}  // namespace

std::optional<Vec3> project_across(const Vec3& direction, const Vec3& axis) {
    constexpr double parallel = 1e-6;
    const Vec3 across = direction - direction.dot(axis) * axis;
    if (across.norm() < parallel * direction.norm()) return std::nullopt;
    return across.normalized();
}

void add_shape(const Model& model, const std::vector<Vec6>& shape, double amplitude, StartChange& change) {
    double largest = 0.0;
    for (const Vec6& node : shape) largest = std::max(largest, node.head<3>().norm());
    if (largest == 0.0) return;
    const double by = amplitude / largest;
    for (std::size_t i = 0; i < shape.size(); ++i) {
        change.displacements[i] += by * shape[i].head<3>();
        change.turns[i] += by * shape[i].tail<3>();
    }
    for (std::size_t r = 0; r < model.rods.size(); ++r) {
        const std::vector<int>& nodes = model.rods[r].element_nodes;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            change.section_turns[r][i] += by * shape[static_cast<std::size_t>(nodes[i])].tail<3>();
    }
}

void add_sway(const Model& model, const Vec3& up, const Vec3& lean, StartChange& change) {
    double lowest = model.nodes.front().position.dot(up);
    for (const Node& node : model.nodes) lowest = std::min(lowest, node.position.dot(up));
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
        change.displacements[i] += (model.nodes[i].position.dot(up) - lowest) * lean;
    for (std::size_t r = 0; r < model.rods.size(); ++r) {
        for (std::size_t i = 0; i < model.rods[r].triads.size(); ++i) {
            const Vec3 tangent = model.rods[r].triads[i] * Vec3::UnitX();
            turn_section(tangent, tangent.dot(up) * lean, change.section_turns[r][i]);
        }
    }
}

bool add_bow(
    const Model& model, const Member& member, double bow, const Vec3& direction, StartChange& change) {
    const auto position_of = [&](int node) -> const Vec3& {
        return model.nodes[static_cast<std::size_t>(node)].position;
    };
    const Vec3 start = position_of(member.nodes[0]);
    const Vec3 chord = position_of(member.nodes[1]) - start;
    const double length = chord.norm();
    if (length == 0.0) return true;  // a ring has no chord
    const Vec3 axis = chord / length;
    const std::optional<Vec3> across = project_across(direction, axis);
    if (!across) return false;
    const auto r = static_cast<std::size_t>(member.ends[0].rod);
    const Rod& rod = model.rods[r];
    const auto per_element = static_cast<std::size_t>(rod.order) + 1;
    const auto first = static_cast<std::size_t>(member.ends[0].element) * per_element;
    const auto last = (static_cast<std::size_t>(member.ends[1].element) + 1) * per_element;
    for (std::size_t i = first; i < last; ++i) {
        const int node = rod.element_nodes[i];
        const double angle = std::numbers::pi * (position_of(node) - start).dot(axis) / length;
        // Elements share their ends; those of the member stay.
        const bool is_second = i > first && rod.element_nodes[i - 1] == node;
        if (i > first && i + 1 < last && !is_second)
            change.displacements[static_cast<std::size_t>(node)] += bow * length * std::sin(angle) * *across;
        turn_section(rod.triads[i] * Vec3::UnitX(),
                     std::numbers::pi * bow * std::cos(angle) * *across,
                     change.section_turns[r][i]);
    }
    return true;
}

}  // namespace gxrod
