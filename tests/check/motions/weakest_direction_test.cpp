#include "check/motions/weakest_direction.hpp"

#include "assembly/sample_model.hpp"
#include "solvers/mechanisms.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"

using namespace gxrod;
using namespace gxrod::tools;

TEST_CASE("a scaled tangent compares displacements over the length with rotations", "[check]") {
    const Model model = make_sample_model();
    const System system(model);
    const std::vector<double> values = compute_static_tangent(system, make_sample_state(system, 5));
    Eigen::MatrixXd expected = make_dense(system.pattern(), values);
    for (std::int64_t i = 0; i < expected.rows(); ++i) {
        if (system.equations().unknown(i).component >= 3) continue;
        expected.row(i) *= system.length_scale();
        expected.col(i) *= system.length_scale();
    }
    expected /= expected.colwise().norm().maxCoeff();
    const ScaledTangent tangent(system, system.pattern(), values);
    CHECK(tangent.is_finite());
    CHECK(make_dense(tangent.pattern(), tangent.values()).isApprox(expected, 1e-14));
    CHECK(make_dense(tangent.pattern(), tangent.compute_transpose()).isApprox(expected.transpose(), 1e-14));
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(expected.rows(), -1.0, 2.0);
    CHECK(tangent.multiply(x).isApprox(expected * x, 1e-13));
}

TEST_CASE("the weakest direction is the smallest singular vector", "[check]") {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        Model model = make_sample_model();
        model.bodies.pop_back();  // the lone node keeps a load that has no stiffness of its own
        model.loads.pop_back();
        model.supports.push_back({4, {true, true, true, true, true, true}});
        model.supports.erase(model.supports.begin() + 1);
        model.supports[0].fixed.fill(true);
        const System system(model);
        const ScaledTangent tangent(
            system, system.pattern(), compute_static_tangent(system, make_sample_state(system, seed)));
        const Eigen::MatrixXd dense = make_dense(tangent.pattern(), tangent.values());
        const SingularValues svd = find_singular_values(dense.transpose());
        const auto weakest = find_weakest_direction(tangent);
        REQUIRE(weakest);
        const Eigen::Index last = dense.cols() - 1;
        CHECK(weakest->stiffness == Approx(svd.values[last]).epsilon(1e-6));
        CHECK(std::abs(weakest->scaled.dot(svd.left.col(last))) == Approx(1.0).epsilon(1e-6));
    }
}

TEST_CASE("the weakest direction of a long rod is found without loss", "[check]") {
    // Its stiffness falls as the third power of the number of nodes; that of a spin about its axis vanishes.
    Model model;
    add_rod(model, {"cable", Vec3::Zero(), Vec3(300.0, 0.0, 0.0), 1000});
    add_support(model, 0, {0, 1, 2});
    add_support(model, 1000, {0, 1, 2});
    const System system(model);
    const ScaledTangent tangent(
        system, system.pattern(), compute_static_tangent(system, system.initial_state()));
    const auto weakest = find_weakest_direction(tangent);
    REQUIRE(weakest);
    CHECK(weakest->stiffness < 1e-15);
    double spin = 0.0;
    for (int node = 0; node <= 1000; ++node) {
        spin += std::pow(system.equations().increment_of(node, weakest->scaled)[3], 2);
    }
    CHECK(spin == Approx(1.0).epsilon(1e-6));
}
