#include "cross_section/longest_image.hpp"

#include <algorithm>
#include <numeric>

namespace gxrod {
namespace {

constexpr int most_in_leaf = 8;
constexpr double round_off = 1e-12;  // of lengths that count as equal

}  // namespace

LongestImage::LongestImage(std::vector<Mat6> matrices)
    : matrices_(std::move(matrices)), order_(matrices_.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    if (!matrices_.empty()) build(0, static_cast<int>(matrices_.size()));
}

int LongestImage::build(int first, int last) {
    const auto matrix = [&](int k) -> const Mat6& {
        return matrices_[static_cast<std::size_t>(order_[static_cast<std::size_t>(k)])];
    };
    Group group{.first = first, .last = last};
    Mat6 low = matrix(first), high = matrix(first);
    for (int k = first; k < last; ++k) {
        group.mean += matrix(k);
        low = low.cwiseMin(matrix(k));
        high = high.cwiseMax(matrix(k));
    }
    group.mean /= last - first;
    for (int k = first; k < last; ++k)
        group.radii = group.radii.cwiseMax((matrix(k) - group.mean).colwise().norm().transpose()).eval();
    const auto index = static_cast<int>(groups_.size());
    groups_.push_back(group);
    if (last - first <= most_in_leaf) return index;

    // Columns count relative to the longest one at all, so that units do not matter.
    const Mat6 spread = (high - low) * groups_.front().radii.cwiseMax(1e-300).cwiseInverse().asDiagonal();
    Eigen::Index row = 0, column = 0;
    spread.maxCoeff(&row, &column);
    const int middle = (first + last) / 2;
    std::nth_element(
        order_.begin() + first, order_.begin() + middle, order_.begin() + last, [&](int a, int b) {
            const double one = matrices_[static_cast<std::size_t>(a)](row, column);
            const double other = matrices_[static_cast<std::size_t>(b)](row, column);
            return one < other || (one == other && a < b);
        });
    const int left = build(first, middle);
    const int right = build(middle, last);
    groups_[static_cast<std::size_t>(index)].left = left;
    groups_[static_cast<std::size_t>(index)].right = right;
    return index;
}

std::optional<LongestImage::Image> LongestImage::find(const Vec6& x, double floor) const {
    if (groups_.empty()) return std::nullopt;
    Image best{-1, floor};
    std::vector<std::pair<int, double>> open{{0, groups_.front().bound(x)}};
    while (!open.empty()) {
        const auto [index, bound] = open.back();
        open.pop_back();
        if (bound < best.length * (1.0 - round_off)) continue;
        const Group& group = groups_[static_cast<std::size_t>(index)];
        if (group.left >= 0) {
            std::pair<int, double> near{group.left, groups_[static_cast<std::size_t>(group.left)].bound(x)};
            std::pair<int, double> far{group.right, groups_[static_cast<std::size_t>(group.right)].bound(x)};
            if (near.second < far.second) std::swap(near, far);
            open.push_back(far);
            open.push_back(near);
            continue;
        }
        for (int k = group.first; k < group.last; ++k) {
            const int which = order_[static_cast<std::size_t>(k)];
            const double length = (matrices_[static_cast<std::size_t>(which)] * x).norm();
            const bool is_longer =
                length > best.length * (1.0 + round_off) || (best.index < 0 && length > floor);
            const bool is_equal = best.index >= 0 && length >= best.length * (1.0 - round_off);
            if (is_longer || (is_equal && which < best.index)) best = {which, length};
        }
    }
    if (best.index < 0) return std::nullopt;
    return best;
}

}  // namespace gxrod
