#pragma once

#include "elements/element.hpp"
#include "model/model.hpp"

namespace gxrod {

// Two points A and B, each carried by a node or fixed; with one node, one of them is the ground.
template <int Nodes>
class PointPair {
    static_assert(Nodes == 1 || Nodes == 2);

  public:
    // The derivative of a vector by (δr, δφ) of the nodes.
    using Columns = Eigen::Matrix<double, 3, 6 * Nodes>;

    explicit PointPair(const std::array<Anchor, 2>& ends);

    const std::array<int, Nodes>& nodes() const { return nodes_; }
    // Returns +1 if node i carries B, −1 if it carries A.
    double sign(int i) const { return which_[i] == 0 ? -1.0 : 1.0; }
    // Returns the arm from node i to its point, spatial.
    Vec3 arm(const Motions<Nodes>& motions, int i) const { return motions[i]->Lambda * ends_[which_[i]].arm; }
    // Returns the motions of A and B; nullptr for the ground.
    std::array<const NodeMotion*, 2> at_ends(const Motions<Nodes>& motions) const;

    // Compute δd and δ(rate of d), d from A to B.
    Columns differentiate_distance(const Motions<Nodes>& motions, const Linearizations<Nodes>& linear) const;
    Columns differentiate_rate(const Motions<Nodes>& motions, const Linearizations<Nodes>& linear) const;

  private:
    std::array<Anchor, 2> ends_;
    std::array<int, Nodes> nodes_;
    std::array<std::size_t, Nodes> which_;  // the end that each node carries
};

extern template class PointPair<1>;
extern template class PointPair<2>;

}  // namespace gxrod
