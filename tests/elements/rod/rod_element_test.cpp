// Constant strains, along a whole run of elements of every kind and order.
#include "elements/rod/rod_element.hpp"

#include "elements/element_samples.hpp"
#include "elements/rod/rod_run.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double length = 2.0;
constexpr int piece_count = 4;
const Quat axes = RandomValues(41).rotation();
const Vec3 zero = Vec3::Zero();

Placement straight(double s) { return {Vec3(0.3, -0.2, 0.9) + axes * Vec3(s, 0.0, 0.0), axes}; }

template <class E>
RodRun<E> make_run(const Mat6& stiffness) {
    return {straight, length, piece_count, Section{"tube", stiffness, Mat6::Identity()}};
}

Mat6 make_diagonal_stiffness() {
    Mat6 stiffness = Mat6::Zero();
    stiffness.diagonal() << 50.0, 30.0, 20.0, 3.0, 4.0, 5.0;
    return stiffness;
}

template <class E>
void check_constant_strain(const RodRun<E>& run, const Vec3& Gamma, const Vec3& K, const Mat6& stiffness) {
    Vec6 strain;
    strain << Gamma, K;
    const Vec6 resultants = stiffness * strain;
    double energy = 0.0;
    for (int e = 0; e < run.piece_count(); ++e) {
        INFO("element " << e);
        const SectionValues values = run.values(e);
        CHECK((values.strain - Gamma).norm() < 1e-13);
        CHECK((values.curvature - K).norm() < 1e-13);
        CHECK((values.force - resultants.head<3>()).norm() < 1e-12);
        CHECK((values.moment - resultants.tail<3>()).norm() < 1e-12);
        energy += run.elements[e].strain_energy(run.motions_of(e), run.histories_of(e));
    }
    // At every force point, not only in the middle.
    CHECK(relative_difference(energy, 0.5 * length * strain.dot(resultants)) < 1e-13);
}

// The ends carry ∓ the resultants, the nodes between them nothing.
template <class E>
void check_equilibrium(const RodRun<E>& run, const Vec3& force, const Vec3& moment) {
    const std::vector<Vec6> forces = run.compute_forces();
    Vec6 at_end;
    at_end << force, moment;
    CHECK((forces.front() + at_end).norm() < 1e-12);
    CHECK((forces.back() - at_end).norm() < 1e-12);
    for (std::size_t node = 1; node + 1 < forces.size(); ++node) CHECK(forces[node].norm() < 1e-12);
}

}  // namespace

TEST_CASE("any constant strain is reproduced exactly", "[elements][rod]") {
    const Mat6 stiffness = RandomValues(42).positive_definite<6>();
    const Vec3 stretch(0.1, 0.0, 0.0);
    const Vec3 shear(0.0, 0.2, -0.1);
    const Vec3 twist(0.9, 0.0, 0.0);
    const Vec3 bend(0.0, 0.5, -0.8);
    for_each_rod([&]<class E>(std::type_identity<E>) {
        INFO(name_of_rod<E>());
        RodRun<E> run = make_run<E>(stiffness);
        // Rotations of the nodes about one axis: interpolated without error.
        for (const auto& [Gamma, K] : {std::pair(stretch, zero),
                                       {shear, zero},
                                       {zero, twist},
                                       {zero, bend},
                                       {Vec3(stretch + shear), Vec3(twist + bend)}}) {
            run.strain(Gamma, K, Quat::Identity());
            check_constant_strain(run, Gamma, K, stiffness);
        }
        // Also after a rigid rotation, and from one constant strain about that axis to another.
        const Quat turn = exp_quaternion(Vec3(0.3, -1.0, 0.6));
        run.strain(zero, zero, turn);
        run.commit();
        run.strain(stretch, bend, turn);
        check_constant_strain(run, stretch, bend, stiffness);
        run.commit();
        run.strain(shear, -0.5 * bend, turn);
        check_constant_strain(run, shear, -0.5 * bend, stiffness);
    });
}

