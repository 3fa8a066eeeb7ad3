#include "contact/meshes/box_tree.hpp"

#include <numeric>

namespace gxrod {

BoxTree::BoxTree(const std::vector<Box>& boxes) : things_(boxes.size()) {
    std::iota(things_.begin(), things_.end(), 0);
    if (boxes.empty()) return;
    nodes_.reserve(boxes.size());
    nodes_.emplace_back();
    split(0, 0, static_cast<int>(boxes.size()), boxes);
}

// In halves, by the middles along the longest side of their box.
void BoxTree::split(int node, int first, int end, const std::vector<Box>& boxes) {
    constexpr int most_things = 4;
    Box box, of_middles;
    for (int i = first; i < end; ++i) {
        const Box& own = boxes[static_cast<std::size_t>(things_[static_cast<std::size_t>(i)])];
        box.include(own);
        of_middles.include(own.middle());
    }
    nodes_[static_cast<std::size_t>(node)].box = box;
    if (end - first <= most_things) {
        nodes_[static_cast<std::size_t>(node)].first = first;
        nodes_[static_cast<std::size_t>(node)].count = end - first;
        return;
    }
    int axis = 0;
    (of_middles.high - of_middles.low).maxCoeff(&axis);
    const int half = first + (end - first) / 2;
    std::nth_element(
        things_.begin() + first, things_.begin() + half, things_.begin() + end, [&](int a, int b) {
            const double at_a = boxes[static_cast<std::size_t>(a)].middle()[axis];
            const double at_b = boxes[static_cast<std::size_t>(b)].middle()[axis];
            return at_a < at_b || (at_a == at_b && a < b);
        });
    const int child = static_cast<int>(nodes_.size());
    nodes_[static_cast<std::size_t>(node)].first = child;
    nodes_.emplace_back();
    nodes_.emplace_back();
    split(child, first, half, boxes);
    split(child + 1, half, end, boxes);
}

}  // namespace gxrod
