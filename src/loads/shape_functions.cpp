#include "loads/shape_functions.hpp"

#include <cassert>

#include "numerics/lagrange.hpp"

namespace gxrod {

namespace {

template <int Nodes>
ShapeValues compute_shapes(double xi) {
    const NodeValues<Nodes> shape = compute_shape_functions<Nodes>(xi);
    const NodeValues<Nodes> slope = compute_shape_slopes<Nodes>(xi);
    ShapeValues values{};
    for (std::size_t i = 0; i < Nodes; ++i) {
        values.value[i] = shape[static_cast<Eigen::Index>(i)];
        values.slope[i] = slope[static_cast<Eigen::Index>(i)];
    }
    return values;
}

}  // namespace

ShapeFunctions find_shape_functions(int order) {
    switch (order) {
        case 1:
            return compute_shapes<2>;
        case 2:
            return compute_shapes<3>;
        case 3:
            return compute_shapes<4>;
        default:
            assert(order == 4);
            return compute_shapes<5>;
    }
}

}  // namespace gxrod
