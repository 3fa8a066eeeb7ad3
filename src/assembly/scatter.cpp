#include "assembly/scatter.hpp"

namespace gxrod {

Eigen::VectorXd gather(const std::vector<Vec6>& nodal, const EquationNumbers& equations) {
    Eigen::VectorXd vector(equations.count());
    std::int64_t equation = 0;
    for (const auto& [node, component] : equations.unknowns()) vector[equation++] = nodal[node][component];
    return vector;
}

}  // namespace gxrod
