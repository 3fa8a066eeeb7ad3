#include "integrators/newmark_simplified.hpp"

#include "integrators/scheme_samples.hpp"
#include "rotation/rotation_map.hpp"
#include "rotation/tangent_map.hpp"
#include "state/increment.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double newmark_beta = 0.28;
constexpr double newmark_gamma = 0.56;
constexpr double dt = 0.2;

struct Fixture {
    NewmarkSimplified scheme{{newmark_beta, newmark_gamma}};
    Stage stage = make_stage(0);
    State state = make_random_state(scheme, 91);
    Fixture() { begin_random_stage(scheme, stage, 91, state); }
};

}  // namespace

TEST_CASE_METHOD(Fixture, "scheme (S) updates rates by (4.7)", "[integrators]") {
    const NodeMotion& previous = state.previous[0];
    const NodeMotion& trial = state.trial[0];
    const auto check = [](const Vec3& increment,
                          const Vec3& rate_n,
                          const Vec3& acceleration_n,
                          const Vec3& rate,
                          const Vec3& acceleration) {
        const Vec3 expected = (increment / dt - rate_n) / (newmark_beta * dt) -
                              (1.0 - 2.0 * newmark_beta) / (2.0 * newmark_beta) * acceleration_n;
        CHECK(relative_difference(acceleration, expected) < 1e-14);
        CHECK(relative_difference(
                  rate, rate_n + dt * ((1.0 - newmark_gamma) * acceleration_n + newmark_gamma * expected)) <
              1e-14);
    };
    check(trial.r - previous.r, previous.v, previous.a, trial.v, trial.a);
    check(trial.theta, previous.omega, previous.alpha, trial.omega, trial.alpha);
}

TEST_CASE_METHOD(Fixture, "scheme (S) has d_omega and d_alpha along T⁻¹", "[integrators]") {
    std::vector<NodeLinearization> linearizations(2);
    scheme.linearize(state, stage, linearizations);
    const Mat3 T_inverse = tangent_map(state.trial[0].theta).inverse();
    CHECK(relative_difference(linearizations[0].d_omega, newmark_gamma / (newmark_beta * dt) * T_inverse) <
          1e-13);
    CHECK(relative_difference(linearizations[0].d_alpha, 1.0 / (newmark_beta * dt * dt) * T_inverse) < 1e-13);
    CHECK(linearizations[0].rate == Approx(newmark_gamma / (newmark_beta * dt)).epsilon(1e-14));
    CHECK(linearizations[0].acceleration == Approx(1.0 / (newmark_beta * dt * dt)).epsilon(1e-14));
}

TEST_CASE_METHOD(Fixture, "the paper's linearization is the derivative by δθ", "[integrators]") {
    REQUIRE(scheme.has_paper_tangent());
    // At any θ, since the update is linear in θ; it is the derivative by δφ only where T(θ) = I.
    for (const double factor : {1.0, 0.0}) {
        NodeMotion& trial = state.trial[0];
        place(state.previous[0], trial.r, factor * trial.theta, trial);
        Eigen::Matrix<double, 12, 3> expected;
        for (int k = 0; k < 3; ++k) {
            expected.col(k) = differentiate([&](double amount) {
                State moved = state;
                const Vec3 theta = trial.theta + amount * Vec3::Unit(k);
                place(state.previous[0], trial.r, theta, moved.trial[0]);
                scheme.update_rates(moved, stage);
                return stack_rates(moved.trial[0]);
            });
        }
        std::vector<NodeLinearization> paper(2), exact(2);
        scheme.linearize_as_paper(state, stage, paper);
        scheme.linearize(state, stage, exact);
        CHECK(paper[0].placement == 1.0);
        CHECK(paper[0].rate == exact[0].rate);
        CHECK(paper[0].acceleration == exact[0].acceleration);
        CHECK(relative_difference(paper[0].d_omega, expected.middleRows<3>(6)) < 1e-10);
        CHECK(relative_difference(paper[0].d_alpha, expected.bottomRows<3>()) < 1e-10);
        CHECK(relative_difference(paper[0].d_omega, newmark_gamma / (newmark_beta * dt) * Mat3::Identity()) <
              1e-14);
        CHECK(relative_difference(paper[0].d_alpha, 1.0 / (newmark_beta * dt * dt) * Mat3::Identity()) <
              1e-14);
        if (factor == 0.0) CHECK(relative_difference(paper[0].d_alpha, exact[0].d_alpha) < 1e-14);
    }
}

TEST_CASE_METHOD(Fixture, "scheme (S) predicts constant accelerations", "[integrators]") {
    scheme.begin_stage(state, stage);
    const NodeMotion& previous = state.previous[0];
    const NodeMotion& trial = state.trial[0];
    const Vec3 theta = dt * previous.omega + 0.5 * dt * dt * previous.alpha;
    CHECK(relative_difference(trial.theta, theta) < 1e-14);
    CHECK(relative_difference(trial.r, previous.r + dt * previous.v + 0.5 * dt * dt * previous.a) < 1e-14);
    CHECK(trial.Lambda.angularDistance(exp_quaternion(theta) * previous.Lambda) < 1e-15);
    CHECK(relative_difference(trial.a, previous.a) < 1e-13);
    CHECK(relative_difference(trial.alpha, previous.alpha) < 1e-13);
    CHECK(relative_difference(trial.v, previous.v + dt * previous.a) < 1e-13);
    CHECK(relative_difference(trial.omega, previous.omega + dt * previous.alpha) < 1e-13);
}
