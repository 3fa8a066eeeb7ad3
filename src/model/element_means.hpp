#pragma once

#include "model/model.hpp"
#include "model/time/time_function.hpp"

namespace gxrod {

// A function along a rod that its elements take at their force points alone. Where it jumps or has a kink
// within an element, its values there are those of the polynomial, of as many coefficients as the element has
// force points, that has the same integrals over the element with each polynomial of this degree: of an
// element with one force point the mean. So a part of an element counts by its share. The function itself
// where it is smooth.
LineFunction take_element_means(const LineFunction& function, const Rod& rod);

}  // namespace gxrod
