#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

namespace gxrod {

// A smooth line in a plane through given points, closed or open, by its arc length from the first point: the
// quintic spline whose derivatives are continuous up to the fourth. An open one is a single polynomial over
// its first three pieces, and over its last three. For points h apart the error of the line is O(h⁶).
class PlaneCurve {
  public:
    using Point = Eigen::Vector2d;

    // A place of the line. Beyond the ends of an open one it is on the tangent there.
    struct Place {
        double arc_length = 0.0;
        Point point = Point::Zero();
        Point tangent = Point::Zero();  // of length 1
        double curvature = 0.0;         // positive where the line turns left
        double curvature_rate = 0.0;    // by arc length
    };

    // States how many points it takes at least.
    static constexpr std::size_t fewest_points = 6;

    // Takes the points in their order; neighbours differ. A closed line does not repeat the first one.
    PlaneCurve(std::vector<Point> points, bool is_closed);

    bool is_closed() const { return is_closed_; }
    double length() const { return knots_.back(); }
    // Whether a closed line runs counter-clockwise.
    bool is_counter_clockwise() const;
    Place find_place(double arc_length) const;
    // Finds the place nearest to a point.
    Place find_nearest(const Point& point) const;
    // Lists places at nearly equal distances along the line, so many in each of its pieces, with both ends of
    // an open line; of a closed one without the first at the end.
    std::vector<Place> list_places(int per_piece) const;
    // Finds a place at which the line crosses itself; nullopt if it does not.
    std::optional<Place> find_crossing() const;
    // Finds a place at which a circle of this radius on one side, 1 on the right and −1 on the left, touches
    // the line somewhere else as well, or is too large for its curvature; nullopt if it fits everywhere.
    std::optional<Place> find_tight_place(double radius, double side) const;

  private:
    static constexpr int coefficient_count = 6;
    using Piece = Eigen::Matrix<double, 2, coefficient_count>;  // by powers of the fraction of the piece

    void fit();
    void measure();
    std::size_t find_piece(double arc_length) const;
    // Computes the line and its first three derivatives by the knots' parameter in a piece.
    std::array<Point, 4> compute(std::size_t piece, double fraction) const;
    double length_of(std::size_t piece) const { return knots_[piece + 1] - knots_[piece]; }
    std::size_t piece_count() const { return knots_.size() - 1; }
    Place extend(bool is_end, double beyond) const;

    std::vector<Point> points_;  // with the first one again at the end of a closed line
    bool is_closed_;
    std::vector<double> knots_;  // arc lengths of the points
    std::vector<Piece> pieces_;
    std::vector<Place> samples_;  // where the search for the nearest place starts
};

}  // namespace gxrod
