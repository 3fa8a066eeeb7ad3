// Springs, dampers, drives, friction and limits on the coordinates of joints.

#include "constraints/joints/joint_force.hpp"

#include <numbers>

#include "constraints/joints/joint_samples.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/node_paths.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double tolerance = 1e-9;  // of derivatives by seven-point differences
const JointInputs inputs{{0.3, -0.7, 0.0}, {-0.2, 0.9, 0.0}};

// Every law, so that limits push, and friction sticks where `slips` are those that belong to the place.
JointCoordinate make_laws(double coordinate) {
    JointCoordinate laws;
    laws.drive = TimeFunction(1.0);
    laws.stiffness = 2.1;
    laws.damping = 0.4;
    laws.friction = {0.6, 0.5, 0.0};
    laws.limits = {{}, coordinate - 0.7, 3.0, 0.2};
    return laws;
}

double find_turn(const JointSample& sample) {
    const JointCoordinates coordinates(sample.joint);
    return coordinates.turn ? coordinates.turn->compute_jet(sample.motions(), sample.turn_before).value : 0.0;
}

double find_slide(const JointSample& sample) {
    const JointCoordinates coordinates(sample.joint);
    return coordinates.slide ? coordinates.slide->compute_jet(sample.motions()).value : 0.0;
}

// Calls check(sample, forces, slips) for each joint with coordinates, once where friction sticks and once
// where it slips.
template <class Check>
void for_each_loaded_joint(Check&& check) {
    for (JointSample sample : joint_samples()) {
        if (!sample.joint.has_turn() && !sample.joint.has_slide()) continue;
        const double turn = find_turn(sample), slide = find_slide(sample);
        sample.joint.turn = make_laws(turn);
        sample.joint.slide = make_laws(slide);
        for (const double stretch : {0.2, -0.9}) {
            INFO(sample.name << ", friction stretched by " << stretch);
            check(sample, JointForces(sample.joint), JointSlips{turn - stretch, slide - stretch});
        }
    }
}

template <class Derivative, class Function>
Derivative differentiate_loaded(const JointSample& sample,
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

void stop(NodeMotion& motion) {
    motion.v.setZero();
    motion.omega.setZero();
}

// A coordinate under one law.
double force_of(const JointCoordinate& laws, double value, double rate = 0.0, double slip = 0.0) {
    return compute_coordinate_force(laws, {value, rate, 0.0}, {}, slip).value;
}

}  // namespace

TEST_CASE("forces on coordinates at rest are the slope of their energy", "[constraints][joints]") {
    for_each_loaded_joint([](JointSample sample, const JointForces& forces, const JointSlips& slips) {
        stop(sample.a);
        stop(sample.b);
        if (std::abs(slips.turn - find_turn(sample)) > 0.5) return;  // slips: no energy stands for it
        using Value = Eigen::Matrix<double, 1, 1>;
        const JointInputs without_drive{{inputs.turn.rest, 0.0, 0.0}, {inputs.slide.rest, 0.0, 0.0}};
        const auto slope = differentiate_loaded<PairRow>(
            sample, {.placement = 1.0}, [&](const JointMotions& motions) -> Value {
                return Value(forces.compute_strain_energy(motions, sample.turn_before, without_drive, slips));
            });
        const PairRow force =
            forces.compute_force(sample.motions(), sample.turn_before, without_drive, slips);
        CHECK(relative_difference(-force, slope) < tolerance);
    });
}

TEST_CASE("tangents of forces on coordinates are their derivatives", "[constraints][joints]") {
    for_each_loaded_joint([](const JointSample& sample, const JointForces& forces, const JointSlips& slips) {
        for (const auto& [what, linearization] : make_linearizations()) {
            INFO(what);
            const auto expected =
                differentiate_loaded<PairMatrix>(sample, linearization, [&](const JointMotions& motions) {
                    const PairRow force = forces.compute_force(motions, sample.turn_before, inputs, slips);
                    return Eigen::Matrix<double, 12, 1>(force.transpose());
                });
            const PairMatrix tangent = forces.compute_tangent(
                sample.motions(), {linearization, linearization}, sample.turn_before, inputs, slips);
            CHECK((tangent - expected).norm() < tolerance * (1.0 + expected.norm()));
        }
    });
}

TEST_CASE("the linearizations of A and B count for their own unknowns", "[constraints][joints]") {
    const auto some = make_linearizations(21).back().second;
    auto other = make_linearizations(22).back().second;
    other.placement = 0.0;
    other.rate = -0.6;
    other.acceleration = 0.9;
    for_each_loaded_joint([&](const JointSample& sample, const JointForces& forces, const JointSlips& slips) {
        const auto tangent = [&](const NodeLinearization& a, const NodeLinearization& b) {
            return forces.compute_tangent(sample.motions(), {a, b}, sample.turn_before, inputs, slips);
        };
        CHECK(tangent(some, other).leftCols<6>() == tangent(some, some).leftCols<6>());
        CHECK(tangent(some, other).rightCols<6>() == tangent(other, other).rightCols<6>());
    });
}

