#include "integrators/sdirk_4.hpp"

#include <catch2/catch.hpp>

#include "integrators/scheme_samples.hpp"
#include "rotation/tangent_map.hpp"
#include "tools/difference.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr int stages = Sdirk4::stages;
using Matrix = Eigen::Matrix<double, stages, stages>;
using Vector = Eigen::Matrix<double, stages, 1>;

struct Tableau {
    Matrix A;
    Vector b, c;
    Tableau() {
        for (int i = 0; i < stages; ++i) {
            for (int j = 0; j < stages; ++j) A(i, j) = Sdirk4::a[i][j];
        }
        b = A.row(stages - 1).transpose();
        c = A.rowwise().sum();
    }
};

}  // namespace

TEST_CASE("sdirk-4 meets Butcher's conditions to order 4", "[integrators]") {
    const auto [A, b, c] = Tableau();
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

TEST_CASE("sdirk-4 is stiffly accurate and L-stable", "[integrators]") {
    const auto [A, b, c] = Tableau();
    // R(z) = 1 + z bᵀ (I − z A)⁻¹ 1 vanishes at infinity, and stays in the unit disk on the imaginary axis.
    const auto stability = [&A = A, &b = b](std::complex<double> z) {
        const Eigen::MatrixXcd matrix =
            Eigen::MatrixXcd::Identity(stages, stages) - z * A.cast<std::complex<double>>();
        const Eigen::VectorXcd ones = Eigen::VectorXcd::Ones(stages);
        const Eigen::VectorXcd solution = matrix.fullPivLu().solve(ones);
        return std::abs(1.0 + z * (b.cast<std::complex<double>>().transpose() * solution).value());
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
