// What is special to bushings: large rotations, the ground, which end is A.

#include "elements/bushing_element.hpp"
#include "elements/carried_bushing_element.hpp"

#include <algorithm>
#include <utility>

#include "elements/element_samples.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

template <class E>
NodalVector<E::node_count> compute_force(const E& element, const Motions<E::node_count>& motions) {
    NodalVector<E::node_count> force = NodalVector<E::node_count>::Zero();
    element.add_internal_force(motions, {}, force);
    element.add_damping_force(motions, {}, force);
    return force;
}

template <class E>
NodalMatrix<E::node_count> compute_tangent(const E& element, const Motions<E::node_count>& motions) {
    RandomValues random(3);
    const NodeLinearization linearization{1.0, 1.7, 2.3, random.matrix<3>(), random.matrix<3>()};
    Linearizations<E::node_count> linearizations;
    linearizations.fill(&linearization);
    NodalMatrix<E::node_count> tangent = NodalMatrix<E::node_count>::Zero();
    element.add_internal_tangent(motions, {}, linearizations, tangent);
    element.add_damping_tangent(motions, {}, linearizations, tangent);
    return tangent;
}

// Both ends of a bushing in motion, turned against each other by `angle`.
struct Sample {
    Bushing bushing;
    std::array<NodeMotion, 2> motions;

    Sample(unsigned seed, double angle) {
        RandomValues random(seed);
        bushing = make_bushing(random, {Vec3(0.2, 0.1, -0.4), Vec3(1.0, 0.3, 0.2)});
        for (NodeMotion& motion : motions) {
            motion.r = random.vector();
            motion.Lambda = random.rotation();
            motion.v = random.vector();
            motion.omega = random.vector(2.0);
        }
        motions[1].Lambda = exp_quaternion(angle * random.direction()) * motions[0].Lambda;
    }
    Motions<2> point() const { return {&motions[0], &motions[1]}; }
};

}  // namespace

TEST_CASE("a bushing's forces balance and are the gradient of its energy at any rotation", "[elements]") {
    for (const double angle : {0.0, 1e-6, 0.3, 1.5, 3.0}) {
        Sample sample(4, angle);
        INFO("turned by " << angle);
        const BushingElement<2> element(sample.bushing);
        CHECK(element.largest_relative_rotation(sample.point()) == Approx(angle).margin(1e-15));
        Vec6 sum = Vec6::Zero();
        const auto force = compute_force(element, sample.point());
        for (int i = 0; i < 2; ++i) {
            const Vec3 f = force.segment<3>(6 * i);
            sum.head<3>() += f;
            sum.tail<3>() += sample.motions[i].r.cross(f) + force.segment<3>(6 * i + 3);
        }
        CHECK(sum.norm() < 1e-13 * force.norm());
        NodalVector<2> elastic = NodalVector<2>::Zero();
        element.add_internal_force(sample.point(), {}, elastic);
        NodalVector<2> gradient;
        for (int unknown = 0; unknown < 12; ++unknown) {
            gradient[unknown] = differentiate([&](double amount) {
                auto moved = sample.motions;
                NodeMotion& node = moved[unknown / 6];
                const Vec6 step = amount * Vec6::Unit(unknown % 6);
                node.r += step.head<3>();
                node.Lambda = exp_quaternion(step.tail<3>()) * node.Lambda;
                return element.strain_energy(Motions<2>{&moved[0], &moved[1]}, {});
            });
        }
        CHECK(relative_difference(elastic, gradient) < 1e-8);
    }
}

TEST_CASE("a bushing does not know which of its ends is A", "[elements]") {
    const Sample sample(5, 1.2);
    Bushing swapped = sample.bushing;
    std::swap(swapped.ends[0], swapped.ends[1]);
    const BushingElement<2> element(sample.bushing);
    const BushingElement<2> other(swapped);
    // Its nodes are the other way round, and so are its strains.
    const Motions<2> at_other{&sample.motions[1], &sample.motions[0]};
    CHECK(relative_difference(other.strain_energy(at_other, {}), element.strain_energy(sample.point(), {})) <
          1e-14);
    NodalVector<2> expected;
    expected << compute_force(other, at_other).tail<6>(), compute_force(other, at_other).head<6>();
    CHECK(relative_difference(compute_force(element, sample.point()), expected) < 1e-14);
}

