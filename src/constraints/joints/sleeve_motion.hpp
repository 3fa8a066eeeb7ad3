#pragma once

#include <Eigen/Core>
#include <array>

#include "constraints/joints/jet.hpp"
#include "numerics/smooth_line.hpp"
#include "state/constraint_level.hpp"

namespace gxrod {

// A point that slides along a line, docs/theory/joints.md (J25) to (J28). With d(s) = p − r(s) the vector
// from the line to the point p, the arc length s of the line's nearest place follows from d · r'(s) = 0, and
// the point is on the line where b₁ · d = b₂ · d = 0, b₁ and b₂ across the line. All is spatial.
class SleeveMotion {
  public:
    static constexpr int most_points = 1 + SmoothLine::most_points;
    static constexpr int most_unknowns = 3 * most_points;
    // The functions b₁ · d, b₂ · d and s.
    static constexpr int function_count = 3;
    static constexpr int slide = 2;
    using Functions = std::array<ScalarJet, function_count>;
    // Derivatives by the positions of p and the line's points, in this order.
    using Gradient = Eigen::Matrix<double, function_count, Eigen::Dynamic, Eigen::RowMajor, 3, most_unknowns>;
    using Hessian = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_unknowns, most_unknowns>;
    // Derivatives by their positions, velocities and accelerations, one after the other.
    using Change = Eigen::
        Matrix<double, function_count, Eigen::Dynamic, Eigen::RowMajor, function_count, 3 * most_unknowns>;
    using Weights = Eigen::Vector3d;

    // The point and the points of the piece of the line that contains the place s.
    struct Points {
        const SmoothLine::Piece* piece = nullptr;
        std::array<VectorJet, most_points> jets{};

        int count() const { return 1 + piece->count; }
        int unknowns() const { return 3 * count(); }
    };

    // Takes b₁, b₂ as the columns of `across`, and the exact arc length `s` of the nearest place.
    SleeveMotion(const Points& points, double s, const Eigen::Matrix<double, 3, 2>& across)
        : points_(&points), s_(s), across_(&across) {}

    Functions compute_jets(ConstraintLevel level) const;
    Gradient compute_gradient() const;
    // Computes the derivative of Σ weights ∂(function)/∂(positions) by positions.
    Hessian compute_hessian(const Weights& weights) const;
    // Computes the derivatives of the functions' second derivatives by time, or of their first ones.
    Change compute_change(ConstraintLevel level) const;

  private:
    const Points* points_;
    double s_;
    const Eigen::Matrix<double, 3, 2>* across_;
};

// The residual d · r' of the nearest place, and its derivative by s.
struct PlaceMiss {
    double value = 0.0;
    double slope = 0.0;
};
PlaceMiss compute_place_miss(const SleeveMotion::Points& points, double s);
// Computes r'(s).
Eigen::Vector3d compute_tangent(const SleeveMotion::Points& points, double s);

}  // namespace gxrod
