#include "elements/rod/simo_element.hpp"

#include <catch2/catch.hpp>

#include "elements/element_samples.hpp"
#include "state/increment.hpp"
#include "tools/difference.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double piece_length = 0.4;
constexpr int piece_count = 5;

// A straight run of elements along a random direction, node I at s = I × piece_length.
struct Run {
    Quat axes = RandomValues(41).rotation();
    Vec3 start{0.3, -0.2, 0.9};
    std::vector<SimoElement<2>> elements;
    std::vector<NodeMotion> motions;
    std::vector<SectionHistory> histories;

    explicit Run(const Mat6& stiffness) : histories(piece_count) {
        const Section section{"tube", stiffness, Mat6::Identity()};
        for (int e = 0; e < piece_count; ++e) {
            elements.emplace_back(RodElementGeometry<2>{{e, e + 1}, {at(e), at(e + 1)}, {axes, axes}},
                                  section);
            elements.back().start({&histories[e], 1});
        }
    }
    Vec3 at(int node) const { return start + axes * Vec3(node * piece_length, 0.0, 0.0); }

    // The exact motion of constant strains: the section turns by K along the run, every element has the slope
    // Λ (e₁ + Γ) at its middle. Made in one step from the reference shape; the start node turns by `turn`.
    void strain(const Vec3& Gamma, const Vec3& K, const Vec3& turn) {
        motions.assign(piece_count + 1, {});
        Vec3 r = start;
        for (int node = 0; node <= piece_count; ++node) {
            const Quat Lambda = exp_quaternion(turn) * axes * exp_quaternion(node * piece_length * K);
            place({}, r, log(Lambda * axes.conjugate()), motions[node]);
            r += Lambda * (exp_quaternion(0.5 * piece_length * K) * (piece_length * (Vec3::UnitX() + Gamma)));
        }
    }
    Motions<2> motions_of(int e) const { return {&motions[e], &motions[e + 1]}; }
    SectionValues values(int e) const {
        return elements[e].section_values(motions_of(e), {&histories[e], 1});
    }

    // Internal force at every node.
    std::vector<Vec6> compute_forces() const {
        std::vector<Vec6> forces(piece_count + 1, Vec6::Zero());
        for (int e = 0; e < piece_count; ++e) {
            NodalVector<2> force = NodalVector<2>::Zero();
            elements[e].add_internal_force(motions_of(e), {&histories[e], 1}, force);
            forces[e] += force.head<6>();
            forces[e + 1] += force.tail<6>();
        }
        return forces;
    }
};

Mat6 make_diagonal_stiffness() {
    Mat6 stiffness = Mat6::Zero();
    stiffness.diagonal() << 50.0, 30.0, 20.0, 3.0, 4.0, 5.0;
    return stiffness;
}

void check_constant_strain(const Run& run, const Vec3& Gamma, const Vec3& K, const Mat6& stiffness) {
    Vec6 strain;
    strain << Gamma, K;
    const Vec6 resultants = stiffness * strain;
    for (int e = 0; e < piece_count; ++e) {
        INFO("element " << e);
        const SectionValues values = run.values(e);
        CHECK((values.strain - Gamma).norm() < 1e-14);
        CHECK((values.curvature - K).norm() < 1e-14);
        CHECK((values.force - resultants.head<3>()).norm() < 1e-12);
        CHECK((values.moment - resultants.tail<3>()).norm() < 1e-12);
    }
}

// The ends carry ∓ the resultants, the nodes between them nothing.
void check_equilibrium(const Run& run, const Vec3& force, const Vec3& moment) {
    const auto forces = run.compute_forces();
    Vec6 at_end;
    at_end << force, moment;
    CHECK((forces.front() + at_end).norm() < 1e-12);
    CHECK((forces.back() - at_end).norm() < 1e-12);
    for (int node = 1; node < piece_count; ++node) CHECK(forces[node].norm() < 1e-12);
}

}  // namespace

TEST_CASE("any constant strain is reproduced exactly", "[elements][rod]") {
    const Mat6 stiffness = RandomValues(42).positive_definite<6>();
    Run run(stiffness);
    const Vec3 stretch(0.1, 0.0, 0.0);
    const Vec3 shear(0.0, 0.2, -0.1);
    const Vec3 twist(0.9, 0.0, 0.0);
    const Vec3 bend(0.0, 0.5, -0.8);
    const Vec3 zero = Vec3::Zero();
    // Rotations of the nodes about one axis: interpolated without error.
    for (const auto& [Gamma, K] : {std::pair(stretch, zero),
                                   {shear, zero},
                                   {zero, twist},
                                   {zero, bend},
                                   {Vec3(stretch + shear), Vec3(twist + bend)}}) {
        run.strain(Gamma, K, zero);
        check_constant_strain(run, Gamma, K, stiffness);
    }
    // Also as a rigid rotation, committed, and then the strain.
    run.strain(zero, zero, Vec3(0.3, -1.0, 0.6));
    for (int e = 0; e < piece_count; ++e) run.elements[e].commit(run.motions_of(e), {&run.histories[e], 1});
    std::vector<NodeMotion> previous = run.motions;
    run.strain(stretch, bend, Vec3(0.3, -1.0, 0.6));
    for (int i = 0; i <= piece_count; ++i) {
        run.motions[i].theta = log(run.motions[i].Lambda * previous[i].Lambda.conjugate());
    }
    check_constant_strain(run, stretch, bend, stiffness);
}

