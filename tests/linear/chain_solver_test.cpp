#include "linear/chains/chain_solver.hpp"

#include <numeric>

#include "assembly/node_groups.hpp"
#include "solvers/sparse_samples.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// Of the nodes that these elements tie together, those in `clamped` without unknowns.
SparsePattern make_pattern(const std::vector<NodeGroup>& elements, const std::vector<int>& clamped = {}) {
    Model model;
    for (const NodeGroup& element : elements) {
        for (const int node : element)
            model.nodes.resize(std::max<std::size_t>(model.nodes.size(), node + 1));
    }
    for (const int node : clamped) {
        Support support;
        support.node = node;
        support.fixed.fill(true);
        model.supports.push_back(support);
    }
    const Supports supports(model);
    return compute_pattern(EquationNumbers(supports), elements);
}

// Elements of an order between two nodes, which exist; the nodes between are new.
void add_rod(int from, int to, int elements, int order, int& next_node, std::vector<NodeGroup>& groups) {
    int at = from;
    for (int e = 0; e < elements; ++e) {
        NodeGroup group{at};
        for (int i = 1; i < order; ++i) group.push_back(next_node++);
        at = e + 1 == elements ? to : next_node++;
        group.push_back(at);
        groups.push_back(group);
    }
}

// The unknowns of the junctions, after what is solved was seen to be right.
std::int64_t solve(const SparsePattern& pattern) {
    const std::vector<double> values = make_unsymmetric_values(pattern, 1);
    const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(pattern.size(), 1.0, 2.0);
    ChainSolver solver(pattern);
    REQUIRE(solver.factorize(values).regular);
    Eigen::VectorXd x = load;
    solver.solve(x);
    CHECK((tools::multiply(pattern, values, x) - load).norm() <= 1e-12 * load.norm());
    Eigen::VectorXd expected = load;
    const auto klu = make_linear_solver(LinearSolverKind::klu, pattern);
    REQUIRE(klu->factorize(values).regular);
    klu->solve(expected);
    CHECK(relative_difference(x, expected) < 1e-12);
    for (const int threads : {2, 3}) {
        const ThreadTeam team(threads);
        ChainSolver shared(pattern, team);
        REQUIRE(shared.factorize(values).regular);
        Eigen::VectorXd again = load;
        shared.solve(again);
        CHECK(again == x);
    }
    return solver.count_kept();
}

}  // namespace

TEST_CASE("Rods of every order vanish", "[linear]") {
    for (const int order : {1, 2, 3, 4}) {
        for (const int elements : {1, 2, 7}) {
            CAPTURE(order, elements);
            std::vector<NodeGroup> groups;
            int next_node = 2;
            add_rod(0, 1, elements, order, next_node, groups);
            CHECK(solve(make_pattern(groups)) == 0);
            CHECK(solve(make_pattern(groups, {0})) == 0);
            CHECK(solve(make_pattern(groups, {0, 1})) == 0);
        }
    }
}

TEST_CASE("Trees, closed loops and loops that share a node vanish", "[linear]") {
    for (const int order : {1, 3}) {
        CAPTURE(order);
        std::vector<NodeGroup> groups;
        int next_node = 6;
        for (const int branch : {1, 2, 3}) add_rod(0, branch, 3, order, next_node, groups);
        for (const int branch : {4, 5}) add_rod(3, branch, 2, order, next_node, groups);
        CHECK(solve(make_pattern(groups)) == 0);
        add_rod(0, 0, 5, order, next_node, groups);
        add_rod(0, 0, 4, order, next_node, groups);
        add_rod(1, 1, 3, order, next_node, groups);
        CHECK(solve(make_pattern(groups)) == 0);
        // Two ways between the same nodes.
        add_rod(4, 5, 3, order, next_node, groups);
        add_rod(4, 5, 2, order, next_node, groups);
        CHECK(solve(make_pattern(groups, {2})) == 0);
    }
}

// Longer than what one thread takes alone.
TEST_CASE("Long rods, trees and closed loops are shared by threads", "[linear]") {
    for (const int order : {1, 2}) {
        CAPTURE(order);
        constexpr int elements = 400;
        std::vector<NodeGroup> groups;
        int next_node = 2;
        add_rod(0, 1, elements, order, next_node, groups);
        CHECK(solve(make_pattern(groups, {0})) == 0);
        groups.clear();
        next_node = 6;
        for (const int branch : {1, 2, 3}) add_rod(0, branch, elements, order, next_node, groups);
        for (const int branch : {4, 5}) add_rod(3, branch, elements, order, next_node, groups);
        CHECK(solve(make_pattern(groups, {1})) == 0);
        add_rod(2, 2, elements, order, next_node, groups);
        CHECK(solve(make_pattern(groups)) == 0);
        // Two ways between the same nodes, and a loop between these ways.
        add_rod(4, 5, elements, order, next_node, groups);
        add_rod(4, 5, elements, order, next_node, groups);
        CHECK(solve(make_pattern(groups)) == 0);
        add_rod(groups[5 * elements + 50].front(),
                groups[6 * elements + 60].back(),
                elements,
                order,
                next_node,
                groups);
        add_rod(groups[5 * elements + 90].front(),
                groups[6 * elements + 9].back(),
                elements,
                order,
                next_node,
                groups);
        solve(make_pattern(groups));
    }
}