TEST_CASE("forces on coordinates take the power that they should", "[constraints][joints]") {
    // Power on both nodes + growth of the energy + damping = power of the drive, at fixed rest.
    for_each_loaded_joint([](const JointSample& sample, const JointForces& forces, const JointSlips& slips) {
        const JointCoordinates coordinates(sample.joint);
        const JointMotions motions = sample.motions();
        const PairRow force = forces.compute_force(motions, sample.turn_before, inputs, slips);
        Eigen::Matrix<double, 12, 1> velocities;
        velocities << sample.a.v, sample.a.omega, sample.b.v, sample.b.omega;
        const SmoothMotion a{sample.a, {0, 0, 0}, sample.a.omega, {0, 0, 0}, {0, 0, 0}};
        const SmoothMotion b{sample.b, {0, 0, 0}, sample.b.omega, {0, 0, 0}, {0, 0, 0}};
        const double growth = differentiate([&](double t) {
            const NodeMotion now_a = a.at(t), now_b = b.at(t);
            return forces.compute_strain_energy({now_a, now_b}, sample.turn_before, inputs, slips);
        });
        double driven = 0.0, slipping = 0.0;
        const auto add = [&](const ScalarJet& jet, const CoordinateInputs& input, double slip) {
            driven += input.drive * jet.rate;
            if (std::abs(jet.value - slip) > 0.5) slipping += std::copysign(0.6, jet.value - slip) * jet.rate;
        };
        if (coordinates.turn)
            add(coordinates.turn->compute_jet(motions, sample.turn_before), inputs.turn, slips.turn);
        if (coordinates.slide) add(coordinates.slide->compute_jet(motions), inputs.slide, slips.slide);
        const double damped = forces.compute_damping_power(motions, sample.turn_before);
        CHECK(damped >= 0.0);
        CHECK(force.dot(velocities) + growth + damped + slipping == Approx(driven).epsilon(1e-8));
    });
}

TEST_CASE("springs on coordinates pull to their rest, drives push B along", "[constraints][joints]") {
    JointCoordinate laws;
    laws.stiffness = 2.0;
    laws.damping = 0.5;
    CHECK(compute_coordinate_force(laws, {1.0, 0.0, 0.0}, {0.4, 0.0}, 0.0).value == Approx(-1.2));
    CHECK(compute_coordinate_force(laws, {1.0, 3.0, 0.0}, {0.4, 0.7}, 0.0).value == Approx(-2.0));
    CHECK(compute_coordinate_energy(laws, 1.0, {0.4, 0.7}, 0.0) == Approx(0.36));
    CHECK(compute_coordinate_damping_power(laws, {1.0, 3.0, 0.0}) == Approx(4.5));
}

TEST_CASE("friction takes the area of its loop", "[constraints][joints]") {
    // Swung to and fro by ± 1: each half swing slips by 2 − 2 × stick.
    JointCoordinate laws;
    laws.friction = {3.0, 0.1};
    constexpr int steps = 4000;
    double slip = 0.0, work = 0.0, dissipated = 0.0, before = force_of(laws, 0.0, 0.0, 0.0);
    double value = 0.0;
    for (int i = 1; i <= 5 * steps; ++i) {
        const double next = std::sin(0.5 * std::numbers::pi * i / steps);
        const double force = force_of(laws, next, 0.0, slip);
        work -= 0.5 * (force + before) * (next - value);
        const double slipped = compute_slip(laws.friction, next, slip);
        dissipated += compute_slip_dissipation(laws.friction, 0.0, slip, slipped);
        slip = slipped;
        value = next;
        before = force;
        // A force never exceeds what slips, and a new slip point leaves it.
        CHECK(std::abs(force) <= 3.0);
        CHECK(force_of(laws, next, 0.0, slip) == Approx(force).margin(1e-12));
        if (i == steps) CHECK(dissipated == Approx(3.0 * 0.9));
    }
    CHECK(dissipated == Approx(3.0 * (0.9 + 2.0 * 1.8)));
    CHECK(work == Approx(dissipated + compute_coordinate_energy(laws, value, {}, slip)).epsilon(1e-5));
}

TEST_CASE("friction at the start holds what rests and brakes what moves", "[constraints][joints]") {
    JointCoordinate laws;
    laws.friction = {3.0, 0.1};
    for (const double rate : {0.0, 2.0, -2.0}) {
        const double slip = compute_first_slip(laws.friction, {5.0, rate, 0.0}, 10.0);
        CHECK(force_of(laws, 5.0, rate, slip) == Approx(rate == 0.0 ? 0.0 : std::copysign(3.0, -rate)));
    }
    // A rate within the round-off of both sides' speeds counts as rest.
    for (const double rate : {1e-15, -1e-15}) {
        CHECK(compute_first_slip(laws.friction, {5.0, rate, 0.0}, 10.0) == 5.0);
        CHECK(compute_first_slip(laws.friction, {5.0, rate, 0.0}, 0.0) != 5.0);
    }
}

