#include "watch/history_watch.hpp"

#include "elements/tie_values.hpp"
#include "results/sample.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"

using namespace gxrod;
using sample::Motion;

namespace {

constexpr std::size_t middle = 0, root = 1, tip = 2, gyro = 3;  // in sample::make_output()

HistoryWatch make_point(const Model& model, std::size_t request) {
    return {model, sample::make_output().histories, request};
}

Vec3 vector_of(HistoryWatch point, const char* quantity, const Motion& motion) {
    const HistoryRow row = point.compute(quantity, motion.snapshot());
    return {row[0], row[1], row[2]};
}

// The point of a request of the sample, relative to the tip of the beam, a body's axes or a section's.
HistoryWatch make_relative_point(const Model& model, std::size_t request, const Quat& axes) {
    std::vector<HistoryRequest> requests = sample::make_output().histories;
    HistoryRequest& relative = requests[request];
    relative.relative_to = "tip";
    relative.relative_node = 2;
    relative.relative_axes = axes;
    return {model, requests, request};
}

// The rotation matrix of a recorded quaternion, w x y z.
Mat3 matrix_of(HistoryWatch point, const char* quantity, const Motion& motion) {
    const HistoryRow row = point.compute(quantity, motion.snapshot());
    return Quat(row[0], row[1], row[2], row[3]).toRotationMatrix();
}

}  // namespace

TEST_CASE("Position, displacement and rates of a point are those of its node", "[watch]") {
    const Model model = sample::make_model();
    const Motion motion(0.7);
    const HistoryWatch point = make_point(model, gyro);
    const NodeMotion& node = motion.nodes[3];
    CHECK(vector_of(point, "position", motion) == node.r);
    CHECK((vector_of(point, "displacement", motion) - 0.7 * Vec3(4, 8, 12)).norm() < 1e-14);
    CHECK(vector_of(point, "velocity", motion) == node.v);
    CHECK(vector_of(point, "acceleration", motion) == node.a);
    CHECK(vector_of(point, "angular_velocity", motion) == node.omega);
}

TEST_CASE("The rotation of a rod's point is that since the reference configuration", "[watch]") {
    const Model model = sample::make_model();
    const Motion motion(0.7);
    const HistoryWatch point = make_point(model, middle);
    const Vec3 phi = 0.7 * Vec3(0.3, 0.4, -0.4);
    const Mat3 section = exp_matrix(phi) * exp_matrix({0.2, 0.2, 0.3});
    CHECK((vector_of(point, "rotation_vector", motion) - phi).norm() < 1e-15);
    CHECK((matrix_of(point, "quaternion", motion) - exp_matrix(phi)).norm() < 1e-14);
    CHECK((matrix_of(point, "orientation", motion) - section).norm() < 1e-14);
    CHECK(
        (vector_of(point, "angular_velocity_material", motion) - section.transpose() * motion.nodes[1].omega)
            .norm() < 1e-14);
}

TEST_CASE("The rotation of a body is its attitude, on a rod's node too", "[watch]") {
    const Model model = sample::make_model();
    const Motion motion(0.7);
    const HistoryWatch point = make_point(model, tip);
    const Mat3 attitude = exp_matrix(0.7 * Vec3(0.3, 0.6, -0.4)) * exp_matrix({0.0, 0.0, 1.5});
    CHECK((exp_matrix(vector_of(point, "rotation_vector", motion)) - attitude).norm() < 1e-14);
    CHECK((matrix_of(point, "quaternion", motion) - attitude).norm() < 1e-14);
    CHECK((matrix_of(point, "orientation", motion) - attitude).norm() < 1e-14);
    CHECK(
        (vector_of(point, "angular_velocity_material", motion) - attitude.transpose() * motion.nodes[2].omega)
            .norm() < 1e-14);
}

TEST_CASE("The centre of mass turns with its body", "[watch]") {
    const Model model = sample::make_model();
    const Motion motion(0.7);
    const Mat3 attitude = exp_matrix(0.7 * Vec3(0.3, 0.8, -0.4)) * exp_matrix({0.0, 1.0, 0.0});
    const Vec3 expected = motion.nodes[3].r + attitude * Vec3(0.0, 0.1, 0.4);
    CHECK((vector_of(make_point(model, gyro), "centre_of_mass", motion) - expected).norm() < 1e-14);
}

