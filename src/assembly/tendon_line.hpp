#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "model/model.hpp"
#include "state/state.hpp"

namespace gxrod {

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

    // Of these motions of all nodes of the model; the state has the histories of sections.
    double compute_length(const std::vector<NodeMotion>& motions, const State& state) const;
    // ∂ℓ/∂(δr, δφ): what a tension of 1 asks of the nodes.
    Eigen::VectorXd compute_gradient(const std::vector<NodeMotion>& motions, const State& state) const;
    // The derivative of that; off equilibrium not symmetric.
    Eigen::MatrixXd compute_hessian(const std::vector<NodeMotion>& motions, const State& state) const;

    class Piece;  // within one element

  private:
    Eigen::Index size() const { return 6 * static_cast<Eigen::Index>(nodes_.size()); }

    std::vector<int> nodes_;
    std::vector<std::shared_ptr<const Piece>> pieces_;
    double start_length_ = 0.0;
};

}  // namespace gxrod
