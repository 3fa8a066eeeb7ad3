#include "mesh/rod_mesh.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "numerics/lagrange.hpp"

namespace gxrod {
namespace {

// Takes off the points that are corners.
void drop_corners(RodBreaks& breaks) {
    std::erase_if(breaks.points, [&](double point) {
        const auto near = [&](double corner) { return std::abs(corner - point) <= same_fraction; };
        return std::any_of(breaks.corners.begin(), breaks.corners.end(), near);
    });
}

// The fractions between pieces, with both ends, in order, each once.
std::vector<double> find_breaks(RodBreaks breaks) {
    drop_corners(breaks);
    std::vector<double> all = std::move(breaks.points);
    all.insert(all.end(), breaks.corners.begin(), breaks.corners.end());
    std::sort(all.begin(), all.end());
    std::vector<double> found{0.0};
    for (const double fraction : all) {
        if (fraction > found.back() + same_fraction && fraction < 1.0 - same_fraction)
            found.push_back(fraction);
    }
    found.push_back(1.0);
    return found;
}

// Elements of each piece, from the measures at their ends.
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

template <int Nodes>
std::vector<double> fractions_of_nodes() {
    const NodeValues<Nodes> at = compute_node_positions<Nodes>();
    std::vector<double> fractions(Nodes);
    for (int i = 0; i < Nodes; ++i) fractions[i] = 0.5 * (1.0 + at[i]);
    return fractions;
}

}  // namespace

std::size_t count_pieces(RodBreaks breaks) { return find_breaks(std::move(breaks)).size() - 1; }

std::vector<double> compute_element_fractions(RodBreaks given, long elements) {
    const auto count = static_cast<double>(elements);
    for (double& point : given.points) {
        const double nearest = std::round(point * count) / count;
        if (given.grading.is_even() && std::abs(point - nearest) <= same_fraction) point = nearest;
    }
    const Grading grading = std::move(given.grading);
    const std::vector<double> breaks = find_breaks(std::move(given));
    if (static_cast<long>(breaks.size()) - 1 > elements) return {};
    std::vector<double> measures;
    measures.reserve(breaks.size());
    for (const double fraction : breaks) measures.push_back(grading.measure(fraction));
    const std::vector<long> counts = distribute(measures, elements);
    std::vector<double> fractions;
    fractions.reserve(static_cast<std::size_t>(elements) + 1);
    for (std::size_t piece = 0; piece < counts.size(); ++piece) {
        fractions.push_back(breaks[piece]);
        const double span = measures[piece + 1] - measures[piece];
        for (long i = 1; i < counts[piece]; ++i) {
            const double part = static_cast<double>(i) / static_cast<double>(counts[piece]);
            fractions.push_back(grading.fraction_at(measures[piece] + span * part));
        }
    }
    fractions.push_back(1.0);
    return fractions;
}

std::vector<double> compute_element_nodes(int order) {
    switch (order) {
        case 1:
            return fractions_of_nodes<2>();
        case 2:
            return fractions_of_nodes<3>();
        case 3:
            return fractions_of_nodes<4>();
        default:
            assert(order == 4);
            return fractions_of_nodes<5>();
    }
}

}  // namespace gxrod