TEST_CASE("Section values are those of the point", "[watch]") {
    const Model model = sample::make_model();
    const Motion motion(0.7);
    for (const std::size_t request : {middle, root}) {
        const PointValues& values = motion.points[request];
        const HistoryWatch point = make_point(model, request);
        CHECK(vector_of(point, "force", motion) == values.force);
        CHECK(vector_of(point, "moment", motion) == values.moment);
        CHECK(vector_of(point, "strain", motion) == values.strain);
        CHECK(vector_of(point, "curvature", motion) == values.curvature);
        const Mat3 axes = matrix_of(point, "orientation", motion);
        CHECK((vector_of(point, "force_spatial", motion) - axes * values.force).norm() < 1e-12);
        CHECK((vector_of(point, "moment_spatial", motion) - axes * values.moment).norm() < 1e-12);
    }
}

TEST_CASE("A point between nodes moves by itself", "[watch]") {
    const Model model = sample::make_model();
    const Motion motion(0.7);
    std::vector<HistoryRequest> requests = sample::make_output().histories;
    std::get<WatchedPoint>(requests[root].target).node = -1;
    const HistoryWatch point(model, requests, root);
    const PointValues& values = motion.points[1];
    CHECK(vector_of(point, "position", motion) == values.motion.r);
    CHECK(vector_of(point, "displacement", motion) == values.motion.r - values.start);
    CHECK(vector_of(point, "velocity", motion) == values.motion.v);
    CHECK(vector_of(point, "acceleration", motion) == values.motion.a);
    CHECK(vector_of(point, "angular_velocity", motion) == values.motion.omega);
    const Mat3 axes = (values.motion.Lambda * values.triad).toRotationMatrix();
    CHECK((matrix_of(point, "quaternion", motion) - values.motion.Lambda.toRotationMatrix()).norm() < 1e-14);
    CHECK((matrix_of(point, "orientation", motion) - axes).norm() < 1e-14);
    // Relative to the point itself as a node would be.
    requests[root].relative_node = 2;
    requests[root].relative_axes = exp_quaternion({0.1, 0.2, 0.3});
    const Quat to_axes = (motion.nodes[2].Lambda * requests[root].relative_axes).conjugate();
    const HistoryWatch relative(model, requests, root);
    CHECK((vector_of(relative, "position", motion) - to_axes * (values.motion.r - motion.nodes[2].r)).norm() <
          1e-12);
    const Vec3 start = requests[root].relative_axes.conjugate() * (values.start - model.nodes[2].position);
    CHECK((vector_of(relative, "displacement", motion) - vector_of(relative, "position", motion) + start)
              .norm() < 1e-12);
}

TEST_CASE("Reactions are those of the point's node", "[watch]") {
    const Model model = sample::make_model();
    const Motion motion(0.7);
    CHECK(vector_of(make_point(model, root), "reaction_force", motion) == Vec3(1.7, 2, 3));
    CHECK(vector_of(make_point(model, root), "reaction_moment", motion) == Vec3(4, 5, 6));
    CHECK(vector_of(make_point(model, middle), "reaction_force", motion) == Vec3::Zero());
}

TEST_CASE("The moment of a reaction can be about any point", "[watch]") {
    const Model model = sample::make_model();
    const Motion motion(0.7);
    std::vector<HistoryRequest> requests = sample::make_output().histories;
    requests[root].about = Vec3(0.5, -2.0, 3.0);
    const HistoryWatch point(model, requests, root);
    const Vec3 arm =
        motion.nodes[static_cast<std::size_t>(node_of(requests[root].target))].r - Vec3(0.5, -2.0, 3.0);
    const Vec3 expected = Vec3(4, 5, 6) + arm.cross(Vec3(1.7, 2, 3));
    CHECK((vector_of(point, "reaction_moment", motion) - expected).norm() < 1e-14);
    CHECK(vector_of(point, "reaction_force", motion) == Vec3(1.7, 2, 3));
}

