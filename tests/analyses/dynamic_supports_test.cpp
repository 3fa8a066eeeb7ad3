// Supports that move in time: bodies and rods that are carried along, their reactions and the work of those.
#include <numbers>

#include "integrators/scheme_samples.hpp"
#include "rotation/rates.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"
#include "tools/rod_models.hpp"
#include "tools/run.hpp"
#include "tools/tops.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// Starts with no acceleration and no rate of one.
double push(double t) { return 0.3 * std::pow(std::sin(t), 4); }
double push_rate(double t) { return 1.2 * std::pow(std::sin(t), 3) * std::cos(t); }

// A body carried along an axis of its own and turned about another: r = Q f(t) e_x, φ = Q (0, 0.4 f, 2 f).
const Quat Q = RandomValues(131).rotation();
Model make_carried_body() {
    Model model = make_free_body(Vec3(1.0, 2.0, 4.0), Vec3::Zero());
    model.bodies[0].mass = 3.0;
    Support support{.fixed = {false, true, true, true, false, false}, .axes = Q};
    for (const auto& [component, size] : {std::pair(0, 1.0), {4, 0.4}, {5, 2.0}}) {
        support.moved[component] = true;
        support.motion[component] = TimeFunction([size](double t) { return size * push(t); });
    }
    model.supports.push_back(support);
    return model;
}

// A bar of length 1 with waves of speed 1 whose start is pushed along: u = f(t − x) until the wave arrives.
Model make_pushed_bar(int elements, int order) {
    Model model =
        make_rod_model(along_x, 1.0, {elements, order}, make_section({1, 1, 1, 1, 1, 1}, {1, 1, 1, 1, 1, 1}));
    Support support{.fixed = {false, true, true, true, true, true}};
    support.moved[0] = true;
    support.motion[0] = TimeFunction(push);
    model.supports.push_back(support);
    return model;
}

struct Errors {
    double motion = 0.0;
    double energy = 0.0;
};

template <class Measure>
Errors measure(const Model& model, const DynamicSettings& settings, Measure&& of_state) {
    Errors errors;
    run(model, settings, [&](DynamicAnalysis& analysis) {
        errors.motion = std::max(errors.motion, of_state(analysis));
        errors.energy = std::max(errors.energy, std::abs(analysis.ledger_row().energy_error));
    });
    return errors;
}

DynamicSettings settings_of(const SchemeSample& scheme, double end_time, long steps) {
    DynamicSettings settings = scheme.settings;
    settings.end_time = end_time;
    settings.steps = steps;
    settings.newton.tolerance = 1e-13;
    return settings;
}

}  // namespace

TEST_CASE("a body that its support carries is where the support wants it", "[analyses][supports]") {
    const Model model = make_carried_body();
    for (const SchemeSample& scheme : all_schemes()) {
        INFO(scheme.name);
        const DynamicSettings settings = settings_of(scheme, 2.0, 40);
        const Errors errors = measure(model, settings, [&](const DynamicAnalysis& analysis) {
            const double f = push(analysis.state().time);
            const NodeMotion& motion = analysis.state().trial[0];
            const Quat wanted = exp_quaternion(Q * Vec3(0.0, 0.4 * f, 2.0 * f));
            return std::max((motion.r - Q * Vec3(f, 0.0, 0.0)).norm(), motion.Lambda.angularDistance(wanted));
        });
        CHECK(errors.motion < 1e-14);
    }
}

TEST_CASE("the reaction of a carried body is what changes its momenta, its work their energy",
          "[analyses][supports]") {
    const Model model = make_carried_body();
    const auto momenta_at = [](double t) {
        const Vec3 phi = Q * Vec3(0.0, 0.4 * push(t), 2.0 * push(t));
        const Vec3 omega = angular_velocity(phi, Q * Vec3(0.0, 0.4 * push_rate(t), 2.0 * push_rate(t)));
        const Mat3 Lambda = exp_matrix(phi);
        Vec6 momenta;
        momenta << 3.0 * (Q * Vec3(push_rate(t), 0.0, 0.0)),
            Lambda * (Vec3(1.0, 2.0, 4.0).asDiagonal() * (Lambda.transpose() * omega));
        return momenta;
    };
    for (const SchemeSample& scheme : all_schemes()) {
        const auto measure_steps = [&](long steps) {
            return measure(model, settings_of(scheme, 2.0, steps), [&](DynamicAnalysis& analysis) {
                const double t = analysis.state().time;
                const Vec6 expected = differentiate([&](double dt) { return momenta_at(t + dt); });
                return (analysis.snapshot().reactions[0] - expected).norm();
            });
        };
        const Errors coarse = measure_steps(40);
        const Errors fine = measure_steps(80);
        INFO(scheme.name << ": " << coarse.motion << " " << fine.motion << ", energy " << coarse.energy << " "
                         << fine.energy);
        CHECK(coarse.motion < 1e-5);
        CHECK(fine.motion < 2e-7);
        const double order = scheme.order > 2.0 ? scheme.order : 2.0;
        CHECK(std::log2(coarse.energy / fine.energy) == Approx(order).margin(0.2));
    }
}

