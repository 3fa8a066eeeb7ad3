#pragma once

#include "elements/rod/rod_element.hpp"

namespace gxrod {

// The slope of a tendon at a place of an element (docs/theory/drives.md, (D3)): (r + Λ d)′ = Λ q, spatial,
// and its derivative by the (δr, δφ) of the element's nodes.
template <int Nodes>
struct TendonSlope {
    double weight = 0.0;  // in arc length
    Vec3 slope = Vec3::Zero();
    Eigen::Matrix<double, 3, 6 * Nodes> gradient = Eigen::Matrix<double, 3, 6 * Nodes>::Zero();
};

template <int Nodes>
using TendonSlopes = std::array<TendonSlope<Nodes>, Nodes + 1>;

// Lists the slopes of the first tendon in the drives of a rod element: at the element's start, at its force
// points, and at its end. At start and end they use Λ of the node there and q from the polynomial through the
// force points; the weight is zero. Without `with_gradients` the gradients are zero.
template <class E>
TendonSlopes<E::node_count> compute_tendon_slopes(const E& element,
                                                  const Motions<E::node_count>& motions,
                                                  Histories histories,
                                                  bool with_gradients);

}  // namespace gxrod
