// Contact of a pin in its hole, and of a ball in its socket.

#include "constraints/joints/play/clearance_force.hpp"

#include "constraints/joints/joint_samples.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/node_paths.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double tolerance = 1e-9;  // of derivatives by seven-point differences
using Wrench = Eigen::Matrix<double, 12, 1>;

JointClearance make_clearance(double gap) {
    JointClearance clearance;
    clearance.contact = {
        .lower = std::nullopt, .upper = gap, .stiffness = 3.1, .exponent = 1.5, .hysteresis = 0.02};
    clearance.friction = 0.4;
    clearance.radius = 0.7;
    clearance.slip_speed = 0.5;
    return clearance;
}

// Calls check(sample) for each kind that can have a clearance, with points that touch.
template <class Check>
void for_each_loose_joint(Check&& check) {
    for (JointSample sample : joint_samples()) {
        const JointKind kind = sample.joint.kind;
        if (kind != JointKind::ball && kind != JointKind::hinge && kind != JointKind::cylinder) continue;
        sample.joint.clearance = make_clearance(1.0);
        const double distance = ClearanceForce(sample.joint).compute_distance(sample.motions());
        sample.joint.clearance = make_clearance(0.4 * distance);
        INFO(sample.name);
        check(sample);
    }
}

template <class Derivative, class Function>
Derivative differentiate_loose(const JointSample& sample,
                               const NodeLinearization& linearization,
                               Function&& function) {
    Derivative derivative;
    for (int unknown = 0; unknown < 12; ++unknown) {
        derivative.col(unknown) = differentiate([&](double amount) {
            NodeMotion a = sample.a, b = sample.b;
            const Vec6 direction = Vec6::Unit(unknown % 6);
            if (unknown < 6)
                a = follow(sample.previous_a, a, linearization, direction, amount);
            else
                b = follow(sample.previous_b, b, linearization, direction, amount);
            return function(JointMotions{a, b});
        });
    }
    return derivative;
}

}  // namespace

TEST_CASE("Contact in a clearance at rest is the slope of its energy", "[constraints][joints]") {
    int kinds = 0;
    for_each_loose_joint([&](JointSample sample) {
        for (NodeMotion* motion : {&sample.a, &sample.b}) {
            motion->v.setZero();
            motion->omega.setZero();
        }
        using Value = Eigen::Matrix<double, 1, 1>;
        const ClearanceForce contact(sample.joint);
        const auto slope = differentiate_loose<PairRow>(
            sample, {.placement = 1.0}, [&](const JointMotions& motions) -> Value {
                return Value(contact.compute_energy(motions));
            });
        CHECK(slope.norm() > 0.1);
        CHECK(relative_difference(-contact.compute_force(sample.motions()), slope) < tolerance);
        ++kinds;
    });
    CHECK(kinds >= 3);
}

TEST_CASE("The tangent of contact in a clearance is the derivative of its force", "[constraints][joints]") {
    for_each_loose_joint([](const JointSample& sample) {
        const ClearanceForce contact(sample.joint);
        for (const auto& [what, linearization] : make_linearizations()) {
            INFO(what);
            const auto expected =
                differentiate_loose<PairMatrix>(sample, linearization, [&](const JointMotions& motions) {
                    return Wrench(contact.compute_force(motions).transpose());
                });
            const PairMatrix tangent =
                contact.compute_tangent(sample.motions(), {linearization, linearization});
            CHECK((tangent - expected).norm() < tolerance * (1.0 + expected.norm()));
        }
    });
}

TEST_CASE("Contact in a clearance takes the power that it should, and balances", "[constraints][joints]") {
    for_each_loose_joint([](const JointSample& sample) {
        const ClearanceForce contact(sample.joint);
        const PairRow force = contact.compute_force(sample.motions());
        Wrench velocities;
        velocities << sample.a.v, sample.a.omega, sample.b.v, sample.b.omega;
        const SmoothMotion a{sample.a, {0, 0, 0}, sample.a.omega, {0, 0, 0}, {0, 0, 0}};
        const SmoothMotion b{sample.b, {0, 0, 0}, sample.b.omega, {0, 0, 0}, {0, 0, 0}};
        const double growth = differentiate([&](double t) {
            const NodeMotion now_a = a.at(t), now_b = b.at(t);
            return contact.compute_energy({now_a, now_b});
        });
        const double damped = contact.compute_damping_power(sample.motions());
        CHECK(damped > 0.0);
        CHECK(force.dot(velocities) + growth + damped == Approx(0.0).margin(1e-8 * (1.0 + damped)));
        const Vec3 on_a = force.segment<3>(0).transpose(), on_b = force.segment<3>(6).transpose();
        CHECK((on_a + on_b).norm() < 1e-12);
        const Vec3 moment = sample.a.r.cross(on_a) + sample.b.r.cross(on_b) +
                            force.segment<3>(3).transpose() + force.segment<3>(9).transpose();
        CHECK(moment.norm() < 1e-12 * (1.0 + force.norm()));
    });
}

TEST_CASE("Points within a clearance are free", "[constraints][joints]") {
    for_each_loose_joint([](JointSample sample) {
        const double distance = ClearanceForce(sample.joint).compute_distance(sample.motions());
        sample.joint.clearance = make_clearance(1.001 * distance);
        const ClearanceForce contact(sample.joint);
        const NodeLinearization linearization = make_linearizations().back().second;
        CHECK(contact.compute_force(sample.motions()).isZero(0.0));
        CHECK(contact.compute_tangent(sample.motions(), {linearization, linearization}).isZero(0.0));
        CHECK(contact.compute_energy(sample.motions()) == 0.0);
        CHECK(contact.compute_damping_power(sample.motions()) == 0.0);
    });
}

TEST_CASE("A pin pushes by Hertz's law and rubs by Coulomb's", "[constraints][joints]") {
    Joint joint;
    joint.kind = JointKind::hinge;
    joint.a.axes << Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitY();
    joint.b.axes = joint.a.axes;
    joint.clearance = make_clearance(0.3);
    joint.clearance->contact.hysteresis = 0.0;
    joint.clearance->slip_speed = 1e-9;
    NodeMotion hole, pin;
    pin.r = {0.5, 0.0, 7.0};      // along the axis it does not matter
    pin.omega = {0.0, 0.0, 2.0};  // the surface moves by 2 × 0.7 along y
    const double push = 3.1 * std::pow(0.2, 1.5);
    const PairRow force = ClearanceForce(joint).compute_force({hole, pin});
    CHECK(force[6] == Approx(-push));
    CHECK(force[7] == Approx(-0.4 * push));
    CHECK(force[11] == Approx(-0.7 * 0.4 * push));
    CHECK(ClearanceForce(joint).compute_damping_power({hole, pin}) == Approx(0.4 * push * 1.4));
}
