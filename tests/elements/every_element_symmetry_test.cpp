// What every element owes to the symmetries of space, checked for one of each kind: rigid motions, frame
// indifference, mirrors.

#include "elements/element_samples.hpp"
#include "state/increment.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double round_off = 1e-13;  // relative

const Vec3 gravity(0.3, -1.1, -9.0);
const Vec3 turn(0.9, -1.2, 0.7);
const Vec3 shift(4.0, 1.0, -2.0);

// The motion seen after the whole world was turned by Q and shifted; the reference shape stays.
NodeMotion superpose(const Quat& Q, const NodeMotion& motion) {
    return {Q * motion.r + shift,
            Q * motion.Lambda,
            Q * motion.theta,
            Q * motion.v,
            Q * motion.a,
            Q * motion.omega,
            Q * motion.alpha};
}

template <class Nodal>
Nodal superpose(const Quat& Q, Nodal nodal) {
    for (NodeMotion& motion : nodal) motion = superpose(Q, motion);
    return nodal;
}

Remembered superpose(const Quat& Q, Remembered histories) {
    for (SectionHistory& history : histories.axes) history.Lambda = Q * history.Lambda;
    return histories;
}

// Every node at its place in the reference shape turned by `rotation` and shifted, within one step.
template <Element E>
auto move_rigidly(const ElementSample<E>& sample, const Vec3& rotation) {
    typename ElementSample<E>::Nodal nodal;
    for (int i = 0; i < E::node_count; ++i) {
        const Vec3 place_after = exp_quaternion(rotation) * sample.reference[i] + shift;
        place(NodeMotion{}, place_after, rotation, nodal[i]);
    }
    return nodal;
}

// Calls check(sample, image) with each sample and itself after the isometry.
template <class Check>
void for_each_image(const Isometry& isometry, Check&& check) {
    for (unsigned seed = 1; seed <= sample_seeds; ++seed) {
        const ElementSamples samples = make_samples(seed);
        const ElementSamples images = make_samples(seed, isometry);
        const auto check_member = [&]<std::size_t index>(std::integral_constant<std::size_t, index>) {
            check(std::get<index>(samples), std::get<index>(images));
        };
        [&]<std::size_t... index>(std::index_sequence<index...>) {
            (check_member(std::integral_constant<std::size_t, index>()), ...);
        }(std::make_index_sequence<std::tuple_size_v<ElementSamples>>());
    }
}

void check_images(const Isometry& isometry) {
    for_each_image(isometry, [&](const auto& sample, const auto& image) {
        INFO(sample.name);
        CHECK(relative_difference(image.strain_energy(image.motions), sample.strain_energy(sample.motions)) <
              round_off);
        CHECK(relative_difference(image.kinetic_energy(image.motions),
                                  sample.kinetic_energy(sample.motions)) < round_off);
        CHECK(relative_difference(image.internal_force(image.motions),
                                  isometry.forces(sample.internal_force(sample.motions))) < round_off);
        CHECK(relative_difference(image.inertial_force(image.motions, isometry.polar(gravity)),
                                  isometry.forces(sample.inertial_force(sample.motions, gravity))) <
              round_off);
        const Momentum momentum = sample.momentum(sample.motions);
        const Momentum image_momentum = image.momentum(image.motions);
        CHECK(relative_difference(image_momentum.linear, isometry.polar(momentum.linear)) < round_off);
        CHECK(relative_difference(image_momentum.angular, isometry.axial(momentum.angular)) < round_off);
    });
}

}  // namespace

TEST_CASE("a rigid motion from the reference shape strains nothing", "[elements]") {
    for_each_sample([](const auto& sample) {
        INFO(sample.name);
        const auto histories = sample.start();
        for (const Vec3& rotation : {Vec3(0.0, 0.0, 0.0), Vec3(1e-7, 0.0, 0.0), turn, Vec3(0.0, 3.1, 0.0)}) {
            const auto nodal = move_rigidly(sample, rotation);
            // Stiffnesses are of order one, but positions of order 5 are divided by as little as a tenth of
            // the element's 0.7.
            CHECK(sample.internal_force(nodal, histories).norm() < 2e-13);
            CHECK(sample.strain_energy(nodal, histories) < 1e-26);
        }
    });
}

TEST_CASE("a step after a rigid rotation strains as the step itself", "[elements]") {
    for_each_sample([](const auto& sample) {
        INFO(sample.name);
        const Quat Q = exp_quaternion(turn);
        const auto turned = superpose(Q, sample.motions);
        const auto histories = superpose(Q, sample.histories);
        CHECK(relative_difference(sample.strain_energy(turned, histories),
                                  sample.strain_energy(sample.motions)) < round_off);
        const Isometry rotation{Q.toRotationMatrix()};
        CHECK(relative_difference(sample.internal_force(turned, histories),
                                  rotation.forces(sample.internal_force(sample.motions))) < round_off);
    });
}

TEST_CASE("a rotation common to all nodes leaves committed strains as they were", "[elements]") {
    for_each_sample([](const auto& sample) {
        INFO(sample.name);
        auto still = sample.motions;
        for (NodeMotion& motion : still) motion.theta.setZero();
        auto turned = still;
        for (NodeMotion& motion : turned) {
            place(motion, exp_quaternion(turn) * motion.r + shift, turn, motion);
        }
        const double energy = sample.strain_energy(still);
        CHECK(relative_difference(sample.strain_energy(turned), energy) < round_off);
        const auto axes = sample.committed(turned).axes;
        const auto expected = superpose(exp_quaternion(turn), sample.histories).axes;
        for (std::size_t p = 0; p < axes.size(); ++p) {
            CHECK(relative_difference(axes[p].K, expected[p].K) < round_off);
            CHECK(axes[p].Lambda.angularDistance(expected[p].Lambda) < 1e-15);
        }
    });
}

TEST_CASE("inertia does not depend on the observer's orientation", "[elements]") {
    for_each_sample([](const auto& sample) {
        INFO(sample.name);
        const Quat Q = exp_quaternion(turn);
        const Isometry rotation{Q.toRotationMatrix()};
        const auto turned = superpose(Q, sample.motions);
        CHECK(relative_difference(sample.kinetic_energy(turned), sample.kinetic_energy(sample.motions)) <
              round_off);
        CHECK(relative_difference(sample.inertial_force(turned, Q * gravity),
                                  rotation.forces(sample.inertial_force(sample.motions, gravity))) <
              round_off);
        CHECK(relative_difference(sample.momentum(turned).linear,
                                  Q * sample.momentum(sample.motions).linear) < round_off);
    });
}

TEST_CASE("a mirror reflects forces and keeps the sense of moments", "[elements]") {
    RandomValues random(3);
    check_images(Isometry::mirror(Vec3::UnitX()));
    check_images(Isometry::mirror(random.direction()));
}

TEST_CASE("an element placed elsewhere gives the same forces there", "[elements]") {
    RandomValues random(4);
    check_images(Isometry{random.rotation().toRotationMatrix()});
}
