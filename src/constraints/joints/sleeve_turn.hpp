#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "constraints/joints/jet.hpp"
#include "numerics/smooth_line.hpp"
#include "rotation/types.hpp"
#include "state/motion.hpp"

namespace gxrod {

// The turn of a point B against the section of a rod at the place s where it is, docs/theory/joints.md (J31)
// to (J33). With the section's axes a_j(s) = Σ M_i(s) a_ij, a_ij those at the rod's nodes, and the axes b_j
// that B carries, B does not turn against the section where a₁·b₂ = a₂·b₃ = a₃·b₁ = 0. All is spatial.
class SleeveTurn {
  public:
    static constexpr int row_count = 3;
    using Axes = std::array<VectorJet, 3>;
    using Rows = std::array<ScalarJet, row_count>;
    using Row = Eigen::RowVectorXd;

    // A node of the rod, or B, as it carries axes.
    struct Carrier {
        const NodeMotion* motion = nullptr;  // null: the ground
        Axes axes{};
    };
    // How s, ṡ and s̈ follow the unknowns of all nodes: rows of derivatives.
    using PlaceChange = std::array<Row, 3>;

    // `place` is s with its rates; `nodes` are those of the piece that has it, in its order.
    SleeveTurn(const SmoothLine::Piece& piece,
               const ScalarJet& place,
               std::vector<Carrier> nodes,
               const Carrier& b);

    // Computes the three products, with their derivatives by time.
    Rows compute_jets() const;
    // Returns the sum of multipliers times the derivatives of the products by s.
    double compute_push(const Vec3& multipliers) const;
    // Computes the moment on B.
    Vec3 compute_moment(const Vec3& multipliers) const;

    // The derivatives below are by (δr, δφ) of B, unless it is the ground, and of the nodes.
    // Computes the gradients of the products, a row each, from the gradient of s.
    Eigen::MatrixXd compute_gradient(const Row& place_gradient) const;
    // Computes the derivative of Σ multipliers × gradients, but what the second derivative of s adds.
    Eigen::MatrixXd compute_force_derivative(const Vec3& multipliers, const Row& place_gradient) const;
    // Computes the derivatives of the products' second derivatives by time; of B's node first.
    Eigen::MatrixXd compute_acceleration_derivative(
        const PlaceChange& place, const std::vector<const NodeLinearization*>& linearizations) const;

  private:
    // Σ M_i⁽ⁿ⁾(s) of the axes, or of their rates or accelerations.
    Vec3 sum(int order, int axis, Vec3 VectorJet::*part) const;
    VectorJet section_axis(int axis) const;
    const VectorJet& partner(int row) const { return b_.axes[static_cast<std::size_t>((row + 1) % 3)]; }
    int first_of_nodes() const { return b_.motion == nullptr ? 0 : 6; }
    int unknowns() const { return first_of_nodes() + 6 * static_cast<int>(nodes_.size()); }
    // Computes the derivative of a_j⁽ⁿ⁾(s) · b.
    Row compute_product_gradient(int row, int order, const Row& place_gradient) const;

    std::array<std::array<double, SmoothLine::most_points>, 4> weights_;
    ScalarJet place_;
    std::vector<Carrier> nodes_;
    Carrier b_;
};

// Returns the axes that a node carries, by their directions at t = 0.
SleeveTurn::Carrier carry_axes(const NodeMotion* motion, const Mat3& axes);

// Finds the right-handed axes b_j at t = 0 that meet the products with the section's axes a_j, the columns.
Mat3 find_turn_axes(const Mat3& section);

}  // namespace gxrod
