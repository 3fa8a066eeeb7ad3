#pragma once

#include "deck/places/build_context.hpp"
#include "deck/rods/rod_table.hpp"

// Limits on the bending and twist of a stress-free rod within one of its elements.
namespace gxrod {

// Computes the turn of the section axes within an element whose tangent turns by `bend`, with a twist in
// addition.
double compute_element_turn(double bend, double twist);

// Adds a fault of the rod, at the key of this field, if this turn is too large for its elements of this
// order: a logarithm cannot tell half a turn from the middle node, or from one node to the other if there are
// two.
void check_element_turn(
    double turn, int order, const RodTable& rod, const void* field, const BuildContext& context);

}  // namespace gxrod
