#pragma once

#include <memory>
#include <vector>

#include "geometry/curve.hpp"

namespace gxrod {

// A rod's centreline: smooth pieces, each starting where the one before ends. Where they meet in a corner,
// axes are carried from one to the next by the smallest rotation between their tangents.
class Centreline {
  public:
    // One piece or more; no piece starts opposite to the end of the one before.
    explicit Centreline(std::vector<std::unique_ptr<Curve>> pieces);

    double length() const { return starts_.back(); }
    Vec3 start_tangent() const { return pieces_.front()->tangent(0.0); }
    // Fractions of the length between pieces, neither 0 nor 1.
    std::vector<double> corners() const;

    // The piece that holds this fraction of the length.
    std::size_t piece_at(double fraction) const;
    // Of a fraction of the whole length on a piece, its ends included.
    Vec3 position(std::size_t piece, double fraction) const;
    // The rotation that carries axes from the start of the centreline to there.
    Quat transport(std::size_t piece, double fraction) const;
    // By how much the tangent turns from one fraction of the whole length to a later one, both on a piece.
    double turn(std::size_t piece, double first, double last) const;

  private:
    double arc_length_on(std::size_t piece, double fraction) const;

    std::vector<std::unique_ptr<Curve>> pieces_;
    std::vector<double> starts_;  // arc lengths where the pieces start, and where the last one ends
    std::vector<Quat> to_piece_;  // from the start of the centreline to that of each piece
};

}  // namespace gxrod
