// What interpolated rotation vectors of a step cost: strains that depend on rigid rotations and on when steps
// began, by how much and of which order.
#include "elements/rod/simo_map.hpp"

#include "elements/element_samples.hpp"
#include "elements/rod/rod_run.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"

using namespace gxrod;
using namespace gxrod::tools;

TEST_CASE(
    "the energy of interpolated rotation vectors changes in a rigid rotation by the power 2p of the bend",
    "[elements][rod]") {
    // A pure bend of one element, and the same bend with a rotation of the step added at both nodes.
    const auto compute_error = []<class E>(std::type_identity<E>, double bend) {
        const Line line = [](double s) { return Placement{Vec3(s, 0.0, 0.0), Quat::Identity()}; };
        Mat6 stiffness = Mat6::Identity();
        stiffness(5, 5) = 5.0;
        RodRun<E> run(line, 1.0, 1, Section{"tube", stiffness, Mat6::Identity()});
        const auto measure = [&](const Vec3& turn) {
            const Quat start = exp_quaternion(turn) * exp_quaternion(-0.5 * bend * Vec3::UnitZ());
            run.strain(Vec3::Zero(), bend * Vec3::UnitZ(), start);
            return run.elements[0].strain_energy(run.motions_of(0), run.histories_of(0));
        };
        const double exact = 0.5 * 5.0 * bend * bend;
        CHECK(relative_difference(measure(Vec3::Zero()), exact) < 1e-13);
        return relative_difference(measure(Vec3(0.0, 1.0, 0.0)), exact);
    };
    const auto check = [&]<class E>(std::type_identity<E> kind, double bend, double error, double order) {
        INFO(name_of_rod<E>() << ": " << compute_error(kind, bend));
        CHECK(compute_error(kind, bend) == Approx(error).epsilon(0.01));
        CHECK(std::log2(compute_error(kind, bend) / compute_error(kind, 0.5 * bend)) ==
              Approx(order).margin(0.15));
    };
    // Measured.
    check(std::type_identity<SimoElement<2>>(), 0.4, 3.66e-4, 2.0);
    check(std::type_identity<SimoElement<3>>(), 0.4, 4.12e-8, 4.0);
    check(std::type_identity<SimoElement<4>>(), 0.8, 1.57e-9, 6.0);
    check(std::type_identity<SimoElement<5>>(), 1.6, 4.35e-10, 8.0);
}

TEST_CASE("nodal moments depend on when a step began, to the first order of its rotation",
          "[elements][rod]") {
    // Test functions T(θ) Σ N_I T(θ_I)⁻¹ δφ_I change when a commit sets θ to zero: nodal moments then shift
    // between an element's nodes by the first order of θ_1 − θ_2, and their sum, the balance of angular
    // momentum, by the second. A scheme is of first order in the step where nothing else is left.
    const auto sample = std::get<ElementSample<SimoElement<2>>>(make_samples(1));
    struct Change {
        double shift;      // of nodal moments by a commit
        double imbalance;  // of moments about the origin before it
    };
    const auto compute_change = [&](const Vec3& theta_0, const Vec3& theta_1) {
        auto nodal = sample.motions;
        nodal[0].theta = theta_0;
        nodal[1].theta = theta_1;
        const auto before = sample.internal_force(nodal);
        const auto histories = sample.committed(nodal);
        for (NodeMotion& motion : nodal) motion.theta.setZero();
        const auto after = sample.internal_force(nodal, histories);
        Vec3 total = Vec3::Zero();
        for (int i = 0; i < 2; ++i) {
            CHECK((before.segment<3>(6 * i) - after.segment<3>(6 * i)).norm() < 1e-13);
            total += nodal[i].r.cross(before.segment<3>(6 * i)) + before.segment<3>(6 * i + 3);
        }
        return Change{(before - after).norm(), total.norm()};
    };
    const Vec3 first(0.3, -0.4, 0.2);
    const Vec3 second(-0.1, 0.5, 0.6);
    CHECK(compute_change(first, first).shift < 1e-13);
    CHECK(compute_change(first, first).imbalance < 1e-13);
    CHECK(compute_change(first, second).shift > 1e-2);
    const Change coarse = compute_change(1e-2 * first, 1e-2 * second);
    const Change fine = compute_change(5e-3 * first, 5e-3 * second);
    CHECK(std::log2(coarse.shift / fine.shift) == Approx(1.0).margin(0.05));
    CHECK(std::log2(coarse.imbalance / fine.imbalance) == Approx(2.0).margin(0.05));
}
