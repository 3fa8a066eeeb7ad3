#include "integrators/generalized_alpha.hpp"

#include "integrators/newmark_simplified.hpp"
#include "integrators/scheme_samples.hpp"
#include "rotation/tangent_map.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double dt = 0.2;

// The parameters of Chung & Hulbert for a spectral radius at infinite frequency.
struct Parameters {
    double alpha_m, alpha_f, beta, gamma;
    explicit Parameters(double radius)
        : alpha_m((2.0 * radius - 1.0) / (radius + 1.0)),
          alpha_f(radius / (radius + 1.0)),
          beta(0.25 * std::pow(1.0 - alpha_m + alpha_f, 2)),
          gamma(0.5 - alpha_m + alpha_f) {}
};

}  // namespace

TEST_CASE("generalized-alpha begins a step as if A_n continued", "[integrators]") {
    const GeneralizedAlpha scheme(0.4);
    State state = make_random_state(scheme, 92);
    scheme.begin_stage(state, make_stage(0));
    const NodeMotion& previous = state.previous[1];
    const CarriedAcceleration& A_n = state.carried_previous[2];
    const auto predict = [](const Vec3& rate, const Vec3& acceleration) -> Vec3 {
        return dt * rate + 0.5 * dt * dt * acceleration;
    };
    CHECK(relative_difference(state.trial[1].r - previous.r, predict(previous.v, A_n.a)) < 1e-13);
    CHECK(relative_difference(state.trial[1].theta, predict(previous.omega, A_n.alpha)) < 1e-13);
}

TEST_CASE("generalized-alpha updates as Arnold and Bruels state it", "[integrators]") {
    for (const double radius : {0.0, 0.4, 0.9, 1.0}) {
        INFO("radius " << radius);
        const Parameters p(radius);
        const GeneralizedAlpha scheme(radius);
        const Stage stage = make_stage(0);
        State state = make_random_state(scheme, 93);
        begin_random_stage(scheme, stage, 93, state);
        const NodeMotion& previous = state.previous[0];
        const NodeMotion& trial = state.trial[0];
        const auto check = [&](const Vec3& increment,
                               const Vec3& rate_n,
                               const Vec3& rate,
                               const Vec3& acceleration_n,
                               const Vec3& acceleration,
                               const Vec3& A_n,
                               const Vec3& A) {
            CHECK(relative_difference((1.0 - p.alpha_m) * A + p.alpha_m * A_n,
                                      (1.0 - p.alpha_f) * acceleration + p.alpha_f * acceleration_n) < 1e-13);
            CHECK(relative_difference(dt * rate_n + dt * dt * ((0.5 - p.beta) * A_n + p.beta * A),
                                      increment) < 1e-13);
            CHECK(relative_difference(rate_n + dt * ((1.0 - p.gamma) * A_n + p.gamma * A), rate) < 1e-13);
        };
        const CarriedAcceleration& A_n = state.carried_previous[0];
        const CarriedAcceleration& A = state.carried_trial[0];
        // Less what impulses of the last step put too much into positions.
        const CarriedAcceleration& impulse = state.carried_previous[1];
        const double lag = (p.beta / p.gamma - 0.5) * dt * dt;
        const Vec3 turn = trial.theta + lag * impulse.alpha;
        const Vec3 way = trial.r - previous.r + lag * impulse.a;
        check(turn, previous.omega, trial.omega, previous.alpha, trial.alpha, A_n.alpha, A.alpha);
        check(way, previous.v, trial.v, previous.a, trial.a, A_n.a, A.a);
        std::vector<NodeLinearization> linearizations(2);
        scheme.linearize(state, stage, linearizations);
        const Mat3 T_inverse = tangent_map(trial.theta).inverse();
        const double acceleration = (1.0 - p.alpha_m) / ((1.0 - p.alpha_f) * p.beta * dt * dt);
        CHECK(relative_difference(linearizations[0].d_omega, p.gamma / (p.beta * dt) * T_inverse) < 1e-13);
        CHECK(relative_difference(linearizations[0].d_alpha, acceleration * T_inverse) < 1e-13);
        CHECK(linearizations[0].acceleration == Approx(acceleration).epsilon(1e-14));
    }
}

