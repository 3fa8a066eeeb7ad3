#pragma once

#include "model/model.hpp"
#include "model/time/time_function.hpp"

namespace gxrod {

// Returns a function for a rod's elements, which evaluate it only at their force points. If the function
// jumps or has a kink within an element, its values there are those of a polynomial with as many coefficients
// as force points, with the same integrals over the element against each polynomial of this degree; with one
// force point it is the mean. So a part of an element counts by its share. Where the function is smooth it is
// unchanged.
LineFunction take_element_means(const LineFunction& function, const Rod& rod);

}  // namespace gxrod