TEST_CASE("stretch and twist are in equilibrium along a whole run", "[elements][rod]") {
    for_each_rod([]<class E>(std::type_identity<E>) {
        INFO(name_of_rod<E>());
        RodRun<E> run = make_run<E>(make_diagonal_stiffness());
        run.strain(Vec3(0.1, 0.0, 0.0), Vec3(0.9, 0.0, 0.0), Quat::Identity());
        check_equilibrium(run, axes * Vec3(5.0, 0.0, 0.0), axes * Vec3(2.7, 0.0, 0.0));
    });
}

TEST_CASE("pure bending is in equilibrium along a whole run", "[elements][rod]") {
    // The moment EI κ about the section's z stays fixed in space.
    for_each_rod([]<class E>(std::type_identity<E>) {
        INFO(name_of_rod<E>());
        RodRun<E> run = make_run<E>(make_diagonal_stiffness());
        run.strain(zero, Vec3(0.0, 0.0, 0.8), Quat::Identity());
        check_equilibrium(run, zero, axes * Vec3(0.0, 0.0, 4.0));
    });
}

TEST_CASE("a helix of an isotropic section is in equilibrium along a whole run", "[elements][rod]") {
    // GJ = EI: the moment GJ K is fixed in space for any K.
    Mat6 stiffness = make_diagonal_stiffness();
    stiffness.diagonal().tail<3>().setConstant(2.0);
    for_each_rod([&]<class E>(std::type_identity<E>) {
        INFO(name_of_rod<E>());
        RodRun<E> run = make_run<E>(stiffness);
        const Vec3 K(0.5, 0.3, -0.9);
        run.strain(zero, K, Quat::Identity());
        check_equilibrium(run, zero, axes * (2.0 * K));
    });
}

TEST_CASE("constant shear asks for the couples that balance it", "[elements][rod]") {
    // m′ + r′ × n = 0 with m = 0 needs couples −r′ × n per length: each node's share ∫ N_I ds of it.
    for_each_rod([]<class E>(std::type_identity<E>) {
        INFO(name_of_rod<E>());
        RodRun<E> run = make_run<E>(make_diagonal_stiffness());
        run.strain(Vec3(0.0, 0.2, 0.0), zero, Quat::Identity());
        const Vec3 n = axes * Vec3(0.0, 6.0, 0.0);
        const Vec3 couple = -(axes * Vec3(1.0, 0.2, 0.0)).cross(n);
        std::vector<double> share(run.motions.size(), 0.0);
        for (const auto& [xi, weight] : compute_gauss_rule<E::node_count>()) {
            const NodeValues<E::node_count> shape = compute_shape_functions<E::node_count>(xi);
            for (int e = 0; e < piece_count; ++e) {
                for (int i = 0; i < E::node_count; ++i) {
                    share[e * run.order + i] += 0.5 * run.piece_length * weight * shape[i];
                }
            }
        }
        const std::vector<Vec6> forces = run.compute_forces();
        for (std::size_t node = 0; node < forces.size(); ++node) {
            Vec3 expected = zero;
            if (node == 0) expected = -n;
            if (node + 1 == forces.size()) expected = n;
            CHECK((forces[node].head<3>() - expected).norm() < 1e-12);
            CHECK((forces[node].tail<3>() - share[node] * couple).norm() < 1e-12);
        }
    });
}

TEST_CASE("a step that is committed leaves the strains as they were", "[elements][rod]") {
    for_each_sample([]<Element E>(const ElementSample<E>& sample) {
        if constexpr (E::has_section) {
            INFO(sample.name);
            const auto before =
                sample.element.section_values(sample.point_at(sample.motions), sample.histories);
            const auto histories = sample.committed(sample.motions);
            auto still = sample.motions;
            for (NodeMotion& motion : still) motion.theta.setZero();
            const auto after = sample.element.section_values(sample.point_at(still), histories);
            CHECK(relative_difference(after.strain, before.strain) < 1e-14);
            CHECK(relative_difference(after.curvature, before.curvature) < 1e-14);
            CHECK(after.axes.angularDistance(before.axes) < 1e-14);
            const double dissipated =
                sample.element.dissipated_energy(sample.point_at(sample.motions), sample.histories);
            CHECK((dissipated > 0.0) == sample.element.has_law());
            CHECK(relative_difference(sample.strain_energy(still, histories) + dissipated,
                                      sample.strain_energy(sample.motions)) < 1e-13);
        }
    });
}
