#include "deck/rod_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gxrod {
namespace {

// The points between pieces, with both ends, in order, each once.
std::vector<double> find_breaks(std::vector<double> points) {
    std::sort(points.begin(), points.end());
    std::vector<double> breaks{0.0};
    for (const double point : points) {
        if (point > breaks.back() + same_fraction && point < 1.0 - same_fraction) breaks.push_back(point);
    }
    breaks.push_back(1.0);
    return breaks;
}

// Elements of each piece.
std::vector<long> distribute(const std::vector<double>& breaks, long elements) {
    const std::size_t pieces = breaks.size() - 1;
    std::vector<double> share(pieces);
    std::vector<long> count(pieces);
    for (std::size_t i = 0; i < pieces; ++i) {
        share[i] = (breaks[i + 1] - breaks[i]) * static_cast<double>(elements);
        count[i] = std::max(1L, static_cast<long>(std::floor(share[i] + same_fraction)));
    }
    const auto remainder = [&](std::size_t i) { return share[i] - static_cast<double>(count[i]); };
    const auto needier = [&](std::size_t a, std::size_t b) {
        return remainder(a) < remainder(b) - same_fraction;
    };
    std::vector<std::size_t> order(pieces);
    std::iota(order.begin(), order.end(), 0);
    long left = elements - std::accumulate(count.begin(), count.end(), 0L);
    for (; left > 0; --left) ++count[*std::max_element(order.begin(), order.end(), needier)];
    for (; left < 0; ++left) {
        // A piece that was raised to one element has taken it from the piece that misses it least.
        --count[*std::min_element(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            const bool a_can = count[a] > 1;
            const bool b_can = count[b] > 1;
            return a_can != b_can ? a_can : needier(a, b);
        })];
    }
    return count;
}

}  // namespace

std::size_t count_pieces(const std::vector<double>& points) { return find_breaks(points).size() - 1; }

std::vector<double> compute_node_fractions(std::vector<double> points, long elements) {
    const auto count = static_cast<double>(elements);
    for (double& point : points) {
        const double nearest = std::round(point * count) / count;
        if (std::abs(point - nearest) <= same_fraction) point = nearest;
    }
    const std::vector<double> breaks = find_breaks(std::move(points));
    if (static_cast<long>(breaks.size()) - 1 > elements) return {};
    const std::vector<long> counts = distribute(breaks, elements);
    std::vector<double> fractions;
    fractions.reserve(static_cast<std::size_t>(elements) + 1);
    for (std::size_t piece = 0; piece < counts.size(); ++piece) {
        const double length = breaks[piece + 1] - breaks[piece];
        for (long i = 0; i < counts[piece]; ++i) {
            fractions.push_back(breaks[piece] +
                                length * (static_cast<double>(i) / static_cast<double>(counts[piece])));
        }
    }
    fractions.push_back(1.0);
    return fractions;
}

}  // namespace gxrod
