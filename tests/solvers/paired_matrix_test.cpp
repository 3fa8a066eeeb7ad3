#include "solvers/paired_matrix.hpp"

#include <fmt/format.h>

#include "deck/decks.hpp"
#include "solvers/sparse_samples.hpp"
#include "tools/catch.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

TEST_CASE(
    "Where factors of rods that touch fill in, the system is solved by iterations, or directly where these "
    "fail",
    "[solvers][touch]") {
    std::string deck = R"(
[section.s]
shape = { circle = { radius = 0.01 } }
material = { E = 1e6, nu = 0.3, density = 1000 }
[contact]
[analysis]
kind = "dynamic"
end_time = 1
time_step = 0.1
[rod]
)";
    constexpr int rods = 16, elements = 12;
    for (int i = 0; i < rods; ++i)
        deck += fmt::format(
            "r{0} = {{ section = \"s\", line = {{ from = [0, {0}, 0], to = [1, {0}, 0] }}, elements = {1} "
            "}}\n",
            i,
            elements);
    const Problem problem = test::read(deck.c_str());
    const System system(problem.model);
    RandomValues random(11);
    std::vector<double> values = make_stiffness_values(system.pattern(), 4);
    // Of any two elements.
    std::vector<PairBlock> blocks;
    std::vector<NodeGroup> groups;
    for (int i = 0; i < 160; ++i) {
        const auto node = [&] { return static_cast<int>(random.number(0.0, elements)); };
        const int a = static_cast<int>(random.number(0.0, rods)), b = (a + 1 + i % (rods - 1)) % rods;
        const int at = a * (elements + 1) + node(), other = b * (elements + 1) + node();
        PairBlock block{{at, at + 1, other, other + 1}, Eigen::MatrixXd::Zero(24, 24)};
        if (std::ranges::find(groups, block.nodes) != groups.end()) continue;
        groups.push_back(block.nodes);
        for (int k = 0; k < 3; ++k) {
            Eigen::VectorXd slope(24);
            for (double& one : slope) one = random.number(-1.0, 1.0);
            block.matrix += std::pow(10.0, random.number(0.0, 4.0)) * slope * slope.transpose();
        }
        blocks.push_back(block);
    }
    const bool fails = GENERATE(false, true);
    // Stiffnesses of either sign, for which there is no end of iterations.
    if (fails) {
        for (std::size_t i = 0; i < blocks.size(); i += 2) blocks[i].matrix *= -1.0;
    }
    Eigen::VectorXd right(system.pattern().size());
    for (double& one : right) one = random.number(-1.0, 1.0);
    PairedMatrix direct(system, LinearSolverKind::chains);
    direct.start(groups);
    direct.set_values(values, blocks);
    REQUIRE(direct.factorize().regular);
    CHECK_FALSE(direct.is_iterative());
    Eigen::VectorXd expected = right;
    direct.solve(expected);
    PairedMatrix matrix(system, LinearSolverKind::automatic);
    matrix.start({groups.begin(), groups.end() - 1});
    matrix.set_values(values, blocks);
    REQUIRE(matrix.factorize().regular);
    CHECK(matrix.is_iterative());
    CHECK(matrix.orderings() == 1);
    Eigen::VectorXd found = right;
    matrix.solve(found);
    CHECK(matrix.is_iterative() == !fails);
    CHECK(matrix.orderings() == (fails ? 2 : 1));
    if (fails) {
        CHECK((found - expected).norm() < 1e-9 * expected.norm());
    } else {
        Eigen::VectorXd residual = right - multiply(system.pattern(), values, found);
        for (const PairBlock& block : blocks) {
            std::vector<std::int64_t> at;
            for (const int node : block.nodes)
                for (const std::int64_t one : system.equations().of_node(node)) at.push_back(one);
            residual(at) -= block.matrix * found(at);
        }
        CHECK(residual.norm() < 1e-2 * right.norm());
    }
    // For the rest of the step.
    REQUIRE(matrix.factorize().regular);
    CHECK(matrix.is_iterative() == !fails);
    matrix.start(groups);
    REQUIRE(matrix.factorize().regular);
    CHECK(matrix.is_iterative());
    // Blocks of zeros couple nothing.
    for (PairBlock& block : blocks) block.matrix.setZero();
    matrix.set_values(values, blocks);
    REQUIRE(matrix.factorize().regular);
    found = right;
    matrix.solve(found);
    CHECK((multiply(system.pattern(), values, found) - right).norm() < 1e-6 * right.norm());
}

TEST_CASE("Rods that only contact holds are solved directly", "[solvers][touch]") {
    const Problem problem = test::read(R"(
[section.s]
shape = { circle = { radius = 0.01 } }
material = { E = 1e6, nu = 0.3 }
[contact]
[analysis]
kind = "static"
[rod]
a = { section = "s", line = { from = [0, 0, 0], to = [1, 0, 0] }, elements = 40 }
b = { section = "s", line = { from = [0, 1, 0], to = [1, 1, 0] }, elements = 40 }
)");
    const System system(problem.model);
    // Nothing but the blocks, which couple each element of one rod with all of the other.
    std::vector<double> values(static_cast<std::size_t>(system.pattern().nonzeros()), 0.0);
    std::vector<PairBlock> blocks;
    std::vector<NodeGroup> groups;
    RandomValues random(3);
    for (int a = 0; a < 40; ++a) {
        for (int b = 0; b < 40; ++b) {
            PairBlock block{{a, a + 1, 41 + b, 42 + b}, Eigen::MatrixXd::Identity(24, 24)};
            for (double& one : block.matrix.reshaped()) one += random.number(-0.1, 0.1);
            groups.push_back(block.nodes);
            blocks.push_back(std::move(block));
        }
    }
    const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(system.pattern().size(), 1.0, 2.0);
    std::vector<Eigen::VectorXd> found;
    for (const LinearSolverKind kind : {LinearSolverKind::automatic, LinearSolverKind::chains}) {
        PairedMatrix matrix(system, kind);
        matrix.start(groups);
        matrix.set_values(values, blocks);
        REQUIRE(matrix.factorize().regular);
        CHECK_FALSE(matrix.is_iterative());
        found.push_back(right);
        matrix.solve(found.back());
    }
    CHECK(found[0] == found[1]);
}
