#include "linear/coupled/coupling_solver.hpp"

#include "linear/coupled/gmres.hpp"
#include "solvers/sparse_samples.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// Rods of these orders and numbers of elements, one after the other, and the unknowns of their elements; the
// first node of each but the first is clamped, and the last two rods leave one node.
struct Rods {
    std::vector<NodeGroup> elements;
    SparsePattern pattern;
    std::vector<std::vector<std::int64_t>> unknowns;

    Rods() {
        int next = 0;
        Model model;
        const auto add_rod = [&](int from, int order, int count) {
            int at = from;
            for (int e = 0; e < count; ++e) {
                NodeGroup group{at};
                for (int i = 0; i < order; ++i) group.push_back(next++);
                at = group.back();
                elements.push_back(group);
            }
        };
        for (const int order : {1, 2, 3, 1}) {
            if (next > 0) {
                Support support;
                support.node = next;
                support.fixed.fill(true);
                model.supports.push_back(support);
            }
            const int from = next++;
            add_rod(from, order, 5);
        }
        add_rod(next - 3, 1, 4);
        model.nodes.resize(static_cast<std::size_t>(next));
        const Supports supports(model);
        const EquationNumbers equations(supports);
        pattern = compute_pattern(equations, elements);
        for (const NodeGroup& element : elements) {
            std::vector<std::int64_t>& own = unknowns.emplace_back();
            for (const int node : element)
                for (const std::int64_t one : equations.of_node(node)) own.push_back(one);
        }
    }
};

std::vector<std::int64_t> without_held(std::vector<std::int64_t> unknowns) {
    std::erase(unknowns, -1);
    return unknowns;
}

Eigen::MatrixXd take(const Eigen::MatrixXd& from, const std::vector<std::int64_t>& at) {
    return from(at, at);
}

}  // namespace

TEST_CASE("GMRES solves, in as many iterations as there are unknowns at most", "[linear]") {
    const Eigen::MatrixXd A = make_unsymmetric_matrix(30, 3);
    Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(30, 1.0, 2.0), x;
    const auto apply = [&](const Eigen::VectorXd& v) -> Eigen::VectorXd { return A * v; };
    const GmresResult result = solve_by_gmres(apply, b, 1e-9, 40, x);
    CHECK(result.converged);
    CHECK(result.iterations <= 31);
    CHECK((A * x - b).norm() < 2e-9);
    CHECK_FALSE(solve_by_gmres(apply, b, 1e-9, 5, x).converged);
    // Of an operator that is 2, in one.
    const auto twice = [](const Eigen::VectorXd& v) -> Eigen::VectorXd { return 2.0 * v; };
    CHECK(solve_by_gmres(twice, b, 1e-12, 9, x).iterations == 1);
    CHECK(x.isApprox(0.5 * b, 1e-14));
    b.setZero();
    CHECK(solve_by_gmres(apply, b, 0.0, 5, x).converged);
    CHECK(x.isZero(0.0));
    b[3] = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(solve_by_gmres(apply, b, 1e-9, 5, x).converged);
}

TEST_CASE("The inverse next to the diagonal is that of the whole matrix", "[linear]") {
    const Rods rods;
    const std::vector<double> values = make_unsymmetric_values(rods.pattern, 5);
    const Eigen::MatrixXd inverse = invert(make_dense(rods.pattern, values));
    NearInverse near(rods.pattern);
    CHECK(near.widest() == 18);  // of elements of order 3
    for (const int threads : {1, 3}) {
        near.factorize(values, ThreadTeam(threads));
        for (const std::vector<std::int64_t>& element : rods.unknowns) {
            const std::vector<std::int64_t> own = without_held(element);
            CHECK((near.invert(own) - take(inverse, own)).norm() < 1e-10 * inverse.norm());
        }
        // Neighbours, in any order; of other rods nothing is between.
        std::vector<std::int64_t> both = without_held(rods.unknowns[7]);
        both.insert(both.begin(), rods.unknowns[8].begin() + 6, rods.unknowns[8].end());
        CHECK((near.invert(both) - take(inverse, both)).norm() < 1e-10 * inverse.norm());
        std::vector<std::int64_t> apart = rods.unknowns[1];
        apart.insert(apart.end(), rods.unknowns[12].begin(), rods.unknowns[12].end());
        CHECK((near.invert(apart) - take(inverse, apart)).norm() < 1e-10 * inverse.norm());
    }
}

