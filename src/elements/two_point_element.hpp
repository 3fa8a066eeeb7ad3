#pragma once

#include "elements/plain_element.hpp"
#include "elements/point_pair.hpp"

namespace gxrod {

// An element without inertia between two points, each carried by a node or fixed. With one node it lies
// between the ground and its node.
template <int Nodes>
class TwoPointElement : public PlainElement<Nodes> {
    static_assert(Nodes == 1 || Nodes == 2);

  public:
    // Whether it takes the logarithm of the rotation of its nodes against each other, or against the ground.
    static constexpr bool sees_relative_rotation = false;
    // Whether its internal forces act on the model from outside.
    bool leans_on_ground() const { return Nodes == 1; }

  protected:
    // One of the ends is the ground if this has one node.
    explicit TwoPointElement(const std::array<Anchor, 2>& ends) : points_(ends) {
        this->nodes = points_.nodes();
    }

    PointPair<Nodes> points_;
};

}  // namespace gxrod
