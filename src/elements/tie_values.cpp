#include "elements/tie_values.hpp"

#include "elements/tie_elements.hpp"
#include "model/ties/ties.hpp"

namespace gxrod {

namespace {

// The motions of the nodes that carry the two ends; nullptr for the ground.
std::array<const NodeMotion*, 2> find_motions(const std::array<Anchor, 2>& ends,
                                              std::span<const NodeMotion> nodes) {
    const auto find = [&](const Anchor& end) -> const NodeMotion* {
        return end.is_ground() ? nullptr : &nodes[static_cast<std::size_t>(end.node)];
    };
    return {find(ends[0]), find(ends[1])};
}

}  // namespace

TieValues compute_tie_values(const Model& model, std::span<const NodeMotion> nodes) {
    TieValues values;
    for_each_element_list(model, [&](TieKind, const auto& ties) {
        using Values = decltype(measure(ties.front(), nullptr, nullptr));
        auto& list = std::get<std::vector<Values>>(values.lists);
        list.reserve(ties.size());
        for (const auto& tie : ties) {
            const auto [a, b] = find_motions(tie.ends, nodes);
            list.push_back(measure(tie, a, b));
        }
    });
    return values;
}

}  // namespace gxrod
