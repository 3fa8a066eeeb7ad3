#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace gxrod {

// A line through points given at arc lengths, r(s) = Σ M_i(s) r_i, whose tangent is continuous: between two
// neighbouring points, the polynomial of degree 4 around the first (of lower degree if there are fewer
// points) is blended into the polynomial around the second. For points h apart the error of the line is
// O(h⁵), the error of its tangent O(h⁴).
class SmoothLine {
  public:
    static constexpr int degree = 4;
    static constexpr int most_points = degree + 2;
    // Coefficients of a piece's points, by powers of the position u in the piece, from 0 to 1.
    using Coefficients = Eigen::Matrix<double, most_points, most_points>;

    // The part of the line between two neighbouring points.
    struct Piece {
        double start = 0.0;                                // arc length
        double length = 0.0;                               // length of the piece
        int first = 0;                                     // index of the first of its points
        int count = 0;                                     // number of its points
        Coefficients coefficients = Coefficients::Zero();  // a row a point

        // Computes M_i and its derivatives by s, of all orders below `Orders`: by order, then by point.
        // Number: double, or a type that carries derivatives.
        template <int Orders, class Number>
        std::array<std::array<Number, most_points>, Orders> compute_weights(const Number& s) const;
    };

    // Takes at least two arc lengths, ascending.
    explicit SmoothLine(const std::vector<double>& arc_lengths);

    const std::vector<Piece>& pieces() const { return pieces_; }
    // Finds the piece at s; beyond the line's ends the first or the last one.
    int find_piece(double s) const;
    double start() const { return pieces_.front().start; }
    double end() const { return pieces_.back().start + pieces_.back().length; }

  private:
    std::vector<Piece> pieces_;
};

template <int Orders, class Number>
std::array<std::array<Number, SmoothLine::most_points>, Orders> SmoothLine::Piece::compute_weights(
    const Number& s) const {
    const Number u = (s - start) / length;
    std::array<std::array<Number, most_points>, Orders> weights;
    for (int i = 0; i < most_points; ++i) {
        Eigen::Matrix<double, 1, most_points> p = coefficients.row(i);
        for (int order = 0; order < Orders; ++order) {
            Number sum(0.0);
            for (int power = most_points - 1; power >= 0; --power) sum = sum * u + p[power];
            weights[order][i] = sum;
            for (int power = 0; power + 1 < most_points; ++power)
                p[power] = (power + 1) * p[power + 1] / length;
            p[most_points - 1] = 0.0;
        }
    }
    return weights;
}

}  // namespace gxrod
