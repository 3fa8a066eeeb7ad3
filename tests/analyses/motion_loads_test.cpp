// Forces that depend on where their point is and how fast it moves, against motions that are known exactly.

#include "analyses/shapes/eigenvalues.hpp"
#include "tools/catch.hpp"
#include "tools/run.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double mass = 2.0;

Model make_body(const Vec3& place, const Vec3& velocity, const MotionForce& force) {
    Model model;
    model.nodes.push_back({"body", place, velocity});
    Body body;
    body.name = "body";
    body.mass = mass;
    body.inertia = Vec3(0.3, 0.4, 0.5).asDiagonal();
    model.bodies.push_back(body);
    NodalLoad load;
    load.key = "load[0]";
    load.motion_force = force;
    model.loads.push_back(load);
    return model;
}

template <class Exact>
double measure(const Model& model, Scheme scheme, long steps, const Exact& exact) {
    DynamicSettings settings = make_settings(scheme, 2.0, steps);
    settings.newton.tolerance = 1e-12;
    double error = 0.0;
    run(model, settings, [&](const DynamicAnalysis& analysis) {
        const Vec3 difference = analysis.state().trial[0].r - exact(analysis.state().time);
        error = std::max(error, difference.norm());
    });
    return error;
}

template <class Exact>
void check_orders(const Model& model, const Exact& exact) {
    for (const auto& [scheme, order, steps] : {std::tuple(Scheme::newmark_simplified, 2.0, 100L),
                                               {Scheme::generalized_alpha, 2.0, 100L},
                                               {Scheme::sdirk_4, 4.0, 40L},
                                               {Scheme::runge_kutta_4, 4.0, 40L}}) {
        const double coarse = measure(model, scheme, steps, exact);
        const double fine = measure(model, scheme, 2 * steps, exact);
        INFO("scheme " << static_cast<int>(scheme) << ", errors " << coarse << " " << fine);
        CHECK(std::log2(coarse / fine) == Approx(order).margin(0.3));
    }
}

}  // namespace

TEST_CASE("a body in a drag that grows with the square of its speed", "[analyses]") {
    // m v' = −c |v| v: r = (m/c) log(1 + c v₀ t/m) along v₀.
    constexpr double drag = 1.5;
    const Vec3 velocity(3.0, -1.0, 2.0);
    const Model model = make_body(Vec3::Zero(), velocity, [](double, const Vec3&, const Vec3& v) {
        return Vec3(-drag * v.norm() * v);
    });
    check_orders(model, [&](double t) -> Vec3 {
        const double speed = velocity.norm();
        return mass / drag * std::log(1.0 + drag * speed * t / mass) * velocity / speed;
    });
}

TEST_CASE("a body drawn to a centre goes round it", "[analyses]") {
    // By the inverse square of the distance, on a circle of radius 2 with speed 1.5.
    constexpr double speed = 1.5, radius = 2.0;
    constexpr double strength = mass * speed * speed * radius;
    const Model model =
        make_body(Vec3(radius, 0.0, 0.0), Vec3(0.0, speed, 0.0), [](double, const Vec3& r, const Vec3&) {
            return Vec3(-strength / std::pow(r.norm(), 3) * r);
        });
    check_orders(model, [&](double t) -> Vec3 {
        const double angle = speed * t / radius;
        return radius * Vec3(std::cos(angle), std::sin(angle), 0.0);
    });
}

TEST_CASE("eigenvalues see forces by motion", "[analyses]") {
    // A spring and a damper by expressions.
    constexpr double stiffness = 50.0, damping = 3.0;
    Model model = make_body(Vec3::Zero(), Vec3::Zero(), [](double, const Vec3& r, const Vec3& v) {
        return Vec3(-stiffness * r.x() - damping * v.x(), 0.0, 0.0);
    });
    Support support;
    support.fixed = {false, true, true, true, true, true};
    model.supports.push_back(support);
    const System system(model);
    const EigenvaluesRecord record = find_eigenvalues(system, system.initial_state(), 0.0, {.count = 1});
    REQUIRE(record.failure.empty());
    REQUIRE(!record.modes.empty());
    const double growth = -damping / (2.0 * mass);
    CHECK(record.modes[0].growth == Approx(growth));
    CHECK(record.modes[0].omega == Approx(std::sqrt(stiffness / mass - growth * growth)));
}
