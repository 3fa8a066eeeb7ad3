#include "numerics/plane_curve.hpp"

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "numerics/gauss_legendre.hpp"

namespace gxrod {

namespace {

using CurvePoint = PlaneCurve::Point;

// Fits of the spline, each by the arc lengths of the one before.
constexpr int fit_count = 6;
// At least so many samples, in equal numbers in each piece.
constexpr int sample_count = 400;
// By so much of its radius a circle that touches a line may come over it elsewhere.
constexpr double overlap = 1e-6;
constexpr int most_searches = 60;
constexpr double search_round_off = 5e-16;  // of the length
constexpr int arc_points = 12;              // of the quadrature of arc lengths

double cross_in_plane(const CurvePoint& a, const CurvePoint& b) { return a.x() * b.y() - a.y() * b.x(); }

// The equations of a spline: its unknowns at each knot are c′ and c″, by the mean length of a piece.
class SplineEquations {
  public:
    SplineEquations(const std::vector<double>& knots, const std::vector<CurvePoint>& points, bool is_closed)
        : knots_(knots), points_(points), knot_count_(is_closed ? knots.size() - 1 : knots.size()) {
        mean_ = knots.back() / static_cast<double>(knots.size() - 1);
        const auto unknowns = static_cast<Eigen::Index>(2 * knot_count_);
        right_ = Eigen::MatrixX2d::Zero(unknowns, 2);
        matrix_.resize(unknowns, unknowns);
    }

    // States that the derivative of this order, from 3 to 5, is the same on both sides of a knot.
    void join(std::size_t before, std::size_t after, int order) {
        add(before, order, true, 1.0);
        add(after, order, false, -1.0);
        ++row_;
    }

    Eigen::MatrixX2d solve() {
        assert(row_ == right_.rows());
        matrix_.setFromTriplets(entries_.begin(), entries_.end());
        const Eigen::SparseLU<Eigen::SparseMatrix<double>> factors(matrix_);
        return factors.solve(right_);
    }

    double mean() const { return mean_; }

  private:
    // A derivative by the fraction u of the piece, at its end or its start, of
    // c = c₀ + h c′₀ u + h² c″₀ u²/2 + A u³ + B u⁴ + C u⁵, whose A, B and C follow from both ends.
    void add(std::size_t piece, int order, bool is_end, double sign) {
        // Rows: A, B, C; columns: c₁ − c₀, h c′₀, h c′₁, h² c″₀, h² c″₁.
        static const Eigen::Matrix<double, 3, 5> of_ends{
            {10.0, -6.0, -4.0, -1.5, 0.5}, {-15.0, 8.0, 7.0, 1.5, -1.0}, {6.0, -3.0, -3.0, -0.5, 0.5}};
        const double u = is_end ? 1.0 : 0.0;
        const Eigen::RowVector3d derivative = order == 3   ? Eigen::RowVector3d(6.0, 24.0 * u, 60.0 * u)
                                              : order == 4 ? Eigen::RowVector3d(0.0, 24.0, 120.0 * u)
                                                           : Eigen::RowVector3d(0.0, 0.0, 120.0);
        const double h = (knots_[piece + 1] - knots_[piece]) / mean_;
        const Eigen::Matrix<double, 1, 5> row = sign / std::pow(h, order) * derivative * of_ends;
        right_.row(row_) -= row[0] * (points_[piece + 1] - points_[piece]).transpose();
        const auto first = static_cast<Eigen::Index>(2 * piece);
        const auto second = static_cast<Eigen::Index>(2 * ((piece + 1) % knot_count_));
        entries_.emplace_back(row_, first, h * row[1]);
        entries_.emplace_back(row_, second, h * row[2]);
        entries_.emplace_back(row_, first + 1, h * h * row[3]);
        entries_.emplace_back(row_, second + 1, h * h * row[4]);
    }

