#include "constraints/supports.hpp"

#include <numbers>

#include "rotation/rates.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

const Quat axes = RandomValues(95).rotation();

// One node at (1, 2, 3) with one support.
Model make_model(const Support& support) {
    Model model;
    model.nodes.push_back({"node", Vec3(1.0, 2.0, 3.0)});
    model.supports.push_back(support);
    return model;
}

State make_state(const Model& model) {
    State state;
    state.trial.resize(model.nodes.size());
    state.trial[0].r = model.nodes[0].position;
    state.previous = state.trial;
    return state;
}

void commit(State& state, double time) {
    state.trial[0].theta.setZero();
    state.previous = state.trial;
    state.time = time;
}

// All rotations prescribed by these functions.
Support make_turning(const std::array<TimeFunction, 3>& phi) {
    Support support{.axes = axes};
    for (int i = 0; i < 3; ++i) {
        support.moved[3 + i] = true;
        support.motion[3 + i] = phi[i];
    }
    return support;
}

}  // namespace

TEST_CASE("supports hold the components that they name", "[constraints]") {
    Model model;
    model.nodes.resize(3);
    model.supports.push_back({0, {true, true, true, false, false, false}});
    model.supports.push_back({2, {false, false, false, true, false, false}});
    model.supports.back().moved[4] = true;
    const Supports supports(model);
    REQUIRE(supports.node_count() == 3);
    CHECK(supports.held(0) == HeldComponents{true, true, true, false, false, false});
    CHECK(supports.held(1) == HeldComponents{});
    CHECK(supports.held(2) == HeldComponents{false, false, false, true, true, false});
    CHECK(supports.move());
    REQUIRE(supports.moving().size() == 1);
    CHECK(supports.moving()[0] == &model.supports[1]);
    CHECK_FALSE(supports.has_own_axes(0));
    CHECK(supports.axes(0) == Mat3::Identity());
}

TEST_CASE("a support's axes are its own", "[constraints]") {
    Model model;
    model.nodes.resize(4);
    const Quat other = RandomValues(96).rotation();
    model.supports.push_back({.node = 2, .fixed = {true}, .axes = axes});
    model.supports.push_back({.node = 0, .fixed = {true}});
    model.supports.push_back({.node = 3, .fixed = {true}, .axes = other});
    const Supports supports(model);
    CHECK_FALSE(supports.move());
    CHECK(supports.axes(0) == Mat3::Identity());
    CHECK(supports.axes(1) == Mat3::Identity());
    CHECK(supports.axes(2) == axes.toRotationMatrix());
    CHECK(supports.axes(3) == other.toRotationMatrix());
    CHECK(supports.has_own_axes(3));
    CHECK_FALSE(supports.has_own_axes(1));
}

TEST_CASE("axes a hair from the global ones are a support's own", "[constraints]") {
    const Quat tilted = exp_quaternion(Vec3(0.0, 1e-6, 0.0));
    const Model model = make_model({.fixed = {true}, .axes = tilted});
    const Supports supports(model);
    CHECK(supports.has_own_axes(0));
    CHECK(supports.axes(0) == tilted.toRotationMatrix());
}

TEST_CASE("a position is held in each component alone", "[constraints]") {
    for (int i = 0; i < 3; ++i) {
        Support support{.axes = axes};
        support.moved[i] = true;
        support.motion[i] = TimeFunction([](double t) { return 3.0 * t; });
        const Model model = make_model(support);
        State state = make_state(model);
        Supports(model).place(2.0, state);
        const Vec3 displacement = axes.conjugate() * (state.trial[0].r - model.nodes[0].position);
        CHECK((displacement - 6.0 * Vec3::Unit(i)).norm() < 1e-14);
        Supports(model).set_rates(2.0, {1.9, 0.2}, state.trial);
        CHECK((axes.conjugate() * state.trial[0].v - 3.0 * Vec3::Unit(i)).norm() < 1e-12);
    }
}

