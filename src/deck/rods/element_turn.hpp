#pragma once

#include "deck/places/build_context.hpp"

// How far a stress-free rod can be bent and twisted within one of its elements.
namespace gxrod {

// By how much the section axes turn within an element whose tangent turns by `bend`, with a twist of its own.
double compute_element_turn(double bend, double twist);

// A fault of the rod, at this key, if this is more than its elements can have: from their middle node, or
// from one node to the other where there are two, no logarithm sees half a turn. `order` is that of the
// elements.
void check_element_turn(
    double turn, int order, const CheckedTable& rod, const char* key, const BuildContext& context);

}  // namespace gxrod
