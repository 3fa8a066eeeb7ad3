#pragma once

#include "loads/loaded_element.hpp"

namespace gxrod {

// The shape functions of the elements of a rod of this order.
ShapeFunctions find_shape_functions(int order);

}  // namespace gxrod