TEST_CASE("Blocks that couple rods are solved for by iterations", "[linear]") {
    const Rods rods;
    const std::vector<double> values = make_stiffness_values(rods.pattern, 6);
    Eigen::MatrixXd whole = make_dense(rods.pattern, values);
    RandomValues random(7);
    std::vector<CouplingBlock> blocks;
    for (int i = 0; i < 12; ++i) {
        const auto element = [&] {
            return static_cast<std::size_t>(random.number(0.0, static_cast<double>(rods.unknowns.size())));
        };
        CouplingBlock block{rods.unknowns[element()], {}};
        for (const std::int64_t one : rods.unknowns[element()]) {
            if (std::ranges::find(block.unknowns, one) == block.unknowns.end() || one < 0)
                block.unknowns.push_back(one);
        }
        const auto size = static_cast<Eigen::Index>(block.unknowns.size());
        block.matrix.setZero(size, size);
        for (int k = 0; k < 4; ++k) {
            Eigen::VectorXd to(size), from(size);
            for (double& one : from) one = random.number(-1.0, 1.0);
            for (double& one : to) one = random.number(-0.2, 0.2);
            block.matrix += std::pow(10.0, random.number(0.0, 5.0)) * (from + to) * from.transpose();
        }
        for (Eigen::Index r = 0; r < size; ++r)
            for (Eigen::Index c = 0; c < size; ++c) {
                const std::int64_t row = block.unknowns[static_cast<std::size_t>(r)],
                                   column = block.unknowns[static_cast<std::size_t>(c)];
                if (row >= 0 && column >= 0) whole(row, column) += block.matrix(r, c);
            }
        blocks.push_back(std::move(block));
    }
    const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(whole.rows(), 1.0, -2.0);
    CouplingSolver solver(rods.pattern, ThreadTeam::alone());
    CHECK(solver.is_suitable());
    REQUIRE(solver.factorize(values, blocks));
    Eigen::VectorXd x = right;
    REQUIRE(solver.solve(x));
    CHECK((whole * x - right).norm() < 2e-2 * right.norm());
    const int rough = solver.iterations();
    x = right;
    REQUIRE(solver.solve(x, 1e-6));
    CHECK((whole * x - right).norm() < 2e-6 * right.norm());
    CHECK(solver.iterations() > rough);
    CHECK(solver.iterations() < 60);
    const ThreadTeam team(3);
    CouplingSolver shared(rods.pattern, team);
    REQUIRE(shared.factorize(values, blocks));
    Eigen::VectorXd by_several = right;
    REQUIRE(shared.solve(by_several, 1e-6));
    CHECK(by_several == x);
    // One block between two rods is what the preconditioner solves.
    CouplingBlock alone{rods.unknowns[1], {}};
    alone.unknowns.insert(alone.unknowns.end(), rods.unknowns[12].begin(), rods.unknowns[12].end());
    const auto size = static_cast<Eigen::Index>(alone.unknowns.size());
    alone.matrix = 1e4 * Eigen::MatrixXd::Identity(size, size);
    REQUIRE(solver.factorize(values, {alone}));
    x = right;
    REQUIRE(solver.solve(x));
    CHECK(solver.iterations() == 1);
    REQUIRE(solver.factorize(values, {}));
    x = right;
    REQUIRE(solver.solve(x));
    CHECK((make_dense(rods.pattern, values) * x - right).norm() < 1e-10 * right.norm());
    CHECK_FALSE(solver.factorize(std::vector<double>(values.size(), 0.0), blocks));
}

TEST_CASE("A net is too wide for the inverse next to the diagonal", "[linear]") {
    CHECK_FALSE(CouplingSolver(make_net_pattern(8, 8), ThreadTeam::alone()).is_suitable());
    CHECK(CouplingSolver(make_net_pattern(1, 8), ThreadTeam::alone()).is_suitable());
}