TEST_CASE("a bushing to the ground acts as one to a node at rest", "[elements]") {
    for (const int end : {0, 1}) {
        Sample sample(7, 0.8);
        sample.motions[end] = NodeMotion{};
        sample.motions[1 - end].Lambda = exp_quaternion(Vec3(0.3, -0.9, 0.5));
        Bushing grounded = sample.bushing;
        grounded.ends[end].node = -1;  // its node is at the origin, so that the arm is its place
        const BushingElement<1> to_ground(grounded);
        const BushingElement<2> between(sample.bushing);
        const Motions<1> one{&sample.motions[1 - end]};
        const int first = 6 * (1 - end);
        CHECK(relative_difference(compute_force(to_ground, one),
                                  compute_force(between, sample.point()).segment<6>(first)) < 1e-14);
        CHECK(relative_difference(compute_tangent(to_ground, one),
                                  compute_tangent(between, sample.point()).block<6, 6>(first, first)) <
              1e-14);
    }
}

TEST_CASE("a torsion spring turns back by stiffness times angle, about any axis", "[elements]") {
    Bushing bushing;
    bushing.ends = {Anchor{}, Anchor{0}};
    bushing.stiffness.diagonal() << 0.0, 0.0, 0.0, 8.0, 8.0, 8.0;
    bushing.damping.diagonal() << 0.0, 0.0, 0.0, 0.5, 0.5, 0.5;
    const BushingElement<1> spring(bushing);
    NodeMotion node;
    node.r = Vec3(1.0, 2.0, 3.0);
    const Vec3 axis = Vec3(1.0, -2.0, 2.0) / 3.0;
    node.Lambda = exp_quaternion(2.5 * axis);
    node.omega = 3.0 * axis;
    Vec6 expected;
    expected << Vec3::Zero(), (8.0 * 2.5 + 0.5 * 3.0) * axis;
    CHECK((compute_force(spring, Motions<1>{&node}) - expected).norm() < 1e-13);
    CHECK(spring.strain_energy(Motions<1>{&node}, {}) == Approx(0.5 * 8.0 * 2.5 * 2.5));
    NodeMotion further = node;
    further.Lambda = exp_quaternion(2.6 * axis);
    CHECK(spring.damping_action(Motions<1>{&node}, Motions<1>{&further}, {}) == Approx(0.5 * 0.01));
}

namespace {

// The sample's bushing with axes that turn with `carrier`, and without stiffness about the first `free` of
// them.
Bushing carry(Bushing bushing, BushingAxes carrier, int free) {
    bushing.carrier = carrier;
    for (int axis = 0; axis < std::min(free, 3); ++axis) {
        bushing.stiffness.col(3 + axis).setZero();
        bushing.stiffness.row(3 + axis).setZero();
    }
    if (free == 3) {
        bushing.damping.col(4).setZero();
        bushing.damping.row(4).setZero();
    }
    return bushing;
}

// Both nodes where they are after a time, at their velocities.
std::array<NodeMotion, 2> advance(std::array<NodeMotion, 2> motions, double time) {
    for (NodeMotion& motion : motions) {
        motion.r += time * motion.v;
        motion.Lambda = exp_quaternion(time * motion.omega) * motion.Lambda;
    }
    return motions;
}

}  // namespace

