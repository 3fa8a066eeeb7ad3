// Loads that depend on how their points move, against motions that are known exactly.

#include "analyses/shapes/eigenvalues.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/rod_models.hpp"
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
    load.by_motion = MotionLoad(force);
    model.loads.push_back(load);
    return model;
}

// Held but for the turn about z, which a moment drives.
Model make_wheel(double speed, double stiffness, double damping) {
    Model model = make_body(Vec3::Zero(), Vec3::Zero(), {});
    model.nodes[0].angular_velocity = Vec3(0.0, 0.0, speed);
    Support support;
    support.fixed = {true, true, true, true, true, false};
    model.supports.push_back(support);
    MotionLoad moment;
    moment.has_moment = moment.turns = true;
    moment.value = [=](double, double, const PointMotion& motion) {
        Vec6 load = Vec6::Zero();
        load.tail<3>() = -stiffness * motion.rotation - damping * motion.spin;
        return load;
    };
    model.loads[0].by_motion = moment;
    return model;
}

// The error of a body's place, or of its turn.
template <class Exact>
double measure(const Model& model, Scheme scheme, long steps, const Exact& exact) {
    DynamicSettings settings = make_settings(scheme, 2.0, steps);
    settings.newton.tolerance = 1e-12;
    double error = 0.0;
    run(model, settings, [&](const DynamicAnalysis& analysis) {
        const NodeMotion& motion = analysis.state().trial[0];
        const Vec3 found = model.loads[0].by_motion.has_moment ? log(motion.Lambda) : motion.r;
        const Vec3 difference = found - exact(analysis.state().time);
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

TEST_CASE("a wheel on a torsion spring with a damper, by its moment", "[analyses]") {
    constexpr double inertia = 0.5, stiffness = 6.0, damping = 0.4, speed = 3.0;
    const double decay = damping / (2.0 * inertia), omega = std::sqrt(stiffness / inertia - decay * decay);
    const Model model = make_wheel(speed, stiffness, damping);
    check_orders(model, [&](double t) -> Vec3 {
        return {0.0, 0.0, speed / omega * std::exp(-decay * t) * std::sin(omega * t)};
    });
    const System system(model);
    const EigenvaluesRecord record = find_eigenvalues(system, system.initial_state(), 0.0, {.count = 1});
    REQUIRE(!record.modes.empty());
    CHECK(record.modes[0].growth == Approx(-decay));
    CHECK(record.modes[0].omega == Approx(omega));
}

TEST_CASE("a rod on a bed of springs and dampers bounces as one body", "[analyses]") {
    constexpr double mass_per_length = 2.0, stiffness = 50.0, damping = 3.0;
    Model model =
        make_rod_model(along_x,
                       1.5,
                       {3, 2},
                       make_section({1e7, 1e7, 1e7, 1e6, 1e6, 1e6},
                                    {mass_per_length, mass_per_length, mass_per_length, 1.0, 0.5, 0.5}));
    Support support;
    support.fixed = {true, true, false, true, true, true};
    model.supports.push_back(support);
    DistributedLoad load;
    load.by_motion = MotionLoad([](double, const Vec3& r, const Vec3& v) {
        return Vec3(0.0, 0.0, -stiffness * r.z() - damping * v.z());
    });
    model.distributed_loads.push_back(load);
    const System system(model);
    const EigenvaluesRecord record = find_eigenvalues(system, system.initial_state(), 0.0, {.count = 1});
    REQUIRE(!record.modes.empty());
    const double growth = -damping / (2.0 * mass_per_length);
    CHECK(record.modes[0].growth == Approx(growth));
    CHECK(record.modes[0].omega == Approx(std::sqrt(stiffness / mass_per_length - growth * growth)));
}
