#include "numerics/smooth_line.hpp"

#include <algorithm>
#include <cassert>

namespace gxrod {

namespace {

using Polynomial = Eigen::Matrix<double, 1, SmoothLine::most_points>;

// p(u) (a + b u).
Polynomial multiply(const Polynomial& p, double a, double b) {
    Polynomial product = a * p;
    product.tail<SmoothLine::most_points - 1>() += b * p.head<SmoothLine::most_points - 1>();
    return product;
}

// Lagrange's polynomial of points[index], which vanishes at the others.
Polynomial make_lagrange(const std::vector<double>& points, std::size_t index) {
    Polynomial p = Polynomial::Unit(0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i == index) continue;
        const double gap = points[index] - points[i];
        p = multiply(p, -points[i] / gap, 1.0 / gap);
    }
    return p;
}

// The first of `count` points around a point.
int find_first(int point, int count, int all) { return std::clamp(point - count / 2, 0, all - count); }

SmoothLine::Piece make_piece(const std::vector<double>& arc_lengths, int index) {
    const int all = static_cast<int>(arc_lengths.size());
    const int around = std::min(SmoothLine::degree + 1, all);
    SmoothLine::Piece piece;
    piece.start = arc_lengths[static_cast<std::size_t>(index)];
    piece.length = arc_lengths[static_cast<std::size_t>(index) + 1] - piece.start;
    piece.first = find_first(index, around, all);
    for (int side = 0; side < 2; ++side) {
        const int first = find_first(index + side, around, all);
        std::vector<double> points;
        for (int i = first; i < first + around; ++i)
            points.push_back((arc_lengths[static_cast<std::size_t>(i)] - piece.start) / piece.length);
        for (int i = 0; i < around; ++i) {
            const Polynomial p = make_lagrange(points, static_cast<std::size_t>(i));
            piece.coefficients.row(first - piece.first + i) +=
                side == 0 ? multiply(p, 1.0, -1.0) : multiply(p, 0.0, 1.0);
        }
        piece.count = first - piece.first + around;
    }
    return piece;
}

}  // namespace

SmoothLine::SmoothLine(const std::vector<double>& arc_lengths) {
    assert(arc_lengths.size() > 1);
    for (int i = 0; i + 1 < static_cast<int>(arc_lengths.size()); ++i)
        pieces_.push_back(make_piece(arc_lengths, i));
}

int SmoothLine::find_piece(double s) const {
    const auto after =
        std::upper_bound(pieces_.begin() + 1, pieces_.end(), s, [](double at, const Piece& piece) {
            return at < piece.start;
        });
    return static_cast<int>(after - pieces_.begin()) - 1;
}

}  // namespace gxrod
