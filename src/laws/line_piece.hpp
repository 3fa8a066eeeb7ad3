#pragma once

#include "laws/piecewise_line.hpp"

namespace gxrod {

// Find the piece of a line at x, and the values of a piece, which is continued beyond its ends.
inline std::size_t find_line_piece(const PiecewiseLine& line, double x) {
    std::size_t i = 0;
    while (i + 1 < line.piece_count() && x > line.points()[i + 1].first) ++i;
    return i;
}

inline PiecewiseLine::Value value_on_piece(const PiecewiseLine& line, double x, std::size_t i) {
    const auto& [from, start] = line.points()[i];
    const double rise = line.slope(i), beyond = x - from;
    return {start + rise * beyond, rise, line.at(from).integral + beyond * (start + 0.5 * rise * beyond)};
}

}  // namespace gxrod