    const std::vector<double>& knots_;
    const std::vector<CurvePoint>& points_;
    std::size_t knot_count_;
    double mean_ = 1.0;
    Eigen::Index row_ = 0;
    std::vector<Eigen::Triplet<double>> entries_;
    Eigen::SparseMatrix<double> matrix_;
    Eigen::MatrixX2d right_;
};

PlaneCurve::Place make_place(double arc_length, const std::array<CurvePoint, 4>& c) {
    const double speed = c[1].norm();
    const double turn = cross_in_plane(c[1], c[2]) / (speed * speed * speed);
    const double turn_rate =
        cross_in_plane(c[1], c[3]) / (speed * speed * speed) - 3.0 * turn * c[1].dot(c[2]) / (speed * speed);
    return {arc_length, c[0], c[1] / speed, turn, turn_rate / speed};
}

}  // namespace

PlaneCurve::PlaneCurve(std::vector<Point> points, bool is_closed)
    : points_(std::move(points)), is_closed_(is_closed) {
    assert(points_.size() >= fewest_points);
    if (is_closed_) points_.push_back(points_.front());
    knots_.assign(1, 0.0);
    for (std::size_t i = 1; i < points_.size(); ++i)
        knots_.push_back(knots_.back() + (points_[i] - points_[i - 1]).norm());
    for (int i = 0; i < fit_count; ++i) {
        fit();
        measure();
    }
    fit();
    const auto pieces = static_cast<int>(piece_count());
    samples_ = list_places((sample_count + pieces - 1) / pieces);
}

void PlaneCurve::fit() {
    SplineEquations equations(knots_, points_, is_closed_);
    const std::size_t count = piece_count();
    if (is_closed_) {
        for (const int order : {3, 4}) equations.join(count - 1, 0, order);
    } else {
        for (const std::size_t knot : {std::size_t{1}, std::size_t{2}, count - 2, count - 1})
            equations.join(knot - 1, knot, 5);
    }
    for (std::size_t knot = 1; knot < count; ++knot) {
        for (const int order : {3, 4}) equations.join(knot - 1, knot, order);
    }
    const Eigen::MatrixX2d ends = equations.solve();
    const std::size_t knot_count = is_closed_ ? count : count + 1;
    const auto end = [&](std::size_t knot, int order) -> Point {
        return ends.row(static_cast<Eigen::Index>(2 * (knot % knot_count)) + order - 1).transpose();
    };
    pieces_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double h = length_of(i) / equations.mean();
        const Point d = points_[i + 1] - points_[i];
        const Point v0 = h * end(i, 1), v1 = h * end(i + 1, 1);
        const Point a0 = h * h * end(i, 2), a1 = h * h * end(i + 1, 2);
        pieces_[i] << points_[i], v0, 0.5 * a0, 10.0 * d - 6.0 * v0 - 4.0 * v1 - 1.5 * a0 + 0.5 * a1,
            -15.0 * d + 8.0 * v0 + 7.0 * v1 + 1.5 * a0 - a1, 6.0 * d - 3.0 * (v0 + v1) + 0.5 * (a1 - a0);
    }
}

void PlaneCurve::measure() {
    static const auto rule = compute_gauss_rule<arc_points>();
    std::vector<double> knots(1, 0.0);
    for (std::size_t i = 0; i < piece_count(); ++i) {
        double length = 0.0;
        for (const QuadraturePoint& at : rule)
            length += 0.5 * at.weight * compute(i, 0.5 * (1.0 + at.xi))[1].norm() * length_of(i);
        knots.push_back(knots.back() + length);
    }
    knots_ = std::move(knots);
}

std::size_t PlaneCurve::find_piece(double arc_length) const {
    const auto after = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, arc_length);
    return static_cast<std::size_t>(after - knots_.begin()) - 1;
}

std::array<CurvePoint, 4> PlaneCurve::compute(std::size_t piece, double fraction) const {
    std::array<Point, 4> c;
    Piece p = pieces_[piece];
    const double h = length_of(piece);
    for (std::size_t order = 0; order < c.size(); ++order) {
        Point sum = Point::Zero();
        for (int power = coefficient_count - 1; power >= 0; --power) sum = sum * fraction + p.col(power);
        c[order] = sum;
        for (int power = 0; power + 1 < coefficient_count; ++power)
            p.col(power) = (power + 1) / h * p.col(power + 1);
        p.col(coefficient_count - 1).setZero();
    }
    return c;
}

bool PlaneCurve::is_counter_clockwise() const {
    double area = 0.0;
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) area += cross_in_plane(points_[i], points_[i + 1]);
    return area > 0.0;
}

PlaneCurve::Place PlaneCurve::extend(bool is_end, double beyond) const {
    const std::array<Point, 4> c = compute(is_end ? piece_count() - 1 : 0, is_end ? 1.0 : 0.0);
    const Point tangent = c[1].normalized();
    return {(is_end ? length() : 0.0) + beyond, c[0] + beyond * tangent, tangent, 0.0, 0.0};
}

