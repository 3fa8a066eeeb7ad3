#include "watch/grounded_part.hpp"

#include "environment/ground.hpp"
#include "model/sections/rods_in_fluid.hpp"
#include "numerics/lagrange.hpp"

namespace gxrod {
namespace {

// An element with the place, the radius and the arc length of its nodes.
template <int Nodes>
class LyingElement {
  public:
    LyingElement(const Model& model, const Rod& rod, std::size_t first, std::span<const NodeMotion> nodes)
        : seabed_(*model.surroundings.seabed) {
        for (int i = 0; i < Nodes; ++i) {
            const std::size_t entry = first + static_cast<std::size_t>(i);
            places_.col(i) = nodes[static_cast<std::size_t>(rod.element_nodes[entry])].r;
            radii_[i] = 0.5 * fluid_section_at(model, rod, entry)->diameter;
            arc_lengths_[i] = rod.arc_length[entry];
        }
    }

    // Finds where the surface is at the ground's height between two nodes, of which the first touches.
    TouchDown find_touch_down(int touching, int free) const {
        const NodeValues<Nodes> at = compute_node_positions<Nodes>();
        double in = at[touching], out = at[free];
        constexpr int halvings = 50;
        for (int i = 0; i < halvings; ++i) {
            const double middle = 0.5 * (in + out);
            const NodeValues<Nodes> shape = compute_shape_functions<Nodes>(middle);
            const double clearance = find_ground(seabed_, places_ * shape).gap - radii_.dot(shape);
            (clearance < 0.0 ? in : out) = middle;
        }
        const NodeValues<Nodes> shape = compute_shape_functions<Nodes>(0.5 * (in + out));
        return {arc_lengths_.dot(shape), places_ * shape};
    }

  private:
    const Seabed& seabed_;
    Eigen::Matrix<double, 3, Nodes> places_;
    NodeValues<Nodes> radii_, arc_lengths_;
};

using FindBetween =
    TouchDown (*)(const Model&, const Rod&, std::size_t, std::span<const NodeMotion>, int, int);

template <int Nodes>
TouchDown find_touch_down(const Model& model,
                          const Rod& rod,
                          std::size_t first,
                          std::span<const NodeMotion> nodes,
                          int touching,
                          int free) {
    return LyingElement<Nodes>(model, rod, first, nodes).find_touch_down(touching, free);
}

}  // namespace

std::optional<GroundedPart> find_grounded_part(const Model& model,
                                               int index,
                                               std::span<const NodeMotion> nodes) {
    const Rod& rod = model.rods[static_cast<std::size_t>(index)];
    const auto per_element = static_cast<std::size_t>(rod.order) + 1;
    const std::size_t entries = rod.element_nodes.size();
    const auto position = [&](std::size_t entry) -> const Vec3& {
        return nodes[static_cast<std::size_t>(rod.element_nodes[entry])].r;
    };
    const auto touches = [&](std::size_t entry) {
        const double radius = 0.5 * fluid_section_at(model, rod, entry)->diameter;
        return find_ground(*model.surroundings.seabed, position(entry)).gap < radius;
    };
    std::size_t first = 0;
    while (first < entries && !touches(first)) ++first;
    if (first == entries) return std::nullopt;
    std::size_t last = entries - 1;
    while (!touches(last)) --last;
    static constexpr FindBetween find[]{
        find_touch_down<2>, find_touch_down<3>, find_touch_down<4>, find_touch_down<5>};
    // Where elements meet, the node is in both of them; so that before the first and that behind the last one
    // are in its element.
    const auto locate = [&](std::size_t entry, int step) -> TouchDown {
        const bool is_end = step < 0 ? entry == 0 : entry + 1 == entries;
        if (is_end) return {rod.arc_length[entry], position(entry)};
        const std::size_t start = entry - entry % per_element;
        const auto place = static_cast<int>(entry - start);
        return find[rod.order - 1](model, rod, start, nodes, place, place + step);
    };
    return GroundedPart{locate(first, -1), locate(last, 1)};
}

}  // namespace gxrod
