#pragma once

#include <string>
#include <vector>

#include "mesh/grading.hpp"

// Places the nodes of a rod.
namespace gxrod {

// Fractions of the length nearer than this count as one point.
inline constexpr double same_fraction = 1e-9;

// Breaks that divide a rod into pieces with separate elements.
struct RodBreaks {
    std::vector<double> points;  // points that the deck names: any order, repeated or not, 0 to 1
    std::vector<double>
        corners;  // corners of the centreline: increasing, more than same_fraction apart and inside
    Grading grading = {};
};

// Computes the fractions of a rod's length at which its elements meet, 0 first and 1 last: at each break, and
// between neighbouring breaks at equal steps of the grading's measure. The `elements` are distributed over
// the pieces in proportion to their measures (largest remainder, at least one each). Without a grading, and
// without breaks that require anything else, all elements are equal. Empty if there are more pieces than
// elements.
std::vector<double> compute_element_fractions(RodBreaks breaks, long elements);

// Counts the pieces that the breaks make of a rod.
std::size_t count_pieces(RodBreaks breaks);

// Computes the fractions of an element's length at its nodes, both ends included: Gauss-Lobatto points.
// `order` is 1 to 4.
std::vector<double> compute_element_nodes(int order);

}  // namespace gxrod
