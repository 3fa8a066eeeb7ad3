#include "integrators/newmark_ibrahimbegovic.hpp"

#include "integrators/newmark_simplified.hpp"
#include "integrators/scheme_samples.hpp"
#include "rotation/rotation_map.hpp"
#include "rotation/tangent_map.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double newmark_beta = 0.28;
constexpr double newmark_gamma = 0.56;
constexpr double dt = 0.2;

struct Fixture {
    NewmarkIbrahimbegovic scheme{{newmark_beta, newmark_gamma}};
    Stage stage = make_stage(0);
    State state = make_random_state(scheme, 92);
    Fixture() { begin_random_stage(scheme, stage, 92, state); }
};

}  // namespace

TEST_CASE_METHOD(Fixture, "scheme (I) updates rates by (4.3)", "[integrators]") {
    const NodeMotion& previous = state.previous[0];
    const NodeMotion& trial = state.trial[0];
    const Mat3 turn = exp_matrix(trial.theta);
    const Vec3 alpha = turn * ((trial.theta / dt - previous.omega) / (newmark_beta * dt) -
                               (1.0 - 2.0 * newmark_beta) / (2.0 * newmark_beta) * previous.alpha);
    const Vec3 omega = turn * (previous.omega + dt * ((1.0 - newmark_gamma) * previous.alpha +
                                                      newmark_gamma * (turn.transpose() * alpha)));
    CHECK(relative_difference(trial.alpha, alpha) < 1e-14);
    CHECK(relative_difference(trial.omega, omega) < 1e-14);
}

TEST_CASE_METHOD(Fixture, "scheme (I) moves nodes as (S) does", "[integrators]") {
    State other = state;
    NewmarkSimplified({newmark_beta, newmark_gamma}).update_rates(other, stage);
    CHECK(state.trial[0].v == other.trial[0].v);
    CHECK(state.trial[0].a == other.trial[0].a);
}

TEST_CASE_METHOD(Fixture,
                 "scheme (I) has d_omega and d_alpha along T⁻ᵀ, less the turning of the rates",
                 "[integrators]") {
    std::vector<NodeLinearization> linearizations(2);
    scheme.linearize(state, stage, linearizations);
    const NodeMotion& trial = state.trial[0];
    const Mat3 T_inverse_transposed = tangent_map(trial.theta).transpose().inverse();
    CHECK(relative_difference(
              linearizations[0].d_omega,
              newmark_gamma / (newmark_beta * dt) * T_inverse_transposed - spin(trial.omega)) < 1e-13);
    CHECK(relative_difference(linearizations[0].d_alpha,
                              1.0 / (newmark_beta * dt * dt) * T_inverse_transposed - spin(trial.alpha)) <
          1e-13);
    CHECK_FALSE(scheme.has_paper_tangent());
}