TEST_CASE("Quaternions do not change sign from step to step, rotation vectors stay within pi", "[watch]") {
    const Model model = sample::make_model();
    HistoryWatch point = make_point(model, middle);
    Motion motion(0.0);
    HistoryRow last{1.0, 0.0, 0.0, 0.0};
    for (int step = 1; step <= 300; ++step) {
        const Quat turned = exp_quaternion({0.0, 0.0, 0.1 * step});
        motion.nodes[1].Lambda = step % 3 == 0 ? Quat(-turned.coeffs()) : turned;
        const HistoryRow row = point.compute("quaternion", motion.snapshot());
        double distance = 0.0;
        for (std::size_t i = 0; i < 4; ++i) distance += std::pow(row[i] - last[i], 2);
        CHECK(std::sqrt(distance) < 0.06);
        CHECK(vector_of(point, "rotation_vector", motion).norm() <= M_PI);
        last = row;
    }
}

TEST_CASE("Relative quantities are what an observer on the reference point sees", "[watch]") {
    const Model model = sample::make_model();
    const Quat axes = model.bodies[0].attitude;
    const Motion motion(0.7);
    const NodeMotion& node = motion.nodes[3];
    const NodeMotion& reference = motion.nodes[2];
    const HistoryWatch point = make_relative_point(model, gyro, axes);
    const Mat3 A = exp_matrix(0.7 * Vec3(0.3, 0.6, -0.4)) * exp_matrix({0.0, 0.0, 1.5});
    const Vec3 place = A.transpose() * (node.r - reference.r);
    const Vec3 start = exp_matrix({0.0, 0.0, 1.5}).transpose() * Vec3(1.0, 0.5, 2.0);
    CHECK((vector_of(point, "position", motion) - place).norm() < 1e-14);
    CHECK((vector_of(point, "displacement", motion) - (place - start)).norm() < 1e-14);
    CHECK((vector_of(point, "angular_velocity", motion) - A.transpose() * (node.omega - reference.omega))
              .norm() < 1e-14);
    const Mat3 attitude = exp_matrix(0.7 * Vec3(0.3, 0.8, -0.4)) * exp_matrix({0.0, 1.0, 0.0});
    CHECK((matrix_of(point, "orientation", motion) - A.transpose() * attitude).norm() < 1e-14);
    CHECK((matrix_of(point, "quaternion", motion) - A.transpose() * attitude).norm() < 1e-14);
    CHECK((exp_matrix(vector_of(point, "rotation_vector", motion)) - A.transpose() * attitude).norm() <
          1e-14);
    CHECK((vector_of(point, "centre_of_mass", motion) -
           (place + A.transpose() * attitude * Vec3(0.0, 0.1, 0.4)))
              .norm() < 1e-14);
}

TEST_CASE("The relative rotation of a rod's point is that since t = 0, in the axes of the reference",
          "[watch]") {
    const Model model = sample::make_model();
    const Quat axes = exp_quaternion({0.3, 0.2, 0.3});
    const Mat3 A0 = axes.toRotationMatrix();
    const Motion motion(0.7);
    const HistoryWatch point = make_relative_point(model, middle, axes);
    const Mat3 A = exp_matrix(0.7 * Vec3(0.3, 0.6, -0.4)) * A0;
    const Mat3 B0 = exp_matrix({0.2, 0.2, 0.3});
    const Mat3 B = exp_matrix(0.7 * Vec3(0.3, 0.4, -0.4)) * B0;
    CHECK((matrix_of(point, "orientation", motion) - A.transpose() * B).norm() < 1e-14);
    const Mat3 since_start = A.transpose() * B * (A0.transpose() * B0).transpose();
    CHECK((matrix_of(point, "quaternion", motion) - since_start).norm() < 1e-14);
    const Motion start(0.0);
    CHECK((matrix_of(point, "quaternion", start) - Mat3::Identity()).norm() < 1e-15);
    CHECK(vector_of(point, "displacement", start).norm() < 1e-15);
}