TEST_CASE("Members of a net are shared by threads", "[linear]") {
    for (const int elements : {5, 60, 200}) {
        CAPTURE(elements);
        constexpr int width = 4;
        std::vector<NodeGroup> groups;
        int next_node = width * width;
        for (int a = 0; a < width * width; ++a) {
            for (int b = 0; b < a; ++b) {
                if ((a + 3 * b) % 4 != 0) add_rod(a, b, elements, 1, next_node, groups);
            }
        }
        CHECK(solve(make_pattern(groups)) == 6 * width * width);
    }
}

TEST_CASE("Junctions of a net are left", "[linear]") {
    for (const int order : {1, 2, 4}) {
        CAPTURE(order);
        constexpr int width = 5;
        std::vector<NodeGroup> groups;
        int next_node = width * width;
        for (int y = 0; y < width; ++y) {
            for (int x = 0; x < width; ++x) {
                const int node = y * width + x;
                if (x + 1 < width) add_rod(node, node + 1, 4, order, next_node, groups);
                if (y + 1 < width) add_rod(node, node + width, 4, order, next_node, groups);
            }
        }
        // The four corners are inside of chains.
        CHECK(solve(make_pattern(groups)) == 6 * (width * width - 4));
        CHECK(make_linear_solver(LinearSolverKind::automatic, make_pattern(groups))->kind() ==
              LinearSolverKind::chains);
    }
}

TEST_CASE("A system without any chain is solved as well", "[linear]") {
    const std::vector<NodeGroup> groups{
        {0, 1, 2, 3, 4}, {4, 5, 6, 7, 8}, {8, 9, 10, 11, 0}, {2, 6, 10}, {3, 7, 11}};
    const SparsePattern pattern = make_pattern(groups);
    CHECK(solve(pattern) == pattern.size());
    CHECK(ChainSolver(pattern).works_by_blocks());
}

TEST_CASE("Chains next to each other and single nodes are solved", "[linear]") {
    std::vector<NodeGroup> groups{{0}, {1}};
    int next_node = 6;
    add_rod(2, 3, 3, 1, next_node, groups);
    add_rod(4, 5, 3, 2, next_node, groups);
    CHECK(solve(make_pattern(groups)) == 0);
}

TEST_CASE("What chains and junctions lose in digits is found and solved again", "[linear]") {
    const SparsePattern pattern = make_net_pattern(GENERATE(1, 4), 6);
    const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(pattern.size(), 1.0, 2.0);
    for (const double pivot : {1e-4, 1e-9, 1e-15, 1e-30, 0.0}) {
        CAPTURE(pivot);
        std::vector<double> values = make_unsymmetric_values(pattern, 2);
        // Pivots of every block are small compared with their columns, whose other entries make them regular.
        for (std::int64_t i = 0; i < pattern.size(); i += 6) {
            values[pattern.slot(i, i)] = pivot;
            values[pattern.slot(i + 1, i + 1)] = pivot;
            values[pattern.slot(i, i + 1)] = values[pattern.slot(i + 1, i)] = 20.0;
        }
        ChainSolver solver(pattern);
        REQUIRE(solver.factorize(values).regular);
        Eigen::VectorXd x = load;
        solver.solve(x);
        CHECK((tools::multiply(pattern, values, x) - load).norm() < 1e-12 * load.norm());
        // And the next one as if nothing had been.
        const std::vector<double> sound = make_unsymmetric_values(pattern, 3);
        REQUIRE(solver.factorize(sound).regular);
        x = load;
        solver.solve(x);
        ChainSolver fresh(pattern);
        REQUIRE(fresh.factorize(sound).regular);
        Eigen::VectorXd y = load;
        fresh.solve(y);
        CHECK(x == y);
    }
}

TEST_CASE("Singular junctions are reported", "[linear]") {
    const SparsePattern pattern = make_net_pattern(4, 4);
    std::vector<double> values = make_unsymmetric_values(pattern, 4);
    pattern.visit_entries([&](std::int64_t row, std::int64_t column, std::int64_t slot) {
        if (row == 31 || column == 31) values[slot] = 0.0;
    });
    const Factorization factorization = ChainSolver(pattern).factorize(values);
    CHECK_FALSE(factorization.regular);
    CHECK(factorization.singular_equation == 31);
}