TEST_CASE("a position is placed along the support's own axes", "[constraints]") {
    // x moves, y is fixed, z is free.
    Support support{.axes = axes};
    support.moved[0] = support.fixed[1] = true;
    support.motion[0] = TimeFunction([](double t) { return 0.1 * t * t; });
    const Model model = make_model(support);
    const Supports supports(model);
    State state = make_state(model);
    state.trial[0].r += axes * Vec3(5.0, 6.0, 7.0);
    supports.place(2.0, state);
    const Vec3 displacement = axes.conjugate() * (state.trial[0].r - model.nodes[0].position);
    CHECK((displacement - Vec3(0.4, 0.0, 7.0)).norm() < 1e-14);
    CHECK(state.trial[0].Lambda.isApprox(Quat::Identity(), 0.0));
    CHECK(state.trial[0].theta.isZero(0.0));
}

TEST_CASE("a rotation is placed through a hundred turns, each step's whole", "[constraints]") {
    // 2.5 rad a step, about a skew axis: φ in the support's axes.
    const Vec3 direction = Vec3(2.0, -1.0, 2.0) / 3.0;
    const Model model = make_model(make_turning({TimeFunction([&](double t) { return t * direction.x(); }),
                                                 TimeFunction([&](double t) { return t * direction.y(); }),
                                                 TimeFunction([&](double t) { return t * direction.z(); })}));
    const Supports supports(model);
    for (const double sense : {1.0, -1.0}) {
        State state = make_state(model);
        for (int step = 1; 2.5 * step < 200.0 * std::numbers::pi; ++step) {
            const double time = sense * 2.5 * step;
            supports.place(time, state);
            const Vec3 theta = sense * 2.5 * (axes * direction);
            CHECK((state.trial[0].theta - theta).norm() < 1e-12);
            CHECK(state.trial[0].Lambda.angularDistance(exp_quaternion(time * (axes * direction))) < 1e-12);
            commit(state, time);
        }
    }
    // More than half a turn at once too.
    State state = make_state(model);
    supports.place(5.0 * std::numbers::pi, state);
    CHECK((state.trial[0].theta - 5.0 * std::numbers::pi * (axes * direction)).norm() < 1e-12);
}

TEST_CASE("a rotation that begins with a jump is a step from no rotation", "[constraints]") {
    const Model model = make_model(make_turning({TimeFunction(0.0), TimeFunction(0.0), TimeFunction(4.0)}));
    State state = make_state(model);
    Supports(model).place(0.5, state);
    CHECK((state.trial[0].theta - axes * Vec3(0.0, 0.0, 4.0)).norm() < 1e-14);
    commit(state, 0.05);  // the same function from then on turns nothing
    Supports(model).place(0.5, state);
    CHECK(state.trial[0].theta.norm() < 1e-14);
}

TEST_CASE("a rotation whose axis leans while it turns takes steps of its angular velocity", "[constraints]") {
    // φ = 4t (cos εt, sin εt, 0): after many turns its difference over a step is not the step's rotation.
    constexpr double lean = 1.0;
    const Model model =
        make_model(make_turning({TimeFunction([](double t) { return 4.0 * t * std::cos(lean * t); }),
                                 TimeFunction([](double t) { return 4.0 * t * std::sin(lean * t); }),
                                 TimeFunction(0.0)}));
    const Supports supports(model);
    State state = make_state(model);
    constexpr double step = 0.1;
    for (int k = 1; k <= 1000; ++k) {
        supports.place(k * step, state);
        // |ω| is at most |φ̇| along the axis and 2 × the axis's own turn across it.
        CHECK(state.trial[0].theta.norm() < step * (4.0 + 2.0 * lean) + 1e-12);
        commit(state, k * step);
    }
}

TEST_CASE("a support on a hinge of its own leaves the rotation to it", "[constraints]") {
    Support support{.axes = axes};
    support.fixed = {true, false, true, true, true, false};
    support.moved[1] = true;
    support.motion[1] = TimeFunction([](double t) { return t; });
    const Model model = make_model(support);
    const Supports supports(model);
    State state = make_state(model);
    const Quat turned = exp_quaternion(axes * Vec3(0.0, 0.0, 0.7));
    state.trial[0].Lambda = turned;
    state.trial[0].theta = axes * Vec3(0.0, 0.0, 0.7);
    supports.place(0.5, state);
    CHECK(state.trial[0].Lambda.coeffs() == turned.coeffs());
    CHECK(state.trial[0].theta == axes * Vec3(0.0, 0.0, 0.7));
    CHECK((state.trial[0].r - model.nodes[0].position - axes * Vec3(0.0, 0.5, 0.0)).norm() < 1e-14);
}

