#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "model/model.hpp"
#include "state/state.hpp"

namespace gxrod {

// Where a tendon goes at one of its force points, or at an end, and the derivative of that by its nodes.
struct TendonTangent {
    double weight = 0.0;        // of the force point, in the rod's arc length; 0 at an end
    Vec3 slope = Vec3::Zero();  // of the tendon by that arc length, spatial
    Eigen::Matrix3Xd gradient;  // empty where it is not asked for
};

// The part of a tendon within its rod, as the elements there see it: how long it is, and how that follows the
// nodes (docs/theory/drives.md). Derivatives are by the displacements and spatial spins (δr, δφ) of these
// nodes, six of each, in the order of `nodes`.
class TendonLine {
  public:
    TendonLine(const Model& model, const Tendon& tendon);

    // From where it starts to where it ends.
    const std::vector<int>& nodes() const { return nodes_; }
    // At t = 0.
    double start_length() const { return start_length_; }
    // By the rod's arc length at each force point, likewise.
    const std::vector<double>& start_stretches() const { return start_stretches_; }

    // Of these motions of all nodes of the model; the state has the histories of sections.
    double compute_length(const std::vector<NodeMotion>& motions, const State& state) const;
    // ∂ℓ/∂(δr, δφ): what a tension of 1 asks of the nodes.
    Eigen::VectorXd compute_gradient(const std::vector<NodeMotion>& motions, const State& state) const;
    // The derivative of that; off equilibrium not symmetric.
    Eigen::MatrixXd compute_hessian(const std::vector<NodeMotion>& motions, const State& state) const;
    // At the tendon's start, at its force points and at its end.
    std::vector<TendonTangent> list_tangents(const std::vector<NodeMotion>& motions,
                                             const State& state,
                                             bool with_gradients) const;

    class Piece;  // within one element

  private:
    Eigen::Index size() const { return 6 * static_cast<Eigen::Index>(nodes_.size()); }

    std::vector<int> nodes_;
    std::vector<std::shared_ptr<const Piece>> pieces_;
    double start_length_ = 0.0;
    std::vector<double> start_stretches_;
};

}  // namespace gxrod