TEST_CASE("friction holds a joint of a model that turns as a whole", "[constraints][joints]") {
    RandomValues random(617);
    for (JointSample sample : joint_samples()) {
        if (!sample.joint.has_turn() && !sample.joint.has_slide()) continue;
        INFO(sample.name);
        const Vec3 omega = random.vector(), v = random.vector();
        for (NodeMotion* node : {&sample.a, &sample.b}) {
            node->omega = omega;
            node->v = v + omega.cross(node->r);
        }
        sample.joint.turn.friction = sample.joint.slide.friction = {3.0, 0.5};
        const JointSlips first =
            JointForces(sample.joint).compute_first_slips(sample.motions(), sample.turn_before);
        if (sample.joint.has_turn()) CHECK(first.turn == Approx(find_turn(sample)).margin(1e-12));
        if (sample.joint.has_slide()) CHECK(first.slide == Approx(find_slide(sample)).margin(1e-12));
    }
}

TEST_CASE("limits push back and never pull", "[constraints][joints]") {
    JointCoordinate laws;
    laws.limits = {-1.0, 2.0, 10.0, 0.5};
    CHECK(force_of(laws, 1.9, 100.0) == 0.0);
    CHECK(force_of(laws, -0.9, -100.0) == 0.0);
    CHECK(force_of(laws, 2.1) == Approx(-1.0));
    CHECK(force_of(laws, 2.1, 1.0) == Approx(-1.5));
    CHECK(force_of(laws, 2.1, -1.0) == Approx(-0.5));
    CHECK(force_of(laws, 2.1, -3.0) == 0.0);
    CHECK(force_of(laws, -1.1) == Approx(1.0));
    CHECK(force_of(laws, -1.1, -1.0) == Approx(1.5));
    CHECK(force_of(laws, -1.1, 3.0) == 0.0);
    CHECK(compute_coordinate_energy(laws, 2.1, {}, 0.0) == Approx(0.05));
    CHECK(compute_coordinate_energy(laws, -1.2, {}, 0.0) == Approx(0.2));
    // Where nothing pulls, what the spring releases is lost.
    CHECK(compute_coordinate_damping_power(laws, {2.1, -3.0, 0.0}) == Approx(3.0));
    CHECK(compute_coordinate_damping_power(laws, {2.1, -1.0, 0.0}) == Approx(0.5));
    CHECK(compute_coordinate_damping_power(laws, {1.9, -1.0, 0.0}) == 0.0);
    // At upper alone, or lower alone.
    laws.limits.lower.reset();
    CHECK(force_of(laws, -5.0) == 0.0);
    laws.limits = {-1.0, {}, 10.0, 0.5};
    CHECK(force_of(laws, 5.0) == 0.0);
}

TEST_CASE("derivatives of forces on one coordinate", "[constraints][joints]") {
    JointCoordinate laws = make_laws(0.4);
    laws.limits.lower = 0.9;  // no limit at 0.95, the lower one at 0.4, the upper one at 2
    laws.limits.upper = 1.5;
    for (const double value : {0.4, 0.95, 2.0}) {
        for (const double slip : {value - 0.2, value + 0.2, value - 0.9, value + 0.9}) {
            INFO(value << ", slip at " << slip);
            const auto force = compute_coordinate_force(laws, {value, 0.3, 0.0}, inputs.turn, slip);
            const double by_coordinate = differentiate([&](double x) {
                return compute_coordinate_force(laws, {value + x, 0.3, 0.0}, inputs.turn, slip).value;
            });
            const double by_rate = differentiate([&](double x) {
                return compute_coordinate_force(laws, {value, 0.3 + x, 0.0}, inputs.turn, slip).value;
            });
            CHECK(force.by_coordinate == Approx(by_coordinate));
            CHECK(force.by_rate == Approx(by_rate));
        }
    }
}

TEST_CASE("slips of joints are those of their coordinates", "[constraints][joints]") {
    for_each_loaded_joint([](const JointSample& sample, const JointForces& forces, const JointSlips& slips) {
        const JointMotions motions = sample.motions();
        const JointSlips next = forces.compute_slips(motions, sample.turn_before, slips);
        const double turned = std::abs(slips.turn - find_turn(sample)) > 0.5 ? 0.4 : 0.0;
        const int coordinates = sample.joint.has_turn() + sample.joint.has_slide();
        CHECK(forces.compute_dissipation(inputs, slips, next) ==
              Approx(coordinates * 0.6 * turned).margin(1e-12));
        const JointSlips first = forces.compute_first_slips(motions, sample.turn_before);
        if (sample.joint.has_turn()) CHECK(std::abs(first.turn - find_turn(sample)) == Approx(0.5));
        if (sample.joint.has_slide()) CHECK(std::abs(first.slide - find_slide(sample)) == Approx(0.5));
    });
}

TEST_CASE("joints on whose coordinates nothing acts have no forces", "[constraints][joints]") {
    RandomValues random(611);
    Joint joint = make_joint(JointKind::hinge, random);
    CHECK(JointForces(joint).is_empty());
    joint.slide.stiffness = 1.0;  // of a coordinate that a hinge has not
    CHECK(JointForces(joint).is_empty());
    joint.turn.friction = {1.0, 1e-4};
    CHECK(!JointForces(joint).is_empty());
}
