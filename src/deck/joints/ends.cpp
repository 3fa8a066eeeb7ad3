#include "deck/joints/ends.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

namespace gxrod {

std::optional<Anchor> find_anchor(const TableHead& table,
                                  const CheckedWord& end,
                                  const std::optional<Vec3>& place,
                                  const BuildContext& context) {
    if (end.word == ground_word) {
        if (place) return Anchor{.arm = *place};
        context.faults.add(end.place,
                           end.path,
                           fmt::format("the ground has no place of its own; expected {} = [x, y, z]",
                                       table.key_of(&place).name));
        return std::nullopt;
    }
    const std::optional<PlacedPoint> point = context.place(end.word);
    if (!point) return std::nullopt;
    Anchor anchor{.node = point->node};
    if (place) anchor.arm = *place - context.model.nodes[static_cast<std::size_t>(point->node)].position;
    return anchor;
}

double measure_size(const Model& model, std::span<const Anchor> anchors) {
    Eigen::AlignedBox3d box;
    for (const Node& node : model.nodes) box.extend(node.position);
    for (const Anchor& anchor : anchors) box.extend(find_place(model, anchor));
    return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

}  // namespace gxrod
