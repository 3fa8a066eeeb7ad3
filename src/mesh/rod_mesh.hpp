#pragma once

#include <string>
#include <vector>

#include "mesh/grading.hpp"

// Where the nodes of a rod go.
namespace gxrod {

// Fractions of the length nearer than this are one point.
inline constexpr double same_fraction = 1e-9;

// What divides a rod into pieces with elements of their own.
struct RodBreaks {
    std::vector<double> points;   // that the deck names: any order, repeated or not, 0 to 1
    std::vector<double> corners;  // of the centreline: increasing, more than same_fraction apart and inside
    Grading grading = {};
};

// The fractions of a rod's length at which its elements meet, 0 first and 1 last: at each break, and between
// neighbouring breaks at equal steps of the grading's measure, `elements` of them distributed over the pieces
// in proportion to their measures (largest remainder, one a piece at least). Without a grading, and without
// breaks that call for anything else, all elements are equal. Empty if there are more pieces than elements.
std::vector<double> compute_element_fractions(RodBreaks breaks, long elements);

// How many pieces the breaks make of a rod.
std::size_t count_pieces(RodBreaks breaks);

// The fractions of an element's length at which its nodes stand, both ends included: Gauss-Lobatto points.
// `order` is 1 to 4.
std::vector<double> compute_element_nodes(int order);

}  // namespace gxrod
