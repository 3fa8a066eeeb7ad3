#include "integrators/sdirk_4.hpp"

#include "integrators/scheme_samples.hpp"
#include "rotation/rotation_map.hpp"
#include "rotation/tangent_map.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/difference.hpp"
#include "tools/run.hpp"
#include "tools/tops.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr int stages = Sdirk4::stages;
using Matrix = Eigen::Matrix<double, stages, stages>;
using Vector = Eigen::Matrix<double, stages, 1>;

struct Tableau {
    Matrix A;
    Vector b, c;
    Vector embedded;
    Tableau() {
        for (int i = 0; i < stages; ++i) {
            for (int j = 0; j < stages; ++j) A(i, j) = Sdirk4::a[i][j];
        }
        b = A.row(stages - 1).transpose();
        c = A.rowwise().sum();
        for (int j = 0; j < stages; ++j) embedded[j] = Sdirk4::embedded_weights[j];
    }
};

}  // namespace

TEST_CASE("sdirk-4 meets Butcher's conditions to order 4", "[integrators]") {
    const auto [A, b, c, embedded] = Tableau();
    const Vector c2 = c.cwiseProduct(c);
    const Vector c3 = c2.cwiseProduct(c);
    CHECK(b.sum() == Approx(1.0).epsilon(1e-13));
    CHECK(b.dot(c) == Approx(1.0 / 2.0).epsilon(1e-13));
    CHECK(b.dot(c2) == Approx(1.0 / 3.0).epsilon(1e-13));
    CHECK(b.dot(A * c) == Approx(1.0 / 6.0).epsilon(1e-13));
    CHECK(b.dot(c3) == Approx(1.0 / 4.0).epsilon(1e-13));
    CHECK(b.cwiseProduct(c).dot(A * c) == Approx(1.0 / 8.0).epsilon(1e-13));
    CHECK(b.dot(A * c2) == Approx(1.0 / 12.0).epsilon(1e-13));
    CHECK(b.dot(A * (A * c)) == Approx(1.0 / 24.0).epsilon(1e-13));
    // Not order 5.
    CHECK(std::abs(b.dot(c2.cwiseProduct(c2)) - 1.0 / 5.0) > 1e-4);
}

TEST_CASE("the embedded scheme of sdirk-4 meets the conditions to order 3, and not of order 4",
          "[integrators]") {
    const auto [A, b, c, embedded] = Tableau();
    const Vector c2 = c.cwiseProduct(c);
    CHECK(embedded.sum() == Approx(1.0).epsilon(1e-13));
    CHECK(embedded.dot(c) == Approx(1.0 / 2.0).epsilon(1e-13));
    CHECK(embedded.dot(c2) == Approx(1.0 / 3.0).epsilon(1e-13));
    CHECK(embedded.dot(A * c) == Approx(1.0 / 6.0).epsilon(1e-13));
    CHECK(std::abs(embedded.dot(c2.cwiseProduct(c)) - 1.0 / 4.0) > 1e-3);
    CHECK(std::abs(embedded.dot(A * (A * c)) - 1.0 / 24.0) > 1e-3);
    // The estimate of a stiff component stays bounded: |1 − b̂ᵀ A⁻¹ 1| at infinity.
    CHECK(std::abs(1.0 - embedded.dot(Vector(solve_dense(A, Vector::Ones())))) < 10.0);
}

TEST_CASE("the error estimate of sdirk-4 falls with the fourth power of the step", "[integrators]") {
    const Model model = heavy_top::make_model();
    const System system(model);
    SolverWorkspace workspace(system, LinearSolverKind::klu);
    const Sdirk4 scheme;
    CHECK(scheme.error_order() == 4);
    NewtonSettings newton;
    newton.tolerance = 1e-12;
    std::vector<double> errors;
    for (const double step : {2e-3, 1e-3, 5e-4}) {
        State state = system.initial_state();
        REQUIRE(solve_accelerations(system, 0.0, {0.0, step}, workspace, state).converged());
        system.commit(state, 0.0);
        REQUIRE(solve_step({system, scheme, newton}, {0, 0.0, step, step}, workspace, state).converged());
        const StepError error =
            scheme.estimate_error(state, step, [&](int) { return system.length_scale(); });
        CHECK(error.node == 0);
        errors.push_back(error.size);
    }
    INFO("errors " << errors[0] << " " << errors[1] << " " << errors[2]);
    CHECK(compute_orders(errors)[1] == Approx(4.0).margin(0.1));
}

