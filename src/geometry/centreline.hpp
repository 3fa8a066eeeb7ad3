#pragma once

#include <memory>
#include <vector>

#include "geometry/curve.hpp"

namespace gxrod {

// A rod's centreline: smooth pieces, each starting where the one before ends. At a corner, axes are carried
// from one piece to the next by the smallest rotation between their tangents.
class Centreline {
  public:
    // Takes one piece or more; no piece starts opposite to the end of the one before.
    explicit Centreline(std::vector<std::unique_ptr<Curve>> pieces);

    double length() const { return starts_.back(); }
    Vec3 start_tangent() const { return pieces_.front()->tangent(0.0); }
    // Returns the fractions of the length at corners between pieces, neither 0 nor 1.
    std::vector<double> corners() const;

    // Finds the piece that contains this fraction of the length.
    std::size_t piece_at(double fraction) const;
    // Returns the position at a fraction of the whole length on a piece, its ends included.
    Vec3 position(std::size_t piece, double fraction) const;
    // Returns the rotation that carries axes from the start of the centreline to there.
    Quat transport(std::size_t piece, double fraction) const;
    // Returns the angle by which the tangent turns from one fraction of the whole length to a later one, both
    // on a piece.
    double turn(std::size_t piece, double first, double last) const;

  private:
    double arc_length_on(std::size_t piece, double fraction) const;

    std::vector<std::unique_ptr<Curve>> pieces_;
    std::vector<double> starts_;  // arc lengths at the starts of the pieces, and at the end of the last one
    std::vector<Quat> to_piece_;  // from the start of the centreline to the start of each piece
};

}  // namespace gxrod
