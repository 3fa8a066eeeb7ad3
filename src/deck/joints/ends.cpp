#include "deck/joints/ends.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

namespace gxrod {

const std::vector<CheckedWord>& ends_of(const CheckedTable& table) {
    return table.get<std::vector<CheckedWord>>("between");
}

std::optional<Anchor> find_anchor(const CheckedTable& table,
                                  std::size_t index,
                                  const char* place_key,
                                  const BuildContext& context) {
    const CheckedWord& word = ends_of(table)[index];
    if (word.word == ground_word) {
        if (table.gives(place_key)) return Anchor{.arm = table.get<Vec3>(place_key)};
        context.faults.add(
            word.place,
            word.path,
            fmt::format("the ground has no place of its own; expected {} = [x, y, z]", place_key));
        return std::nullopt;
    }
    const std::optional<PlacedPoint> point = context.place(word.word);
    if (!point) return std::nullopt;
    Anchor anchor{.node = point->node};
    if (table.gives(place_key))
        anchor.arm = table.get<Vec3>(place_key) - context.model.nodes[point->node].position;
    return anchor;
}

double measure_size(const Model& model, std::span<const Anchor> anchors) {
    Eigen::AlignedBox3d box;
    for (const Node& node : model.nodes) box.extend(node.position);
    for (const Anchor& anchor : anchors) box.extend(find_place(model, anchor));
    return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

}  // namespace gxrod