TEST_CASE("a support can start with a jerk and turn at a corner", "[analyses][supports]") {
    // Neither leaves anything behind in the accelerations.
    Model model = make_free_body(Vec3(1.0, 2.0, 4.0), Vec3::Zero());
    Support support{.fixed = {false, true, true, true, true, true}, .axes = Q};
    support.moved[0] = true;
    support.motion[0] = TimeFunction([](double t) { return t < 1.0 ? std::sin(t) : std::sin(1.0); });
    model.supports.push_back(support);
    for (const SchemeSample& scheme : all_schemes()) {
        INFO(scheme.name);
        const Errors errors = measure(model, settings_of(scheme, 2.0, 40), [&](DynamicAnalysis& analysis) {
            const double t = analysis.state().time;
            const NodeMotion& motion = analysis.state().trial[0];
            const Vec3 v = Q.conjugate() * motion.v;
            const Vec3 a = Q.conjugate() * motion.a;
            // At the corner itself, as before it.
            const bool moving = t < 1.01;
            return (v - Vec3(moving ? std::cos(t) : 0.0, 0.0, 0.0)).norm() +
                   (a - Vec3(moving ? -std::sin(t) : 0.0, 0.0, 0.0)).norm();
        });
        CHECK(errors.motion < 1e-9);
    }
}

TEST_CASE("a wave runs from a moving support into a bar", "[analyses][supports]") {
    const Model model = make_pushed_bar(4, 4);
    const auto compute_error = [&](const DynamicAnalysis& analysis) {
        double error = 0.0;
        for (std::size_t i = 0; i < model.nodes.size(); ++i) {
            const double x = model.nodes[i].position.x();
            const double u = push(std::max(0.0, analysis.state().time - x));
            error = std::max(error, (analysis.state().trial[i].r - Vec3(x + u, 0.0, 0.0)).norm());
        }
        return error;
    };
    for (const SchemeSample& scheme : all_schemes()) {
        // Explicit steps, and those of β = 1/6, have to resolve the mesh's fastest oscillation, and sdirk-4
        // does for its order: what is left of their errors is the mesh's.
        const bool is_resolved = scheme.order > 2.0 || scheme.settings.beta < 0.25;
        const long steps = is_resolved ? 100 : 40;
        const Errors coarse = measure(model, settings_of(scheme, 1.0, steps), compute_error);
        const Errors fine = measure(model, settings_of(scheme, 1.0, 2 * steps), compute_error);
        INFO(scheme.name << ": " << coarse.motion << " " << fine.motion << ", energy " << coarse.energy << " "
                         << fine.energy);
        if (is_resolved) {
            CHECK(fine.motion < 1e-5);
        } else {
            CHECK(std::log2(coarse.motion / fine.motion) == Approx(scheme.order).margin(0.3));
        }
        constexpr double round_off = 1e-12;
        if (fine.energy > round_off) CHECK(std::log2(coarse.energy / fine.energy) > scheme.order - 0.4);
    }
}

TEST_CASE("steps by their error see how well a moving support is followed", "[analyses][supports]") {
    // An estimate of order 4: a tolerance ten thousand times smaller takes ten times the steps.
    const Model model = make_carried_body();
    const auto count_steps = [&](double tolerance) {
        DynamicSettings settings = make_settings(Scheme::sdirk_4, 2.0, 20);
        settings.adaptive = AdaptiveSettings{};
        settings.adaptive->tolerance = tolerance;
        DynamicAnalysis analysis(model, settings);
        REQUIRE(analysis.start().converged());
        while (!analysis.finished()) REQUIRE(analysis.advance().converged());
        return static_cast<double>(analysis.steps().steps_done());
    };
    const double coarse = count_steps(1e-5);
    const double fine = count_steps(1e-9);
    CHECK(coarse < 60.0);
    CHECK(fine / coarse > 5.0);
    CHECK(fine / coarse < 15.0);
}
