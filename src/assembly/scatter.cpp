#include "assembly/scatter.hpp"

namespace gxrod {

void find_slots(std::span<const int> nodes,
                const EquationNumbers& equations,
                const SparsePattern& pattern,
                std::span<std::int64_t> slots) {
    std::size_t entry = 0;
    for (std::size_t column = 0; column < 6 * nodes.size(); ++column) {
        const std::int64_t column_equation = equations.of_node(nodes[column / 6])[column % 6];
        for (std::size_t row = 0; row < 6 * nodes.size(); ++row, ++entry) {
            const std::int64_t row_equation = equations.of_node(nodes[row / 6])[row % 6];
            const bool free = column_equation >= 0 && row_equation >= 0;
            slots[entry] = free ? pattern.slot(row_equation, column_equation) : -1;
        }
    }
}

Eigen::VectorXd gather(const std::vector<Vec6>& nodal,
                       const EquationNumbers& equations,
                       const ThreadTeam& team) {
    Eigen::VectorXd vector(equations.count());
    if (equations.attached_count() > 0) vector.setZero();
    team.for_each_range(nodal.size(), [&](std::size_t first, std::size_t last) {
        for (int node = static_cast<int>(first); node < static_cast<int>(last); ++node) {
            const Vec6 own = equations.to_own_axes(node, nodal[node]);
            const std::array<std::int64_t, 6> numbers = equations.of_node(node);
            for (int i = 0; i < 6; ++i) {
                if (numbers[i] >= 0) vector[numbers[i]] = own[i];
            }
        }
    });
    return vector;
}

}  // namespace gxrod
