#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "model/model.hpp"
#include "state/state.hpp"

namespace gxrod {

// The direction of a tendon at one of its force points, or at an end, and its derivative by its nodes.
struct TendonTangent {
    double weight = 0.0;        // weight of the force point, in the rod's arc length; 0 at an end
    Vec3 slope = Vec3::Zero();  // derivative of the tendon's place by that arc length, spatial
    Eigen::Matrix3Xd gradient;  // empty if not asked for
};

// The part of a tendon within its rod, as its elements interpolate it: its length, and the derivatives of its
// length by the nodes (docs/theory/drives.md). Derivatives are by the displacements and spatial spins (δr,
// δφ) of these nodes, six per node, in the order of `nodes`.
class TendonLine {
  public:
    TendonLine(const Model& model, const Tendon& tendon);

    // The nodes from the tendon's start to its end.
    const std::vector<int>& nodes() const { return nodes_; }
    // The length at t = 0.
    double start_length() const { return start_length_; }
    // The stretch at t = 0 by the rod's arc length at each force point.
    const std::vector<double>& start_stretches() const { return start_stretches_; }

    // Computes the length for these motions of all nodes of the model; the state has the histories of
    // sections.
    double compute_length(const std::vector<NodeMotion>& motions, const State& state) const;
    // Computes ∂ℓ/∂(δr, δφ): the forces on the nodes that balance a tension of 1.
    Eigen::VectorXd compute_gradient(const std::vector<NodeMotion>& motions, const State& state) const;
    // Computes the derivative of the gradient; off equilibrium it is not symmetric.
    Eigen::MatrixXd compute_hessian(const std::vector<NodeMotion>& motions, const State& state) const;
    // Lists tangents at the tendon's start, at its force points and at its end.
    std::vector<TendonTangent> list_tangents(const std::vector<NodeMotion>& motions,
                                             const State& state,
                                             bool with_gradients) const;

    class Piece;  // a piece within one element

  private:
    Eigen::Index size() const { return 6 * static_cast<Eigen::Index>(nodes_.size()); }

    std::vector<int> nodes_;
    std::vector<std::shared_ptr<const Piece>> pieces_;
    double start_length_ = 0.0;
    std::vector<double> start_stretches_;
};

}  // namespace gxrod
