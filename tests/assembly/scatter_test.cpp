#include "assembly/scatter.hpp"

#include "assembly/held_nodes.hpp"
#include "assembly/node_groups.hpp"
#include "assembly/sample_model.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr int node_count = 4;
using Dense = Eigen::MatrixXd;

// Three elements, one of them backwards and one that closes a ring; two nodes partly held.
const std::vector<std::array<int, 2>> elements{{0, 1}, {2, 1}, {3, 0}};
const std::vector<HeldComponents> held{{}, {true, false, true}, {}, {false, false, false, true, true, true}};

SparsePattern make_pattern(const EquationNumbers& equations) {
    std::vector<NodeGroup> groups;
    for (const auto& nodes : elements) groups.emplace_back(nodes.begin(), nodes.end());
    return compute_pattern(equations, groups);
}

// From all node components to equations.
Dense make_selection(const EquationNumbers& equations) {
    Dense selection = Dense::Zero(equations.count(), 6 * node_count);
    for (std::int64_t i = 0; i < equations.count(); ++i) {
        selection(i, 6 * equations.unknown(i).node + equations.unknown(i).component) = 1.0;
    }
    return selection;
}

}  // namespace

TEST_CASE("scattered element matrices make the sum that dense assembly makes", "[assembly]") {
    const HeldNodes numbered(held);
    const EquationNumbers& equations = numbered.equations;
    const SparsePattern pattern = make_pattern(equations);
    RandomValues random(71);
    std::vector<double> values(static_cast<std::size_t>(pattern.nonzeros()), 0.0);
    Dense dense = Dense::Zero(6 * node_count, 6 * node_count);
    for (const auto& nodes : elements) {
        const NodalMatrix<2> matrix = random.matrix<12>();
        add_to_values<2>(matrix, find_places<2>(nodes, equations, pattern), values);
        for (int i = 0; i < 2; ++i) {
            for (int j = 0; j < 2; ++j) {
                dense.block<6, 6>(6 * nodes[i], 6 * nodes[j]) += matrix.block<6, 6>(6 * i, 6 * j);
            }
        }
    }
    const Dense selection = make_selection(equations);
    const Dense expected = selection * dense * selection.transpose();
    CHECK(make_dense(pattern, values) == expected);
}

TEST_CASE("element vectors add up at nodes and free components are gathered", "[assembly]") {
    const HeldNodes numbered(held);
    const EquationNumbers& equations = numbered.equations;
    RandomValues random(72);
    std::vector<Vec6> nodal(node_count, Vec6::Zero());
    Eigen::VectorXd dense = Eigen::VectorXd::Zero(6 * node_count);
    for (const auto& nodes : elements) {
        const NodalVector<2> force = random.matrix<12, 1>();
        add_to_nodes<2>(force, nodes, nodal);
        for (int i = 0; i < 2; ++i) dense.segment<6>(6 * nodes[i]) += force.segment<6>(6 * i);
    }
    CHECK(gather(nodal, equations) == make_selection(equations) * dense);
}