TEST_CASE("axes of a bushing that one end or the ground carries: gradients, powers, derivatives",
          "[elements]") {
    for (const BushingAxes carrier : {BushingAxes::a, BushingAxes::b, BushingAxes::ground}) {
        for (const int free : {0, 1, 2, 3, 4}) {
            INFO("carrier " << static_cast<int>(carrier) << ", free axes " << free);
            Sample sample(9, 0.7);
            const Bushing bushing = carry(sample.bushing, carrier, free);
            // A shaft that has turned by 5 rad more.
            if (free == 1) {
                sample.motions[1].Lambda =
                    sample.motions[1].Lambda * exp_quaternion(5.0 * (bushing.axes * Vec3::UnitX()));
            }
            const CarriedBushingElement<2> element(bushing);
            const auto force_of = [&](const std::array<NodeMotion, 2>& motions) {
                return compute_force(element, Motions<2>{&motions[0], &motions[1]});
            };
            NodalVector<2> elastic = NodalVector<2>::Zero();
            element.add_internal_force(sample.point(), {}, elastic);
            RandomValues random(3);
            const NodeLinearization linear{1.0, 1.7, 2.3, random.matrix<3>(), random.matrix<3>()};
            NodalVector<2> gradient;
            NodalMatrix<2> tangent;
            for (int unknown = 0; unknown < 12; ++unknown) {
                const auto move = [&](double amount) {
                    auto moved = sample.motions;
                    NodeMotion& node = moved[unknown / 6];
                    const Vec6 step = amount * Vec6::Unit(unknown % 6);
                    node.r += step.head<3>();
                    node.v += linear.rate * step.head<3>();
                    node.omega += linear.d_omega * step.tail<3>();
                    node.Lambda = exp_quaternion(step.tail<3>()) * node.Lambda;
                    return moved;
                };
                gradient[unknown] = differentiate([&](double amount) {
                    const auto moved = move(amount);
                    return element.strain_energy(Motions<2>{&moved[0], &moved[1]}, {});
                });
                tangent.col(unknown) = differentiate([&](double amount) { return force_of(move(amount)); });
            }
            CHECK(relative_difference(elastic, gradient) < 1e-8);
            CHECK(relative_difference(compute_tangent(element, sample.point()), tangent) < 1e-8);
            // The power of the damper is its rates' quadratic form, and its action that of a short step.
            const CarriedBushingMotion motion =
                compute_carried_motion(bushing, &sample.motions[0], &sample.motions[1]);
            NodalVector<2> damper = NodalVector<2>::Zero();
            element.add_damping_force(sample.point(), {}, damper);
            double power = 0.0;
            for (int i = 0; i < 2; ++i) {
                power += damper.segment<3>(6 * i).dot(sample.motions[i].v) +
                         damper.segment<3>(6 * i + 3).dot(sample.motions[i].omega);
            }
            CHECK(power == Approx(motion.rate.dot(bushing.damping * motion.rate)));
            constexpr double half = 1e-4;
            const auto before = advance(sample.motions, -half), after = advance(sample.motions, half);
            const double action = element.damping_action(
                Motions<2>{&before[0], &before[1]}, Motions<2>{&after[0], &after[1]}, {});
            CHECK(action == Approx(4.0 * half * half * power).epsilon(1e-6));
            // Forces balance, unless the ground leans on them.
            const auto force = force_of(sample.motions);
            Vec3 moment = Vec3::Zero();
            for (int i = 0; i < 2; ++i) {
                const Vec3 f = force.segment<3>(6 * i);
                moment += sample.motions[i].r.cross(f) + force.segment<3>(6 * i + 3);
            }
            CHECK((moment.norm() < 1e-12 * force.norm()) == (carrier != BushingAxes::ground));
        }
    }
}

TEST_CASE("a bearing sees the tilt of a shaft and its drag, not how the shaft spins", "[elements]") {
    Bushing bushing;
    bushing.ends = {Anchor{}, Anchor{0}};
    bushing.carrier = BushingAxes::ground;
    bushing.stiffness.diagonal() << 0.0, 0.0, 0.0, 0.0, 8.0, 8.0;
    bushing.damping.diagonal() << 0.0, 0.0, 0.0, 0.5, 3.0, 3.0;
    const CarriedBushingElement<1> bearing(bushing);
    const Quat tilt = exp_quaternion(Vec3(0.0, 1.2, 0.0));
    for (const double turned : {0.0, 2.0, 100.0}) {
        NodeMotion node;
        node.Lambda = tilt * exp_quaternion(Vec3(turned, 0.0, 0.0));
        const Vec3 along = tilt * Vec3::UnitX();
        node.omega = 7.0 * along;
        const Vec6 force = compute_force(bearing, Motions<1>{&node});
        // 8 × 1.2 about y; the drag acts about the direction half way between the shaft and the bearing.
        const Vec3 half = (along + Vec3::UnitX()) / (1.0 + along.x());
        CHECK((force.tail<3>() - Vec3(0.0, 8.0 * 1.2, 0.0) - 0.5 * 7.0 * half).norm() < 1e-12);
        CHECK(bearing.strain_energy(Motions<1>{&node}, {}) == Approx(0.5 * 8.0 * 1.2 * 1.2));
    }
}