TEST_CASE("stretch and twist are in equilibrium along a whole run", "[elements][rod]") {
    Run run(make_diagonal_stiffness());
    run.strain(Vec3(0.1, 0.0, 0.0), Vec3(0.9, 0.0, 0.0), Vec3::Zero());
    check_equilibrium(run, run.axes * Vec3(5.0, 0.0, 0.0), run.axes * Vec3(2.7, 0.0, 0.0));
}

TEST_CASE("pure bending is in equilibrium along a whole run", "[elements][rod]") {
    // The moment EI κ about the section's z stays fixed in space.
    Run run(make_diagonal_stiffness());
    run.strain(Vec3::Zero(), Vec3(0.0, 0.0, 0.8), Vec3::Zero());
    check_equilibrium(run, Vec3::Zero(), run.axes * Vec3(0.0, 0.0, 4.0));
}

TEST_CASE("a helix of an isotropic section is in equilibrium along a whole run", "[elements][rod]") {
    // GJ = EI: the moment GJ K is fixed in space for any K.
    Mat6 stiffness = make_diagonal_stiffness();
    stiffness.diagonal().tail<3>().setConstant(2.0);
    Run run(stiffness);
    const Vec3 K(0.5, 0.3, -0.9);
    run.strain(Vec3::Zero(), K, Vec3::Zero());
    check_equilibrium(run, Vec3::Zero(), run.axes * (2.0 * K));
}

TEST_CASE("constant shear asks for the couples that balance it", "[elements][rod]") {
    // m′ + r′ × n = 0 with m = 0 needs couples −r′ × n per length: one piece's worth at each inner node.
    Run run(make_diagonal_stiffness());
    run.strain(Vec3(0.0, 0.2, 0.0), Vec3::Zero(), Vec3::Zero());
    const auto forces = run.compute_forces();
    const Vec3 n = run.axes * Vec3(0.0, 6.0, 0.0);
    const Vec3 r_prime = run.axes * Vec3(1.0, 0.2, 0.0);
    const Vec3 couple = -piece_length * r_prime.cross(n);
    for (int node = 1; node < piece_count; ++node) {
        CHECK(forces[node].head<3>().norm() < 1e-13);
        CHECK((forces[node].tail<3>() - couple).norm() < 1e-13);
    }
    CHECK((forces.back().head<3>() - n).norm() < 1e-13);
    CHECK((forces.back().tail<3>() - 0.5 * couple).norm() < 1e-13);
}

TEST_CASE("a step that is committed leaves the strains as they were", "[elements][rod]") {
    for (unsigned seed = 1; seed <= sample_seeds; ++seed) {
        const auto sample = std::get<ElementSample<SimoElement<2>>>(make_samples(seed));
        const auto before = sample.element.section_values(sample.point_at(sample.motions), sample.histories);
        auto histories = sample.histories;
        sample.element.commit(sample.point_at(sample.motions), histories);
        auto still = sample.motions;
        for (NodeMotion& motion : still) motion.theta.setZero();
        const auto after = sample.element.section_values(sample.point_at(still), histories);
        CHECK(relative_difference(after.strain, before.strain) < 1e-14);
        CHECK(relative_difference(after.curvature, before.curvature) < 1e-14);
        CHECK(after.axes.angularDistance(before.axes) < 1e-15);
        CHECK(relative_difference(sample.strain_energy(still, histories),
                                  sample.strain_energy(sample.motions)) < 1e-13);
    }
}

TEST_CASE("interpolated rotation vectors are not frame-indifferent, by the square of the element's turn",
          "[elements][rod]") {
    // A pure bend of one element, and the same bend with a rotation of the step added at both nodes.
    const auto compute_error = [](double bend) {
        const Section section{"tube", make_diagonal_stiffness(), Mat6::Identity()};
        const SimoElement<2> element(
            {{0, 1}, {Vec3::Zero(), Vec3::UnitX()}, {Quat::Identity(), Quat::Identity()}}, section);
        std::vector<SectionHistory> histories(1);
        element.start(histories);
        const auto measure = [&](const Vec3& turn) {
            std::array<NodeMotion, 2> nodal;
            for (int i = 0; i < 2; ++i) {
                const Vec3 theta = compose(turn, (i - 0.5) * bend * Vec3::UnitZ());
                place({}, exp_quaternion(turn) * Vec3(i, 0.0, 0.0), theta, nodal[i]);
            }
            return element.section_values({&nodal[0], &nodal[1]}, histories).curvature;
        };
        return relative_difference(measure(Vec3(0.0, 1.0, 0.0)), measure(Vec3::Zero()));
    };
    const double error = compute_error(0.2);
    CHECK(error > 1e-4);
    CHECK(std::log2(error / compute_error(0.1)) == Approx(2.0).margin(0.05));
    CHECK(std::log2(compute_error(0.1) / compute_error(0.05)) == Approx(2.0).margin(0.05));
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
        auto histories = sample.histories;
        sample.element.commit(sample.point_at(nodal), histories);
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
