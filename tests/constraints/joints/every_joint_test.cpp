// Properties that the equations of every kind of joint have: rates and gradients are derivatives, forces
// balance and do no work, kinematics closes them.

#include <algorithm>
#include <numbers>

#include "constraints/joints/joint_samples.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/difference.hpp"
#include "tools/node_paths.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double tolerance = 1e-9;  // of derivatives by seven-point differences
using Level = ConstraintLevel;

// Calls check(sample, rows) for each sample.
template <class Check>
void for_each_joint(Check&& check) {
    for (const JointSample& sample : joint_samples()) {
        INFO(sample.name);
        check(sample, JointRows(sample.joint));
    }
}

// The derivative of function(a, b) as each unknown of both nodes moves.
template <class Derivative, class Function>
Derivative differentiate_pair(const JointSample& sample,
                              const NodeLinearization& linearization,
                              Function&& function) {
    const auto differentiate_by = [&](int unknown) {
        const Vec6 direction = Vec6::Unit(unknown % 6);
        return differentiate([&](double amount) {
            NodeMotion a = sample.a, b = sample.b;
            if (unknown < 6)
                a = follow(sample.previous_a, a, linearization, direction, amount);
            else
                b = follow(sample.previous_b, b, linearization, direction, amount);
            return function(JointMotions{a, b});
        });
    };
    Derivative derivative(differentiate_by(0).size(), 12);
    for (int unknown = 0; unknown < 12; ++unknown) derivative.col(unknown) = differentiate_by(unknown);
    return derivative;
}

NodeLinearization move_only() { return {.placement = 1.0}; }

JointVector make_multipliers(int count, RandomValues& random) {
    JointVector multipliers(count);
    for (double& multiplier : multipliers) multiplier = random.number(-1.0, 1.0);
    return multipliers;
}

// Samples whose nodes both move, closed at random.
template <class Check>
void for_each_closed_joint(Check&& check) {
    RandomValues random(602);
    for (JointSample sample : joint_samples()) {
        if (sample.joint.a.anchor.is_ground() || sample.joint.b.anchor.is_ground()) continue;
        INFO(sample.name);
        const FreeCoordinates free = make_free_coordinates(random);
        sample.b = close(sample.joint, sample.a, free);
        sample.turn_before =
            free.turn - (sample.a.Lambda * sample.joint.a.axes.col(0)).dot(sample.b.theta - sample.a.theta);
        sample.motors.turn.value = free.turn;
        sample.motors.slide.value = sample.joint.kind == JointKind::screw
                                        ? sample.joint.lead * free.turn / (2.0 * std::numbers::pi)
                                        : free.slide;
        check(sample, JointRows(sample.joint));
    }
}

int count_freedoms(const Joint& joint) {
    switch (joint.kind) {
        case JointKind::generic:
            return static_cast<int>(std::count(joint.held.begin(), joint.held.end(), false));
        case JointKind::weld:
            return 0;
        case JointKind::hinge:
        case JointKind::slider:
        case JointKind::screw:
            return 1;
        case JointKind::cylinder:
        case JointKind::universal:
            return 2;
        case JointKind::ball:
        case JointKind::plane:
            return 3;
        case JointKind::free:
            return 6;
        default:
            return 5;
    }
}

// The joint with its sides exchanged; of a universal joint each side then carries the other axis.
Joint exchange_sides(const Joint& joint) {
    Joint exchanged = joint;
    std::swap(exchanged.a, exchanged.b);
    return exchanged;
}

// The projector on the forces that a joint can exert.
PairMatrix project_on_rows(const JointMatrix& gradient) {
    const Eigen::MatrixXd G = gradient;
    return G.transpose() * solve_dense(G * G.transpose(), G);
}

}  // namespace

TEST_CASE("gradients of joints are derivatives of their equations", "[constraints][joints]") {
    for_each_joint([](const JointSample& sample, const JointRows& rows) {
        const auto expected =
            differentiate_pair<JointMatrix>(sample, move_only(), [&](const JointMotions& motions) {
                return rows.compute_values(motions, sample.turn_before, sample.motors, Level::position);
            });
        CHECK(relative_difference(rows.compute_gradient(sample.motions()), expected) < tolerance);
    });
}