TEST_CASE("generalized-alpha starts from the true accelerations", "[integrators]") {
    State state;
    state.trial.resize(1);
    state.trial[0].a = Vec3(1.0, 2.0, 3.0);
    state.trial[0].alpha = Vec3(4.0, 5.0, 6.0);
    state.previous = state.trial;
    GeneralizedAlpha(0.9).start(state);
    CHECK(state.carried_previous[0].a == state.trial[0].a);
    CHECK(state.carried_previous[0].alpha == state.trial[0].alpha);
}

TEST_CASE("the spectral radius is that of a stiff oscillator's decay", "[integrators]") {
    // One linear oscillator, ωΔt = 1e4: the factor by which the displacement changes from step to step.
    for (const double radius : {0.3, 0.8, 1.0}) {
        INFO("radius " << radius);
        const GeneralizedAlpha scheme(radius);
        const Stage stage = make_stage(0);
        const double stiffness = std::pow(1e4 / dt, 2);
        State state;
        state.trial.resize(1);
        state.trial[0].r = Vec3::UnitX();
        state.trial[0].a = -stiffness * state.trial[0].r;
        state.previous = state.trial;
        scheme.start(state);
        std::vector<double> energies;
        for (int step = 0; step < 40; ++step) {
            scheme.begin_stage(state, stage);
            std::vector<NodeLinearization> linearization(1);
            scheme.linearize(state, stage, linearization);
            NodeMotion& trial = state.trial[0];
            trial.r -= (trial.a + stiffness * trial.r) / (linearization[0].acceleration + stiffness);
            scheme.update_rates(state, stage);
            state.previous = state.trial;
            state.carried_previous = state.carried_trial;
            energies.push_back(0.5 * trial.v.squaredNorm() + 0.5 * stiffness * trial.r.squaredNorm());
        }
        // A double root: the decay per step nears the radius from above, as n^(1/n).
        const double decay = std::pow(energies[39] / energies[19], 1.0 / 40.0);
        CHECK(decay > radius - 1e-3);
        CHECK(decay < radius * std::pow(2.0, 1.0 / 20.0) + 1e-3);
    }
}

namespace {

// Moves a mass of 1 on a spring and a damper, held by a spring of contact too, from rest at x = Δt. Returns
// |x|/Δt after these steps.
double touch_for(int steps, double radius, double stiffness, double damping, double contact) {
    const GeneralizedAlpha scheme(radius);
    const Stage stage = make_stage(0);
    State state;
    state.trial.resize(1);
    state.trial[0].r = dt * Vec3::UnitX();
    state.trial[0].a = -stiffness * state.trial[0].r;
    state.previous = state.trial;
    scheme.start(state);
    const double factor = scheme.contact_weight();
    for (int step = 0; step < steps; ++step) {
        scheme.begin_stage(state, stage);
        std::vector<NodeLinearization> linear(1);
        scheme.linearize(state, stage, linear);
        NodeMotion& trial = state.trial[0];
        const auto smooth = [&]() -> Vec3 { return -stiffness * trial.r - damping * trial.v; };
        for (int iteration = 0; iteration < 3; ++iteration) {
            trial.r -= (trial.a - smooth() + factor * contact * trial.r) /
                       (linear[0].acceleration + linear[0].rate * damping + stiffness + factor * contact);
            scheme.update_rates(state, stage);
        }
        std::vector<Vec6> shocked(1, Vec6::Zero());
        shocked[0].head<3>() = trial.a;
        trial.a = smooth();
        scheme.split_impulses(state, stage, shocked);
        const Vec3 force = -contact * trial.r;
        CHECK((Vec3(shocked[0].head<3>()) - trial.a - force).norm() <
              1e-9 * (damping * trial.v.norm() + trial.a.norm() + force.norm() + contact * dt));
        state.previous = state.trial;
        state.carried_previous = state.carried_trial;
    }
    return state.trial[0].r.norm() / dt;
}

}  // namespace

TEST_CASE("nothing grows that a mass with a damped spring does at stiff contact", "[integrators]") {
    for (const double radius : {0.0, 0.5, 0.8, 0.9, 1.0}) {
        for (const double stiffness : {0.0, 1.0, 1e4}) {
            for (const double damping : {0.0, 1.0, 1e3}) {
                for (const double contact : {1.0, 1e4, 1e7}) {
                    INFO(radius << ' ' << stiffness << ' ' << damping << ' ' << contact);
                    const double scale = 1.0 / (dt * dt);
                    CHECK(touch_for(200, radius, stiffness * scale, damping / dt, contact * scale) < 1.1);
                }
            }
        }
    }
}
