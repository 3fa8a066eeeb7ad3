#include "elements/point_pair.hpp"

#include <cassert>

#include "rotation/rotation_map.hpp"

namespace gxrod {

template <int Nodes>
PointPair<Nodes>::PointPair(const std::array<Anchor, 2>& ends) : ends_(ends) {
    int i = 0;
    for (std::size_t end = 0; end < 2; ++end) {
        if (ends[end].is_ground()) continue;
        assert(i < Nodes);
        nodes_[i] = ends[end].node;
        which_[i] = end;
        ++i;
    }
    assert(i == Nodes);
}

template <int Nodes>
std::array<const NodeMotion*, 2> PointPair<Nodes>::at_ends(const Motions<Nodes>& motions) const {
    std::array<const NodeMotion*, 2> found{nullptr, nullptr};
    for (int i = 0; i < Nodes; ++i) found[which_[i]] = motions[i];
    return found;
}

// d = r_B + u_B − r_A − u_A, δu = δφ × u.
template <int Nodes>
typename PointPair<Nodes>::Columns PointPair<Nodes>::differentiate_distance(
    const Motions<Nodes>& motions, const Linearizations<Nodes>& linear) const {
    Columns columns;
    for (int i = 0; i < Nodes; ++i) {
        const double by = sign(i) * linear[i]->placement;
        columns.template middleCols<3>(6 * i) = by * Mat3::Identity();
        columns.template middleCols<3>(6 * i + 3) = -by * spin(arm(motions, i));
    }
    return columns;
}

// The rate of u is ω × u.
template <int Nodes>
typename PointPair<Nodes>::Columns PointPair<Nodes>::differentiate_rate(
    const Motions<Nodes>& motions, const Linearizations<Nodes>& linear) const {
    Columns columns;
    for (int i = 0; i < Nodes; ++i) {
        const Mat3 spin_u = spin(arm(motions, i));
        const Mat3 turned = linear[i]->placement * spin(motions[i]->omega) * spin_u;
        columns.template middleCols<3>(6 * i) = sign(i) * linear[i]->rate * Mat3::Identity();
        columns.template middleCols<3>(6 * i + 3) = -sign(i) * (spin_u * linear[i]->d_omega + turned);
    }
    return columns;
}

template class PointPair<1>;
template class PointPair<2>;

}  // namespace gxrod