TEST_CASE("equations of joints at each level are derivatives by time of those before",
          "[constraints][joints]") {
    for_each_joint([](const JointSample& sample, const JointRows& rows) {
        RandomValues random(603);
        const auto make_path = [&](const NodeMotion& start, const Anchor& anchor) {
            if (anchor.is_ground())
                return SmoothMotion{start, Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
            return SmoothMotion{
                start, random.vector(), random.vector(2.0), random.vector(2.0), random.vector()};
        };
        const SmoothMotion a = make_path(sample.a, sample.joint.a.anchor);
        const SmoothMotion b = make_path(sample.b, sample.joint.b.anchor);
        const auto move_motor = [](const PrescribedCoordinate& f, double t) -> PrescribedCoordinate {
            return {f.value + t * f.rate + 0.5 * t * t * f.acceleration,
                    f.rate + t * f.acceleration,
                    f.acceleration};
        };
        const auto values = [&](double t, Level level) {
            const NodeMotion now_a = a.at(t), now_b = b.at(t);
            const JointMotors motors{move_motor(sample.motors.turn, t), move_motor(sample.motors.slide, t)};
            return rows.compute_values({now_a, now_b}, sample.turn_before, motors, level);
        };
        const JointVector rates = differentiate([&](double t) { return values(t, Level::position); });
        CHECK(relative_difference(values(0.0, Level::velocity), rates) < tolerance);
        const JointVector accelerations = differentiate([&](double t) { return values(t, Level::velocity); });
        CHECK(relative_difference(values(0.0, Level::acceleration), accelerations) < tolerance);
    });
}

TEST_CASE("accelerations of joints follow the unknowns", "[constraints][joints]") {
    for_each_joint([](const JointSample& sample, const JointRows& rows) {
        for (const auto& [what, linearization] : make_linearizations()) {
            INFO(what);
            const auto expected =
                differentiate_pair<JointMatrix>(sample, linearization, [&](const JointMotions& motions) {
                    return rows.compute_values(
                        motions, sample.turn_before, sample.motors, Level::acceleration);
                });
            const JointMatrix derivative =
                rows.compute_acceleration_derivative(sample.motions(), {linearization, linearization});
            CHECK(relative_difference(derivative, expected) < tolerance);
        }
    });
}

TEST_CASE("each node's unknowns have a linearization of their own", "[constraints][joints]") {
    const auto some = make_linearizations(11).back().second;
    auto other = make_linearizations(12).back().second;
    other.placement = 0.0;
    other.rate = -0.6;
    other.acceleration = 0.9;
    for_each_joint([&](const JointSample& sample, const JointRows& rows) {
        const JointMatrix both = rows.compute_acceleration_derivative(sample.motions(), {some, other});
        const JointMatrix of_a = rows.compute_acceleration_derivative(sample.motions(), {some, some});
        const JointMatrix of_b = rows.compute_acceleration_derivative(sample.motions(), {other, other});
        CHECK(both.leftCols<6>() == of_a.leftCols<6>());
        CHECK(both.rightCols<6>() == of_b.rightCols<6>());
    });
}

TEST_CASE("derivatives of forces of joints are those of the gradients", "[constraints][joints]") {
    for_each_joint([](const JointSample& sample, const JointRows& rows) {
        RandomValues random(604);
        const JointVector multipliers = make_multipliers(rows.count(), random);
        const auto expected =
            differentiate_pair<PairMatrix>(sample, move_only(), [&](const JointMotions& motions) {
                const Eigen::Matrix<double, 12, 1> force =
                    rows.compute_gradient(motions).transpose() * multipliers;
                return force;
            });
        const PairMatrix derivative = rows.compute_force_derivative(sample.motions(), multipliers);
        CHECK((derivative - expected).norm() < tolerance * (1.0 + expected.norm()));
    });
}

TEST_CASE("forces of a closed joint on A and B balance", "[constraints][joints]") {
    for_each_closed_joint([](const JointSample& sample, const JointRows& rows) {
        const JointMatrix gradient = rows.compute_gradient(sample.motions());
        for (int i = 0; i < rows.count(); ++i) {
            const PairRow row = gradient.row(i);
            const Vec3 force_a = row.segment<3>(0), moment_a = row.segment<3>(3);
            const Vec3 force_b = row.segment<3>(6), moment_b = row.segment<3>(9);
            CHECK((force_a + force_b).norm() < 1e-14);
            CHECK((sample.a.r.cross(force_a) + moment_a + sample.b.r.cross(force_b) + moment_b).norm() <
                  1e-14);
        }
    });
}

TEST_CASE("joints do the work of their motors alone", "[constraints][joints]") {
    for_each_joint([](const JointSample& sample, const JointRows& rows) {
        RandomValues random(605);
        const JointVector multipliers = make_multipliers(rows.count(), random);
        NodeMotion a = sample.a, b = sample.b;
        a.v.setZero(), a.omega.setZero(), b.v.setZero(), b.omega.setZero();
        const JointVector by_time =
            rows.compute_values({a, b}, sample.turn_before, sample.motors, Level::velocity);
        const JointVector rates =
            rows.compute_values(sample.motions(), sample.turn_before, sample.motors, Level::velocity);
        Eigen::Matrix<double, 12, 1> velocities;
        velocities << sample.a.v, sample.a.omega, sample.b.v, sample.b.omega;
        const PairRow force = multipliers.transpose() * rows.compute_gradient(sample.motions());
        CHECK(force.dot(velocities) == Approx(multipliers.dot(rates - by_time)).epsilon(1e-12));
        const bool has_motor = sample.name.find("turned") != std::string::npos ||
                               sample.name.find("pushed") != std::string::npos;
        CHECK((by_time.norm() > 0.0) == has_motor);
    });
}

TEST_CASE("a rigid motion of both sides leaves the equations of joints", "[constraints][joints]") {
    for_each_joint([](const JointSample& sample, const JointRows& rows) {
        RandomValues random(606);
        const Quat R = random.rotation();
        const Vec3 d = random.vector();
        // Both sides as nodes, for the ground stays.
        const NodeMotion a = move_rigidly(sample.a, R, d), b = move_rigidly(sample.b, R, d);
        const auto& held = sample.joint.held;
        const bool has_points =
            sample.joint.kind == JointKind::ball || sample.joint.kind == JointKind::hinge ||
            sample.joint.kind == JointKind::universal || sample.joint.kind == JointKind::weld ||
            (sample.joint.kind == JointKind::generic && held[0] && held[1] && held[2]);
        for (const Level level : {Level::position, Level::velocity, Level::acceleration}) {
            JointVector expected =
                rows.compute_values(sample.motions(), sample.turn_before, sample.motors, level);
            // The components of a point's equations are global ones.
            if (has_points) expected.head<3>() = (R * Vec3(expected.head<3>())).eval();
            const JointVector values = rows.compute_values({a, b}, sample.turn_before, sample.motors, level);
            CHECK(relative_difference(values, expected) < 1e-13);
        }
    });
}

TEST_CASE("what a joint leaves free closes it", "[constraints][joints]") {
    for_each_closed_joint([](const JointSample& sample, const JointRows& rows) {
        const JointGap gap = rows.compute_gap(sample.motions(), sample.turn_before, sample.motors);
        CHECK(gap.length < 1e-14);
        CHECK(gap.angle < 1e-14);
    });
}

TEST_CASE("joints leave as many freedoms as their kinds should", "[constraints][joints]") {
    for_each_closed_joint([](const JointSample& sample, const JointRows& rows) {
        const Eigen::MatrixXd gradient = rows.compute_gradient(sample.motions());
        const Eigen::VectorXd values = find_singular_values(gradient).values;
        CHECK(values.minCoeff() > 1e-2 * values.maxCoeff());
        const int motors = bool(sample.joint.turn.motion) + bool(sample.joint.slide.motion);
        CHECK(rows.count() == 6 - count_freedoms(sample.joint) + motors);
    });
}

TEST_CASE("sides of a closed joint can be exchanged", "[constraints][joints]") {
    for_each_closed_joint([](const JointSample& sample, const JointRows& rows) {
        const Joint exchanged = exchange_sides(sample.joint);
        const JointRows other(exchanged);
        // A universal joint's motor would turn the other axis.
        if (sample.joint.kind == JointKind::universal && sample.joint.turn.motion) return;
        // A carries its axes, or its curve.
        if (sample.joint.kind == JointKind::generic || sample.joint.kind == JointKind::cam) return;
        const PairMatrix forces = project_on_rows(rows.compute_gradient(sample.motions()));
        const PairMatrix back = project_on_rows(other.compute_gradient({sample.b, sample.a}));
        PairMatrix expected;
        expected << back.bottomRightCorner<6, 6>(), back.bottomLeftCorner<6, 6>(),
            back.topRightCorner<6, 6>(), back.topLeftCorner<6, 6>();
        CHECK(relative_difference(forces, expected) < 1e-12);
    });
}

TEST_CASE("coordinates change their signs with the sides of a joint", "[constraints][joints]") {
    for_each_closed_joint([](const JointSample& sample, const JointRows& rows) {
        const JointCoordinates other(exchange_sides(sample.joint));
        const JointMotions back{sample.b, sample.a};
        if (other.turn && sample.joint.kind != JointKind::universal) {
            CHECK(other.turn->compute_jet(back, -sample.turn_before).value ==
                  Approx(-sample.motors.turn.value).margin(1e-13));
        }
        if (other.slide) {
            CHECK(other.slide->compute_jet(back).value ==
                  Approx(-rows.coordinates().slide->compute_jet(sample.motions()).value).margin(1e-13));
        }
    });
}

TEST_CASE("the turn of a free joint is the twist about its axis", "[constraints][joints]") {
    RandomValues random(617);
    for (int i = 0; i < 20; ++i) {
        Joint joint = make_joint(JointKind::free, random);
        NodeMotion a, b;
        a.Lambda = exp_quaternion(random.vector(2.0));
        b.Lambda = a.Lambda * exp_quaternion(random.vector(1.5));
        const Quat relative = a.Lambda.conjugate() * b.Lambda;
        const Vec3 axis = joint.a.axes.col(0);
        const double twist = 2.0 * std::atan2(relative.vec().dot(axis), relative.w());
        CHECK(JointTurn(joint).compute_jet({a, b}, twist).value == Approx(twist).margin(1e-13));
        // For all directions across.
        const Mat3 turned = Eigen::AngleAxisd(random.number(-3.0, 3.0), axis).toRotationMatrix();
        joint.a.axes = turned * joint.a.axes;
        joint.b.axes = turned * joint.b.axes;
        CHECK(JointTurn(joint).compute_jet({a, b}, twist).value == Approx(twist).margin(1e-13));
        // As seen from the other side.
        CHECK(JointTurn(exchange_sides(joint)).compute_jet({b, a}, -twist).value ==
              Approx(-twist).margin(1e-13));
    }
}

TEST_CASE("turns are counted, whatever both sides do", "[constraints][joints]") {
    // 7.3 turns, forth and back, in steps of up to 0.9 of a half turn of each side, or of slow ones.
    RandomValues random(607);
    for (const JointKind kind : {JointKind::hinge, JointKind::cylinder, JointKind::screw, JointKind::plane}) {
        const Joint joint = make_joint(kind, random);
        const JointTurn turn(joint);
        const Vec3 axis = joint.a.axes.col(0);
        for (const double step : {0.02, 0.45, 0.9, -0.9}) {
            NodeMotion a, b;
            double counted = 0.0, expected = 0.0;
            for (int i = 0; i < 25; ++i) {
                const double back = i < 12 ? step : -1.4 * step;
                a.theta = -back * std::numbers::pi / 1.4 * axis;
                b.theta = 0.8 * back * std::numbers::pi / 1.4 * axis;
                a.Lambda = exp_quaternion(a.theta) * a.Lambda;
                b.Lambda = exp_quaternion(b.theta) * b.Lambda;
                expected += 1.8 * back * std::numbers::pi / 1.4;
                const JointMotions motions{a, b};
                CHECK(turn.compute_branch_distance(motions, counted) < 1e-12);
                counted = turn.compute_jet(motions, counted).value;
                CHECK(counted == Approx(expected).margin(1e-12));
            }
        }
    }
}

TEST_CASE("turns are counted while the axis turns too", "[constraints][joints]") {
    RandomValues random(608);
    for (const JointKind kind : {JointKind::hinge, JointKind::universal, JointKind::screw}) {
        const Joint joint = make_joint(kind, random);
        const JointTurn turn(joint);
        FreeCoordinates free;
        NodeMotion a, b = close(joint, a, free);
        double counted = 0.0;
        while (free.turn < 7.3 * 2.0 * std::numbers::pi) {
            free.turn += 0.6;
            free.second_turn = 0.9 * std::sin(free.turn);
            const Quat before_b = b.Lambda;
            a.theta = random.vector(0.5);
            a.Lambda = exp_quaternion(a.theta) * a.Lambda;
            b = close(joint, a, free);
            b.theta = log(Quat(b.Lambda * before_b.conjugate()));
            counted = turn.compute_jet({a, b}, counted).value;
            CHECK(counted == Approx(free.turn).epsilon(1e-13));
        }
    }
}

TEST_CASE("joints between nodes alone are linear", "[constraints][joints]") {
    RandomValues random(609);
    Joint joint = make_joint(JointKind::ball, random);
    CHECK(!JointRows(joint).is_linear());
    joint.a.anchor.arm.setZero();
    CHECK(!JointRows(joint).is_linear());
    joint.b.anchor.node = -1;
    CHECK(JointRows(joint).is_linear());
    joint.b.anchor = {1, Vec3::Zero()};
    CHECK(JointRows(joint).is_linear());
    joint.kind = JointKind::weld;
    CHECK(JointRows(joint).is_linear());
    joint.kind = JointKind::hinge;
    CHECK(!JointRows(joint).is_linear());
}

TEST_CASE("rows of joints are lengths or turns", "[constraints][joints]") {
    // In other units of length, lengths and what motors prescribe of them grow, turns do not.
    constexpr double scale = 1000.0;
    for_each_joint([&](const JointSample& sample, const JointRows& rows) {
        JointSample scaled = sample;
        for (Vec3* length :
             {&scaled.a.r, &scaled.b.r, &scaled.joint.a.anchor.arm, &scaled.joint.b.anchor.arm})
            *length *= scale;
        scaled.joint.lead *= scale;
        scaled.joint.length *= scale;
        if (scaled.joint.cam) scaled.joint.cam = make_cam(scale);
        scaled.motors.slide.value *= scale;
        const JointRows others(scaled.joint);
        const JointVector values =
            rows.compute_values(sample.motions(), sample.turn_before, sample.motors, Level::position);
        const JointVector others_values =
            others.compute_values(scaled.motions(), sample.turn_before, scaled.motors, Level::position);
        for (int i = 0; i < rows.count(); ++i) {
            CHECK(others.is_length(i) == rows.is_length(i));
            CHECK(others_values[i] == Approx((rows.is_length(i) ? scale : 1.0) * values[i]));
        }
    });
}

TEST_CASE("multipliers of joints are the forces that they should be", "[constraints][joints]") {
    // Of a point, what A exerts on B; of a motor, the moment on B about the axis; of a distance, the push.
    RandomValues random(610);
    const auto compute_on_b = [](const Joint& joint, const NodeMotion& a, const NodeMotion& b, int row) {
        const JointMatrix gradient = JointRows(joint).compute_gradient({a, b});
        return Vec6(gradient.row(row).rightCols<6>().transpose());
    };
    const NodeMotion a{.r = random.vector(), .Lambda = random.rotation()};
    const FreeCoordinates free = make_free_coordinates(random);
    Joint joint = make_joint(JointKind::hinge, random);
    joint.turn.motion = TimeFunction(1.0);
    NodeMotion b = close(joint, a, free);
    for (int i = 0; i < 3; ++i) {
        const Vec6 force = compute_on_b(joint, a, b, i);
        CHECK(Vec3(force.head<3>()) == Vec3(Vec3::Unit(i)));
        CHECK((Vec3(force.tail<3>()) - (b.Lambda * joint.b.anchor.arm).cross(Vec3(Vec3::Unit(i)))).norm() <
              1e-15);
    }
    const Vec6 moment = compute_on_b(joint, a, b, 5);
    CHECK(moment.head<3>().norm() < 1e-15);
    CHECK((Vec3(moment.tail<3>()) - a.Lambda * Vec3(joint.a.axes.col(0))).norm() < 1e-14);

    joint = make_joint(JointKind::distance, random);
    joint.b.anchor.arm.setZero();
    b = close(joint, a, free);
    const Vec3 push = compute_on_b(joint, a, b, 0).head<3>();
    CHECK((push - (b.r - a.r - a.Lambda * joint.a.anchor.arm) / joint.length).norm() < 1e-14);

    // Of a cam, the push of the curve on the roller, across both.
    joint = make_joint(JointKind::cam, random);
    joint.b.anchor.arm.setZero();
    b = close(joint, a, free);
    const PlaneCurve::Point t = joint.cam->curve->find_place(free.turn).tangent;
    const Vec3 normal = a.Lambda * joint.a.axes * Vec3(0.0, t.y(), -t.x());
    CHECK((Vec3(compute_on_b(joint, a, b, 0).head<3>()) - normal).norm() < 1e-13);
}
