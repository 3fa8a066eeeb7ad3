#include "geometry/centreline.hpp"

#include <algorithm>

namespace gxrod {

Centreline::Centreline(std::vector<std::unique_ptr<Curve>> pieces) : pieces_(std::move(pieces)) {
    starts_.push_back(0.0);
    Quat carried = Quat::Identity();
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const Curve& piece = *pieces_[i];
        if (i > 0) {
            const Curve& before = *pieces_[i - 1];
            carried = smallest_rotation(before.tangent(before.length()), piece.tangent(0.0)) *
                      before.transport(before.length()) * carried;
        }
        to_piece_.push_back(carried.normalized());
        starts_.push_back(starts_.back() + piece.length());
    }
}

std::vector<double> Centreline::corners() const {
    std::vector<double> fractions;
    for (std::size_t i = 1; i < pieces_.size(); ++i) fractions.push_back(starts_[i] / length());
    return fractions;
}

std::size_t Centreline::piece_at(double fraction) const {
    const auto after = std::upper_bound(starts_.begin() + 1, starts_.end() - 1, fraction * length());
    return static_cast<std::size_t>(after - starts_.begin()) - 1;
}

double Centreline::arc_length_on(std::size_t piece, double fraction) const {
    const double round_off = 1e-14 * length();
    const double s = fraction * length() - starts_[piece];
    const double end = pieces_[piece]->length();
    // A node in a corner is at its very point.
    if (s <= round_off) return 0.0;
    return s >= end - round_off ? end : s;
}

Vec3 Centreline::position(std::size_t piece, double fraction) const {
    return pieces_[piece]->position(arc_length_on(piece, fraction));
}

Quat Centreline::transport(std::size_t piece, double fraction) const {
    return pieces_[piece]->transport(arc_length_on(piece, fraction)) * to_piece_[piece];
}

double Centreline::turn(std::size_t piece, double first, double last) const {
    const Curve& curve = *pieces_[piece];
    return curve.turn(arc_length_on(piece, last)) - curve.turn(arc_length_on(piece, first));
}

}  // namespace gxrod
