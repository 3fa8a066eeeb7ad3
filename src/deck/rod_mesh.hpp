#pragma once

#include <string>
#include <vector>

// Where the nodes of a rod go.
namespace gxrod {

// Fractions of the length nearer than this are one point.
inline constexpr double same_fraction = 1e-9;

// The fractions of a rod's length at which its nodes stand, 0 first and 1 last: a node at each of `points`
// (any order, repeated or not, 0 to 1), and between neighbouring points elements of equal length, `elements`
// of them distributed over the pieces in proportion to their lengths (largest remainder, one a piece at
// least). Without points that call for anything else, all elements are equal. Empty if there are more pieces
// than elements.
std::vector<double> compute_node_fractions(std::vector<double> points, long elements);

// How many pieces these points make of a rod.
std::size_t count_pieces(const std::vector<double>& points);

}  // namespace gxrod