namespace {

// A point on a turntable: both nodes follow motions whose rates are known in closed form.
Motion make_turning_motion(double t) {
    Motion motion(t);
    const auto follow = [t](NodeMotion& node, double radius, double turn, double rise) {
        const double angle = turn * t * t;
        node.r = Vec3(radius * std::cos(angle), radius * std::sin(angle), rise * t * t * t);
        const Vec3 along(-std::sin(angle), std::cos(angle), 0.0);
        const Vec3 outward(std::cos(angle), std::sin(angle), 0.0);
        const double rate = 2.0 * turn * t;
        node.v = radius * rate * along + Vec3(0.0, 0.0, 3.0 * rise * t * t);
        node.a =
            radius * 2.0 * turn * along - radius * rate * rate * outward + Vec3(0.0, 0.0, 6.0 * rise * t);
        node.Lambda = exp_quaternion({0.0, 0.0, angle}) * exp_quaternion({std::sin(t), 0.0, 0.0});
        // Of a product of turns: the first about a fixed axis, the second carried by it.
        node.omega = Vec3(0.0, 0.0, rate) + std::cos(t) * outward;
        node.alpha = Vec3(0.0, 0.0, 2.0 * turn) - std::sin(t) * outward + std::cos(t) * rate * along;
    };
    follow(motion.nodes[2], 2.0, 0.9, 0.4);
    follow(motion.nodes[3], 5.0, -0.3, 0.7);
    return motion;
}

}  // namespace

TEST_CASE("Relative velocity and acceleration are the rates of the relative position", "[watch]") {
    const Model model = sample::make_model();
    const HistoryWatch point = make_relative_point(model, gyro, exp_quaternion({0.4, -0.2, 0.9}));
    const double t = 0.8;
    const double h = 1e-3;
    const auto at = [&](const char* quantity, double time) {
        return vector_of(point, quantity, make_turning_motion(time));
    };
    // Fourth-order central differences.
    const auto rate = [&](const char* quantity) {
        return Vec3((8.0 * (at(quantity, t + h) - at(quantity, t - h)) -
                     (at(quantity, t + 2.0 * h) - at(quantity, t - 2.0 * h))) /
                    (12.0 * h));
    };
    const Vec3 velocity = at("velocity", t);
    const Vec3 acceleration = at("acceleration", t);
    CHECK(velocity.norm() > 1.0);
    CHECK(acceleration.norm() > 1.0);
    CHECK((rate("position") - velocity).norm() < 1e-9 * velocity.norm());
    CHECK((rate("displacement") - velocity).norm() < 1e-9 * velocity.norm());
    CHECK((rate("velocity") - acceleration).norm() < 1e-9 * acceleration.norm());
}

TEST_CASE("Relative to a point at rest with the global axes, vectors are differences", "[watch]") {
    const Model model = sample::make_model();
    const HistoryWatch point = make_relative_point(model, gyro, Quat::Identity());
    Motion motion(0.7);
    motion.nodes[2] = NodeMotion{};
    motion.nodes[2].r = Vec3(1, 2, 3);
    const NodeMotion& node = motion.nodes[3];
    CHECK(vector_of(point, "position", motion) == node.r - Vec3(1, 2, 3));
    CHECK(vector_of(point, "velocity", motion) == node.v);
    CHECK(vector_of(point, "acceleration", motion) == node.a);
    CHECK(vector_of(point, "angular_velocity", motion) == node.omega);
}

TEST_CASE("An end of a rod that comes back to its node has its own axes", "[watch]") {
    Model model = sample::make_model();
    // The beam's end becomes its start: two elements, back and forth.
    Rod& beam = model.rods[0];
    beam.nodes = {0, 1};
    beam.element_nodes = {0, 1, 1, 0};
    const Motion motion(0.7);
    std::vector<HistoryRequest> requests = sample::make_output().histories;
    std::get<WatchedPoint>(requests[root].target).place = {0, 1, 1.0};
    const Mat3 end_axes = motion.nodes[0].Lambda.toRotationMatrix() * exp_matrix({0.3, 0.2, 0.3});
    CHECK((matrix_of(HistoryWatch(model, requests, root), "orientation", motion) - end_axes).norm() < 1e-14);
    std::get<WatchedPoint>(requests[root].target).place = {0, 0, -1.0};
    const Mat3 start_axes =
        motion.nodes[0].Lambda.toRotationMatrix() * model.rods[0].triads[0].toRotationMatrix();
    CHECK((matrix_of(HistoryWatch(model, requests, root), "orientation", motion) - start_axes).norm() <
          1e-14);
}

