#include "deck/joints/ends.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

namespace gxrod {

const std::vector<CheckedWord>& ends_of(const CheckedTable& table) {
    return table.get<std::vector<CheckedWord>>("between");
}

namespace {

std::optional<Anchor> find_anchor_at(const CheckedWord& end,
                                     const std::optional<Vec3>& place,
                                     const std::string& place_key,
                                     const BuildContext& context) {
    if (end.word == ground_word) {
        if (place) return Anchor{.arm = *place};
        context.faults.add(
            end.place,
            end.path,
            fmt::format("the ground has no place of its own; expected {} = [x, y, z]", place_key));
        return std::nullopt;
    }
    const std::optional<PlacedPoint> point = context.place(end.word);
    if (!point) return std::nullopt;
    Anchor anchor{.node = point->node};
    if (place) anchor.arm = *place - context.model.nodes[static_cast<std::size_t>(point->node)].position;
    return anchor;
}

}  // namespace

std::optional<Anchor> find_anchor(const TableHead& table,
                                  const CheckedWord& end,
                                  const std::optional<Vec3>& place,
                                  const BuildContext& context) {
    return find_anchor_at(end, place, table.key_of(&place).name, context);
}

std::optional<Anchor> find_anchor(const CheckedTable& table,
                                  std::size_t index,
                                  const char* place_key,
                                  const BuildContext& context) {
    std::optional<Vec3> place;
    if (table.gives(place_key)) place = table.get<Vec3>(place_key);
    return find_anchor_at(ends_of(table)[index], place, place_key, context);
}

double measure_size(const Model& model, std::span<const Anchor> anchors) {
    Eigen::AlignedBox3d box;
    for (const Node& node : model.nodes) box.extend(node.position);
    for (const Anchor& anchor : anchors) box.extend(find_place(model, anchor));
    return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

}  // namespace gxrod
