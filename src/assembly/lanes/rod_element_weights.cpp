#include "assembly/lanes/rod_element_weights.hpp"

#include "loads/shape_functions.hpp"
#include "numerics/gauss_legendre.hpp"

namespace gxrod {

RodElementWeights compute_element_weights(const Model& model, const Rod& rod, int element) {
    const auto nodes = static_cast<std::size_t>(rod.order) + 1;
    const std::size_t first = static_cast<std::size_t>(element) * nodes;
    const ShapeFunctions shapes_at = find_shape_functions(rod.order);
    RodElementWeights weights{std::vector<double>(nodes, 0.0), std::vector<double>(nodes * nodes, 0.0)};
    for (const QuadraturePoint& point : list_gauss_rule(rod.order + 1)) {
        const ShapeValues shapes = shapes_at(point.xi);
        Vec3 tangent = Vec3::Zero();
        for (std::size_t i = 0; i < nodes; ++i) {
            const auto node = static_cast<std::size_t>(rod.element_nodes[first + i]);
            tangent += shapes.slope[i] * (rod.rest_positions.empty() ? model.nodes[node].position
                                                                     : rod.rest_positions[first + i]);
        }
        const double length = point.weight * tangent.norm();
        for (std::size_t i = 0; i < nodes; ++i) {
            weights.lengths[i] += length * shapes.value[i];
            for (std::size_t j = 0; j < nodes; ++j)
                weights.products[i + j * nodes] += length * shapes.value[i] * shapes.value[j];
        }
    }
    return weights;
}

}  // namespace gxrod