PlaneCurve::Place PlaneCurve::find_place(double arc_length) const {
    double s = arc_length;
    if (is_closed_) s -= std::floor(s / length()) * length();
    if (!is_closed_ && s < 0.0) return extend(false, s);
    if (!is_closed_ && s > length()) return extend(true, s - length());
    const std::size_t piece = find_piece(s);
    return make_place(s, compute(piece, (s - knots_[piece]) / length_of(piece)));
}

std::vector<PlaneCurve::Place> PlaneCurve::list_places(int per_piece) const {
    std::vector<Place> places;
    places.reserve(piece_count() * static_cast<std::size_t>(per_piece) + 1);
    for (std::size_t i = 0; i < piece_count(); ++i) {
        for (int k = 0; k < per_piece; ++k) {
            const double fraction = static_cast<double>(k) / per_piece;
            places.push_back(make_place(knots_[i] + fraction * length_of(i), compute(i, fraction)));
        }
    }
    if (!is_closed_) places.push_back(make_place(length(), compute(piece_count() - 1, 1.0)));
    return places;
}

// From the nearest sample: the nearest place is between its neighbours. By Newton's method on (c − p) · c′,
// whose sign changes there, and by halves where that leaves the bracket.
PlaneCurve::Place PlaneCurve::find_nearest(const Point& point) const {
    const auto square = [&](const Place& place) { return (place.point - point).squaredNorm(); };
    const auto nearest = std::ranges::min_element(samples_, {}, square);
    const auto index = static_cast<std::size_t>(nearest - samples_.begin());
    const auto miss_of = [&](const Place& place) { return (place.point - point).dot(place.tangent); };
    const double miss = miss_of(*nearest);
    const bool goes_on = miss < 0.0;
    if (!is_closed_ && index == 0 && !goes_on) return extend(false, -miss);
    if (!is_closed_ && index + 1 == samples_.size() && goes_on) return extend(true, -miss);
    const std::size_t count = samples_.size();
    const std::size_t other = (index + (goes_on ? 1 : count - 1)) % count;
    double low = nearest->arc_length, high = samples_[other].arc_length;
    if (!goes_on) std::swap(low, high);
    if (high <= low && index != other) (goes_on ? high : low) += goes_on ? length() : -length();
    Place place = *nearest;
    double s = nearest->arc_length;
    for (int i = 0; i < most_searches; ++i) {
        const double off = miss_of(place);
        (off < 0.0 ? low : high) = s;
        const double slope = 1.0 + place.curvature * cross_in_plane(place.tangent, place.point - point);
        const double step = slope > 0.0 ? -off / slope : high - low;
        if (std::abs(step) <= search_round_off * length()) break;
        const double next = s + step;
        s = next > low && next < high ? next : 0.5 * (low + high);
        place = find_place(s);
    }
    return place;
}

std::optional<PlaneCurve::Place> PlaneCurve::find_crossing() const {
    std::vector<Point> line;
    for (const Place& place : samples_) line.push_back(place.point);
    if (is_closed_) line.push_back(samples_.front().point);
    const auto are_parted = [](const Point& from, const Point& to, const Point& a, const Point& b) {
        return (cross_in_plane(to - from, a - from) > 0.0) != (cross_in_plane(to - from, b - from) > 0.0);
    };
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        for (std::size_t k = i + 2; k + 1 < line.size(); ++k) {
            if (is_closed_ && i == 0 && k + 2 == line.size()) continue;  // neighbours
            if (are_parted(line[i], line[i + 1], line[k], line[k + 1]) &&
                are_parted(line[k], line[k + 1], line[i], line[i + 1]))
                return samples_[i];
        }
    }
    return std::nullopt;
}

std::optional<PlaneCurve::Place> PlaneCurve::find_tight_place(double radius, double side) const {
    if (radius == 0.0) return std::nullopt;
    for (const Place& place : samples_) {
        if (1.0 + side * place.curvature * radius <= 0.0) return place;
    }
    for (const Place& place : samples_) {
        const Point centre = place.point + side * radius * Point(place.tangent.y(), -place.tangent.x());
        if ((find_nearest(centre).point - centre).norm() < (1.0 - overlap) * radius) return place;
    }
    return std::nullopt;
}

}  // namespace gxrod