TEST_CASE("rates of held components are those of f, or zero where fixed", "[constraints]") {
    // x and z move by polynomials of degree 6, which differences know exactly; y is fixed.
    Support support{.fixed = {false, true, false, false, false, false}, .axes = axes};
    support.moved = {true, false, true, false, false, false};
    support.motion[0] = TimeFunction([](double t) { return 2.0 * t + t * t - 3.0 * std::pow(t, 6); });
    support.motion[2] = TimeFunction([](double t) { return std::pow(t, 3) - std::pow(t, 5); });
    const Model model = make_model(support);
    const Supports supports(model);
    for (const double t : {0.4, 0.47, 0.5, 0.7}) {
        State state = make_state(model);
        NodeMotion& motion = state.trial[0];
        motion.v = motion.a = motion.omega = motion.alpha = Vec3(9.0, 8.0, 7.0);
        supports.set_rates(t, {0.4, 0.3}, state.trial);
        const Vec3 v(2.0 + 2.0 * t - 18.0 * std::pow(t, 5), 0.0, 3.0 * t * t - 5.0 * std::pow(t, 4));
        const Vec3 a(2.0 - 90.0 * std::pow(t, 4), 0.0, 6.0 * t - 20.0 * std::pow(t, 3));
        CHECK((axes.conjugate() * motion.v - v).norm() < 1e-12);
        CHECK((axes.conjugate() * motion.a - a).norm() < 1e-10);
        CHECK(motion.omega == Vec3(9.0, 8.0, 7.0));
        CHECK(motion.alpha == Vec3(9.0, 8.0, 7.0));
    }
}

TEST_CASE("a hinge leaves the spin and a free axis its velocity, a clamp neither", "[constraints]") {
    const Model model = make_model({.fixed = {true, false, true, true, true, false}, .axes = axes});
    const Supports supports(model);
    State state = make_state(model);
    NodeMotion& motion = state.trial[0];
    motion.v = motion.a = motion.omega = motion.alpha = axes * Vec3(1.0, 2.0, 3.0);
    supports.set_rates(0.0, {0.0, 1.0}, state.trial);
    for (const Vec3& rate : {motion.v, motion.a}) {
        CHECK((rate - axes * Vec3(0.0, 2.0, 0.0)).norm() < 1e-15);
    }
    for (const Vec3& rate : {motion.omega, motion.alpha}) CHECK(rate == axes * Vec3(1.0, 2.0, 3.0));
    const Model clamped = make_model({.fixed = {false, false, false, true, true, true}, .axes = axes});
    Supports(clamped).set_rates(0.0, {0.0, 1.0}, state.trial);
    CHECK((motion.omega.isZero(0.0) && motion.alpha.isZero(0.0)));
}

TEST_CASE("prescribed rotations give the angular velocity and acceleration of exp(phi)", "[constraints]") {
    const auto phi = [](double t) { return Vec3(3.0 * std::sin(t), 40.0 * t, t * t); };
    const Model model = make_model(make_turning({TimeFunction([&](double t) { return phi(t).x(); }),
                                                 TimeFunction([&](double t) { return phi(t).y(); }),
                                                 TimeFunction([&](double t) { return phi(t).z(); })}));
    const Supports supports(model);
    const auto omega = [&](double t) {
        const auto turned = [&](double dt) {
            return Mat3(exp_quaternion(axes * phi(t + dt)).toRotationMatrix());
        };
        return axial(differentiate(turned, 5e-4) * turned(0.0).transpose());
    };
    for (const double time : {0.0, 0.6, 2.0}) {
        State state = make_state(model);
        supports.set_rates(time, {time - 0.03, 0.05}, state.trial);
        CHECK(relative_difference(state.trial[0].omega, omega(time)) < 1e-9);
        const Vec3 alpha = differentiate([&](double dt) { return omega(time + dt); }, 2e-3);
        CHECK(relative_difference(state.trial[0].alpha, alpha) < 1e-7);
        CHECK(state.trial[0].v.isZero(0.0));
    }
}
