#include "linear/fronts/front_solver.hpp"

#include <limits>
#include <set>

#include "assembly/node_groups.hpp"
#include "solvers/sparse_samples.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// Nodes joined by chance, about `per_node` elements at each.
std::vector<NodeGroup> make_random_graph(int nodes, double per_node, unsigned seed) {
    RandomValues random(seed);
    std::vector<NodeGroup> groups;
    for (int i = 0; i < nodes; ++i) groups.push_back({i});
    for (int i = 0; i < static_cast<int>(0.5 * per_node * nodes); ++i) {
        const int a = static_cast<int>(random.number(0.0, nodes));
        const int b = static_cast<int>(random.number(0.0, nodes));
        if (a != b) groups.push_back({std::min(a, b), std::max(a, b)});
    }
    return groups;
}

// Of each node as many components are free as are asked for, 1 to 6.
template <class CountFree>
SparsePattern make_pattern_with_supports(int nodes,
                                         const std::vector<NodeGroup>& groups,
                                         CountFree&& count_free) {
    Model model;
    model.nodes.resize(nodes);
    for (int node = 0; node < nodes; ++node) {
        Support support;
        support.node = node;
        for (int component = count_free(node); component < 6; ++component) support.fixed[component] = true;
        model.supports.push_back(support);
    }
    const Supports supports(model);
    return compute_pattern(EquationNumbers(supports), groups);
}

void check_against_dense(const SparsePattern& pattern) {
    const std::vector<double> values = make_unsymmetric_values(pattern, 5);
    const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(pattern.size(), 1.0, 2.0);
    const Eigen::VectorXd expected = solve_dense(make_dense(pattern, values), load);
    FrontSolver solver(pattern);
    REQUIRE(solver.factorize(values));
    Eigen::VectorXd x = load;
    solver.solve(x);
    CHECK(relative_difference(x, expected) < 1e-13);
    // Nothing is left of it when it is factorized again, by this solver or another.
    REQUIRE(solver.factorize(make_unsymmetric_values(pattern, 6)));
    REQUIRE(solver.factorize(values));
    FrontSolver other(pattern);
    REQUIRE(other.factorize(values));
    for (FrontSolver* again : {&solver, &other}) {
        Eigen::VectorXd y = load;
        again->solve(y);
        CHECK(y == x);
    }
}

// Whether each coupling of an elimination, node by node, is in the front of the first of the two.
bool covers(const FrontOrder& order, const BlockPartition& partition) {
    const int count = partition.count();
    std::vector<int> places(count, -1);
    for (int i = 0; i < count; ++i) places[order.blocks[i]] = i;
    std::vector<std::set<int>> behind(count);
    for (int block = 0; block < count; ++block) {
        for (auto i = partition.neighbour_starts[block]; i < partition.neighbour_starts[block + 1]; ++i) {
            const int other = places[partition.neighbours[i]];
            if (other > places[block]) behind[places[block]].insert(other);
        }
    }
    int front = 0;
    for (int place = 0; place < count; ++place) {
        while (order.starts[front + 1] <= place) ++front;
        const std::set<int> rows(order.rows.begin() + static_cast<long>(order.row_starts[front]),
                                 order.rows.begin() + static_cast<long>(order.row_starts[front + 1]));
        if (!std::includes(rows.begin(), rows.end(), behind[place].begin(), behind[place].end()))
            return false;
        // All that a node couples is coupled when it goes; of these the first passes the rest on.
        if (behind[place].empty()) continue;
        const int next = *behind[place].begin();
        behind[next].insert(std::next(behind[place].begin()), behind[place].end());
    }
    return order.starts.back() == count;
}

}  // namespace

TEST_CASE("Fronts solve nets and graphs of any size as a dense LU does", "[linear]") {
    for (const int width : {1, 2, 3, 5, 9}) {
        CAPTURE(width);
        check_against_dense(make_net_pattern(width, 7));
    }
    for (const double per_node : {0.0, 1.0, 3.0, 6.0}) {
        CAPTURE(per_node);
        check_against_dense(
            make_pattern_with_supports(40, make_random_graph(40, per_node, 1), [](int) { return 6; }));
    }
}

TEST_CASE("Fronts solve nodes with held components as a dense LU does", "[linear]") {
    const std::vector<NodeGroup> groups = make_random_graph(40, 4.0, 2);
    for (const int free : {1, 2, 3, 5}) {
        CAPTURE(free);
        check_against_dense(make_pattern_with_supports(40, groups, [free](int) { return free; }));
        check_against_dense(
            make_pattern_with_supports(40, groups, [free](int node) { return 1 + (free * node) % 6; }));
    }
}

TEST_CASE("Fronts hold all that an elimination couples, whatever the order", "[linear]") {
    for (const int width : {3, 20, 80}) {
        CAPTURE(width);
        const SparsePattern pattern =
            make_pattern_with_supports(width * width, make_net_groups(width, width), [](int) { return 1; });
        const BlockPartition partition(pattern);
        REQUIRE(partition.count() == width * width);
        const FrontOrder order(partition);
        CHECK(covers(order, partition));
        CHECK(FrontOrder(partition).blocks == order.blocks);
    }
}

TEST_CASE("Fronts report a pivot that vanishes, and recover", "[linear]") {
    const SparsePattern pattern = make_net_pattern(6, 6);
    const std::vector<double> sound = make_unsymmetric_values(pattern, 3);
    FrontSolver solver(pattern);
    for (const int lone : {0, 17, 100, 215}) {
        CAPTURE(lone);
        std::vector<double> values = sound;
        pattern.visit_entries([&](std::int64_t row, std::int64_t column, std::int64_t slot) {
            if (row == lone || column == lone) values[slot] = 0.0;
        });
        CHECK_FALSE(solver.factorize(values));
        CHECK(solver.factorize(sound));
    }
}
