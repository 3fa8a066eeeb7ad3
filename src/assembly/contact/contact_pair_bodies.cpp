#include <algorithm>

#include "assembly/contact/contact_pairs.hpp"
#include "rotation/rotation_map.hpp"
#include "rotation/tangent_map.hpp"

// Bodies that touch rods and each other: ends of theirs turn about nodes.
namespace gxrod {

void ContactPairs::take_to_nodes(const NearPieces& near,
                                 const Vec24& forces,
                                 const State& state,
                                 Mat24& derivative) const {
    for (int end = 0; end < 4; ++end) {
        const ContactPiece& piece = lines_.pieces[end < 2 ? near.first : near.second];
        if (!lines_.element_of(piece).is_body) continue;
        const ContactPlace& place = lines_.places.places[piece.place + static_cast<std::size_t>(end % 2)];
        const Mat3 arm = spin(lines_.places.arm(place, state.trial));
        const int row = 6 * end;
        derivative.middleCols<3>(row + 3) -= (derivative.middleCols<3>(row) * arm).eval();
        derivative.middleRows<3>(row + 3) +=
            (spin(lines_.places.lever(place, state, has_impacts_)) * derivative.middleRows<3>(row)).eval();
        derivative.block<3, 3>(row + 3, row + 3) +=
            (has_impacts_ ? 0.5 : 1.0) * spin(forces.segment<3>(row)) * arm;
    }
}

// As in compute_tangents, where ends of bodies turn about their nodes.
void ContactPairs::add_tangent_with_body(const EndTangent& tangent,
                                         double weight,
                                         const std::vector<NodeLinearization>& linearizations,
                                         const State& state,
                                         const Shares& shares,
                                         PairBlock& block) const {
    const NearPieces& near = state.contact.pieces[tangent.index];
    Mat24 derivative = tangent.derivative;
    // By spins of nodes in the place of rotation vectors. All nodes of an end turn alike only if it has one,
    // but those of rods are only needed where it rubs.
    std::vector<Mat3> turns;
    for (const int node : block.nodes)
        turns.push_back(tangent_map_inverse(state.trial[static_cast<std::size_t>(node)].theta));
    const auto is_of_body = [&](int end) {
        return lines_.element_of(lines_.pieces[end < 2 ? near.first : near.second]).is_body;
    };
    for (int end = 0; end < 4; ++end) {
        if (!is_of_body(end)) continue;
        const auto node = std::ranges::find(
            block.nodes, lines_.element_of(lines_.pieces[end < 2 ? near.first : near.second]).nodes[0]);
        const Mat3& turn = turns[static_cast<std::size_t>(node - block.nodes.begin())];
        derivative.middleCols<3>(6 * end + 3) = (derivative.middleCols<3>(6 * end + 3) * turn).eval();
    }
    take_to_nodes(near, tangent.forces, state, derivative);
    for (Eigen::Index column = 0; column < shares.cols(); ++column) {
        const auto at = static_cast<std::size_t>(column);
        const double part =
            weight * (found_.placed.rates.empty()
                          ? linearizations[static_cast<std::size_t>(block.nodes[at])].placement
                          : 1.0);
        for (Eigen::Index row = 0; row < shares.cols(); ++row) {
            Mat6 sum = Mat6::Zero();
            for (int b = 0; b < 4; ++b) {
                Mat6 of_end = Mat6::Zero();
                for (int a = 0; a < 4; ++a) of_end += shares(a, row) * derivative.block<6, 6>(6 * a, 6 * b);
                if (!is_of_body(b)) of_end.rightCols<3>() = (of_end.rightCols<3>() * turns[at]).eval();
                sum += shares(b, column) * of_end;
            }
            block.matrix.block<6, 6>(6 * row, 6 * column) -= part * sum;
        }
    }
}

// What impulses do to nodes of bodies, less the work on the ends.
double ContactPairs::compute_turning_work(const NearPieces& near,
                                          const Vec24& forces,
                                          const State& state) const {
    double work = 0.0;
    for (int end = 0; end < 4; ++end) {
        const ContactPiece& piece = lines_.pieces[end < 2 ? near.first : near.second];
        if (!lines_.element_of(piece).is_body) continue;
        const ContactPlaces& all = lines_.places;
        const ContactPlace& place = all.places[piece.place + static_cast<std::size_t>(end % 2)];
        const Vec3 turned = all.arm(place, state.trial) - all.arm(place, state.previous);
        const Vec3& theta = all.motion_of_body(place, state.trial).theta;
        work += forces.segment<3>(6 * end).dot(theta.cross(lines_.places.lever(place, state, has_impacts_)) -
                                               turned);
    }
    return work;
}

}  // namespace gxrod