TEST_CASE("A spring's history is its elongation and its tension", "[watch]") {
    // From the origin to an arm of node 3, which moves and turns.
    Model model = sample::make_model();
    const Motion motion(0.7);
    Spring spring;
    spring.ends = {Anchor{}, Anchor{3, Vec3(0.3, 0.2, -0.1)}};
    spring.stiffness = 7.0;
    spring.damping = 2.0;
    spring.length = 1.5;
    model.springs.push_back(spring);
    HistoryRequest request;
    request.target = WatchedTie{TieKind::spring, 0};
    HistoryWatch point(model, {request}, 0);
    const NodeMotion& node = motion.nodes[3];
    const Vec3 u = node.Lambda * spring.ends[1].arm;
    const Vec3 d = node.r + u;
    const double rate = d.normalized().dot(node.v + node.omega.cross(u));
    const TieValues ties = compute_tie_values(model, motion.nodes);
    Snapshot snapshot = motion.snapshot();
    snapshot.ties = &ties;
    CHECK(point.compute("elongation", snapshot)[0] == Approx(d.norm() - 1.5).epsilon(1e-14));
    CHECK(point.compute("axial_force", snapshot)[0] ==
          Approx(7.0 * (d.norm() - 1.5) + 2.0 * rate).epsilon(1e-14));
}

TEST_CASE("A joint's history is what the snapshot has of it", "[watch][joint]") {
    Model model = sample::make_model();
    model.joints.resize(2);
    HistoryRequest request;
    request.target = WatchedTie{TieKind::joint, 1};
    HistoryWatch point(model, {request}, 0);
    const Motion motion(0.7);
    const JointValues values{.turn = 1,
                             .turn_rate = 2,
                             .slide = 3,
                             .slide_rate = 4,
                             .force = {5, 6, 7},
                             .moment = {8, 9, 10},
                             .force_in_joint = {11, 12, 13},
                             .moment_in_joint = {14, 15, 16},
                             .drive_turn = 17,
                             .drive_slide = 0,
                             .friction = 18,
                             .gap = 19};
    const std::vector<JointValues> joints{JointValues{}, values};
    Snapshot snapshot = motion.snapshot();
    snapshot.joints = joints;
    const auto row = [&](const char* quantity) { return point.compute(quantity, snapshot); };
    CHECK(row("angle")[0] == 1);
    CHECK(row("angle_rate")[0] == 2);
    CHECK(row("slide")[0] == 3);
    CHECK(row("slide_rate")[0] == 4);
    CHECK(row("force") == HistoryRow{5, 6, 7, 0});
    CHECK(row("moment") == HistoryRow{8, 9, 10, 0});
    CHECK(row("force_a") == HistoryRow{11, 12, 13, 0});
    CHECK(row("moment_a") == HistoryRow{14, 15, 16, 0});
    CHECK(row("drive")[0] == 17);
    CHECK(row("friction")[0] == 18);
    CHECK(row("gap")[0] == 19);
}

TEST_CASE("Motors and frictions of slides have forces, those of turns moments", "[watch][joint]") {
    Model model = sample::make_model();
    model.joints.resize(3);
    for (Joint& joint : model.joints) joint.kind = JointKind::cylinder;
    model.joints[0].slide.motion = TimeFunction(2.0);
    model.joints[1].slide.friction.force = 3.0;
    model.joints[2].turn.motion = TimeFunction(2.0);
    model.joints[2].turn.friction.force = 3.0;
    const auto is_force = [&](int joint, const char* quantity) {
        const Watched target = WatchedTie{TieKind::joint, joint};
        return dimension_of(quantity_of(target, quantity), target, model) == std::string("force");
    };
    CHECK(is_force(0, "drive"));
    CHECK_FALSE(is_force(0, "friction"));
    CHECK_FALSE(is_force(0, "moment"));
    CHECK(is_force(1, "friction"));
    CHECK_FALSE(is_force(1, "drive"));
    CHECK_FALSE(is_force(2, "drive"));
    CHECK_FALSE(is_force(2, "friction"));
}