TEST_CASE("the error estimate of sdirk-4 is that of the worst node, by lengths", "[integrators]") {
    // From rates of one stage alone, with b − b̂ = 1/4 for the last.
    const Sdirk4 scheme;
    State state = make_random_state(scheme, 3);
    state.stages.assign(stages, std::vector<StageRates>(2));
    StageRates& rates = state.stages[4][1];
    const double weight = 0.25 * 0.2;
    const auto check = [&](double size, int component) {
        const StepError error = scheme.estimate_error(state, 0.2, [](int) { return 5.0; });
        CHECK(error.size == Approx(size).epsilon(1e-14));
        CHECK(error.node == 1);
        CHECK(error.component == component);
    };
    const StepError none = scheme.estimate_error(state, 0.2, [](int) { return 5.0; });
    CHECK(none.size == 0.0);
    CHECK(none.node == -1);
    CHECK(none.component == -1);
    rates.v = Vec3(0.0, -3.0, 1.0);
    check(weight * std::sqrt(10.0) / 5.0, 1);
    rates.theta_dot = Vec3(0.0, 0.0, 0.7);
    check(weight * 0.7, 5);
    rates.a = Vec3(0.0, 3.0, -20.0);
    check(weight * 0.2 * std::sqrt(409.0) / 5.0, 2);
    rates.alpha = Vec3(5.0, 0.0, 0.0);
    check(weight * 0.2 * 5.0, 3);
    // Whatever the model's orientation.
    const Quat turn = exp_quaternion(Vec3(0.3, -1.1, 0.7));
    rates.alpha = turn * Vec3(5.0, 0.1, -0.2);
    CHECK(scheme.estimate_error(state, 0.2, [](int) { return 5.0; }).size ==
          Approx(weight * 0.2 * std::sqrt(25.05)).epsilon(1e-14));
}

TEST_CASE("sdirk-4 is stiffly accurate and L-stable", "[integrators]") {
    const auto [A, b, c, embedded] = Tableau();
    // R(z) = 1 + z bᵀ (I − z A)⁻¹ 1 vanishes at infinity, and stays in the unit disk on the imaginary axis.
    const auto stability = [&A = A, &b = b](std::complex<double> z) {
        // The real and the imaginary part of the solution below each other.
        Eigen::MatrixXd matrix(2 * stages, 2 * stages);
        matrix << -z.real() * A, z.imag() * A, -z.imag() * A, -z.real() * A;
        matrix += Eigen::MatrixXd::Identity(2 * stages, 2 * stages);
        Eigen::MatrixXd right = Eigen::MatrixXd::Zero(2 * stages, 1);
        right.topRows(stages).setOnes();
        const Eigen::MatrixXd solution = solve_dense(matrix, right);
        const std::complex<double> sum{b.dot(Vector(solution.topRows(stages))),
                                       b.dot(Vector(solution.bottomRows(stages)))};
        return std::abs(1.0 + z * sum);
    };
    CHECK(stability(-1e8) < 1e-6);
    for (double y = 0.01; y < 1e4; y *= 1.3) CHECK(stability({0.0, y}) <= 1.0 + 1e-12);
    for (int i = 0; i < stages; ++i) CHECK(A(i, i) == Sdirk4::diagonal);
}

TEST_CASE("sdirk-4 has its stages at the sums of its rows", "[integrators]") {
    const Tableau tableau;
    const Sdirk4 scheme;
    for (int i = 0; i < stages; ++i) {
        CHECK(std::abs(scheme.stage_fraction(i) - tableau.c[i]) < 2e-15);
        CHECK(scheme.stage_time(make_stage(i)) == Approx(0.3 + tableau.c[i] * 0.2).epsilon(1e-15));
    }
    const auto weights = scheme.power_weights();
    REQUIRE(weights.size() == stages + 1);
    CHECK(weights[0] == 0.0);
    for (int i = 0; i < stages; ++i) CHECK(weights[i + 1] == tableau.b[i]);
}

TEST_CASE("a stage of sdirk-4 is a sum over the rates of the stages so far", "[integrators]") {
    // θ_i = Δt Σ a_ij T(θ_j)⁻¹ ω_j and ω_i = ω_n + Δt Σ a_ij α_j; r and v alike.
    const Sdirk4 scheme;
    State state = make_random_state(scheme, 94);
    std::vector<NodeMotion> ends;
    for (int i = 0; i < stages; ++i) {
        const Stage stage = make_stage(i);
        State begun = state;
        begin_random_stage(scheme, stage, 94 + i, begun);
        state.trial = begun.trial;  // random places, but the rates of the true stages before
        scheme.update_rates(state, stage);
        if (i == 0) state.stages.assign(stages, std::vector<StageRates>(2));
        scheme.end_stage(state, stage);
        ends.push_back(state.trial[0]);
        const NodeMotion& previous = state.previous[0];
        Vec3 r = previous.r;
        Vec3 v = previous.v;
        Vec3 theta = Vec3::Zero();
        Vec3 omega = previous.omega;
        for (int j = 0; j <= i; ++j) {
            const double weight = stage.time_step * Sdirk4::a[i][j];
            r += weight * ends[j].v;
            v += weight * ends[j].a;
            theta += weight * (tangent_map(ends[j].theta).inverse() * ends[j].omega);
            omega += weight * ends[j].alpha;
        }
        INFO("stage " << i);
        CHECK(relative_difference(ends[i].r, r) < 1e-12);
        CHECK(relative_difference(ends[i].v, v) < 1e-12);
        CHECK(relative_difference(ends[i].theta, theta) < 1e-12);
        CHECK(relative_difference(ends[i].omega, omega) < 1e-12);
    }
}
