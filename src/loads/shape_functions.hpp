#pragma once

#include "loads/loaded_element.hpp"

namespace gxrod {

// Returns the shape functions of a rod's elements of this order.
ShapeFunctions find_shape_functions(int order);

}  // namespace gxrod
