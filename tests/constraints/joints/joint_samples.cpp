#include "constraints/joints/joint_samples.hpp"

#include <numbers>

#include "state/increment.hpp"

namespace gxrod::tools {

namespace {

constexpr std::pair<JointKind, const char*> kinds[] = {{JointKind::ball, "ball"},
                                                       {JointKind::hinge, "hinge"},
                                                       {JointKind::cylinder, "cylinder"},
                                                       {JointKind::slider, "slider"},
                                                       {JointKind::universal, "universal"},
                                                       {JointKind::screw, "screw"},
                                                       {JointKind::plane, "plane"},
                                                       {JointKind::weld, "weld"},
                                                       {JointKind::distance, "distance"},
                                                       {JointKind::free, "free"},
                                                       {JointKind::cam, "cam"}};

// x, y, z, rx, ry, rz.
constexpr std::pair<std::array<bool, 6>, const char*> held_sets[] = {
    {{false, true, true, false, false, false}, "point on a line"},
    {{true, false, false, false, false, false}, "point on a plane"},
    {{false, false, false, false, true, true}, "parallel axes"},
    {{false, false, false, true, true, true}, "no turn"},
    {{true, false, true, true, false, false}, "universal about y and z"},
    {{true, true, true, false, true, false}, "universal about x and z"},
    {{false, true, false, false, false, true}, "universal about x and y"},
    {{true, true, true, true, false, true}, "hinge about y"}};

// Rates and accelerations of order one, a step's rotation below a right angle.
NodeMotion move_at_random(RandomValues& random, const NodeMotion& previous) {
    NodeMotion motion;
    place(previous, random.vector(), random.vector(0.8), motion);
    motion.v = random.vector();
    motion.a = random.vector();
    motion.omega = random.vector();
    motion.alpha = random.vector();
    return motion;
}

// B is not turned against A by so much that the coordinates of joints are undefined.
JointSample make_sample(const std::string& name, const Joint& joint, RandomValues& random) {
    JointSample sample;
    sample.name = name;
    sample.joint = joint;
    const Quat common = random.rotation();
    if (!joint.a.anchor.is_ground()) {
        sample.previous_a.Lambda = common;
        sample.a = move_at_random(random, sample.previous_a);
    }
    if (!joint.b.anchor.is_ground()) {
        sample.previous_b.Lambda = exp_quaternion(random.vector(0.5)) * sample.a.Lambda;
        sample.b = move_at_random(random, sample.previous_b);
    }
    sample.turn_before = random.number(-40.0, 40.0);
    sample.motors.turn = {random.number(-1.0, 1.0), random.number(-1.0, 1.0), random.number(-1.0, 1.0)};
    sample.motors.slide = {random.number(-1.0, 1.0), random.number(-1.0, 1.0), random.number(-1.0, 1.0)};
    return sample;
}

// As it is, with each motor that it can have, and with both.
std::vector<std::pair<std::string, Joint>> add_motors(const std::string& name, const Joint& joint) {
    std::vector<std::pair<std::string, Joint>> joints{{name, joint}};
    if (joint.has_turn()) {
        joints.emplace_back(name + ", turned", joint);
        joints.back().second.turn.motion = TimeFunction(1.0);
    }
    if (joint.has_slide()) {
        joints.emplace_back(name + ", pushed", joint);
        joints.back().second.slide.motion = TimeFunction(1.0);
    }
    if (joint.kind == JointKind::cylinder || joint.kind == JointKind::free) {
        joints.push_back(joints[1]);
        joints.back().first = name + ", turned and pushed";
        joints.back().second.slide.motion = TimeFunction(1.0);
    }
    // Without a motor it has no equations.
    if (joint.kind == JointKind::free) joints.erase(joints.begin());
    return joints;
}

void add_samples(const std::string& name,
                 const Joint& joint,
                 RandomValues& random,
                 std::vector<JointSample>& samples) {
    samples.push_back(make_sample(name, joint, random));
    Joint grounded = joint;
    grounded.a.anchor.node = -1;
    samples.push_back(make_sample(name + ", A the ground", grounded, random));
    grounded = joint;
    grounded.b.anchor.node = -1;
    samples.push_back(make_sample(name + ", B the ground", grounded, random));
}

std::vector<JointSample> make_samples() {
    RandomValues random(601);
    std::vector<JointSample> samples;
    for (const auto& [kind, kind_name] : kinds) {
        for (const auto& [name, joint] : add_motors(kind_name, make_joint(kind, random)))
            add_samples(name, joint, random, samples);
    }
    for (const auto& [held, name] : held_sets) {
        Joint joint = make_joint(JointKind::generic, random);
        joint.held = held;
        add_samples(std::string("generic, ") + name, joint, random, samples);
    }
    return samples;
}

}  // namespace

const std::vector<JointSample>& joint_samples() {
    static const std::vector<JointSample> samples = make_samples();
    return samples;
}

// Its radius and curvature vary. It is so far from A's point that points around that are outside.
JointCam make_cam(double size) {
    std::vector<PlaneCurve::Point> points;
    constexpr int count = 40;
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / count;
        const double radius = size * (1.0 + 0.2 * std::cos(angle) + 0.05 * std::sin(2.0 * angle));
        points.emplace_back(3.0 * size + radius * std::cos(angle), radius * std::sin(angle));
    }
    return {.curve = std::make_shared<PlaneCurve>(points, true), .roller = 0.4 * size};
}

Joint make_joint(JointKind kind, RandomValues& random) {
    Joint joint;
    joint.kind = kind;
    joint.a.axes = random.rotation().toRotationMatrix();
    joint.b.axes = joint.a.axes;
    if (kind == JointKind::universal) {
        const Vec3 axis = joint.a.axes.col(0);
        const Vec3 other = exp_quaternion(random.number(0.5, 2.0) * axis) * joint.a.axes.col(1);
        joint.b.axes << other, axis, other.cross(axis);
    }
    joint.a.anchor = {0, random.vector()};
    joint.b.anchor = {1, random.vector()};
    joint.lead = 0.7;
    joint.length = 1.3;
    if (kind == JointKind::cam) joint.cam = make_cam(1.0);
    return joint;
}

FreeCoordinates make_free_coordinates(RandomValues& random) {
    return {random.number(-2.0, 2.0),
            random.number(-2.0, 2.0),
            random.number(-1.0, 1.0),
            Vec3(0.0, random.number(-1.0, 1.0), random.number(-1.0, 1.0)),
            random.rotation(),
            random.direction()};
}

namespace {

// Of two turns that are free the first is about an axis of A, the second about one of B.
Quat turn_generic(const Joint& joint, const FreeCoordinates& free) {
    std::vector<int> axes;
    for (int k = 0; k < 3; ++k) {
        if (!joint.held[static_cast<std::size_t>(3 + k)]) axes.push_back(k);
    }
    if (axes.size() == 3) return free.ball;
    Quat turn = Quat::Identity();
    double angle = free.turn;
    for (const int k : axes) {
        turn = turn * exp_quaternion(angle * Vec3(joint.a.axes.col(k)));
        angle = free.second_turn;
    }
    return turn;
}

// B's rotation against A, in the global axes of t = 0.
Quat turn_free(const Joint& joint, const FreeCoordinates& free) {
    const Vec3 axis = joint.a.axes.col(0);
    switch (joint.kind) {
        case JointKind::ball:
        case JointKind::distance:
        case JointKind::cam:
            return free.ball;
        case JointKind::universal:
            return exp_quaternion(free.turn * axis) *
                   exp_quaternion(free.second_turn * Vec3(joint.b.axes.col(0)));
        case JointKind::generic:
            return turn_generic(joint, free);
        case JointKind::slider:
        case JointKind::weld:
            return Quat::Identity();
        default:
            return exp_quaternion(free.turn * axis);
    }
}

// From A's point to B's, in the axes of A.
Vec3 slide_free(const Joint& joint, const FreeCoordinates& free) {
    switch (joint.kind) {
        case JointKind::cylinder:
        case JointKind::slider:
        case JointKind::free:
            return {free.slide, 0.0, 0.0};
        case JointKind::generic: {
            Vec3 slide(free.slide, free.across[1], free.across[2]);
            for (int i = 0; i < 3; ++i) {
                if (joint.held[static_cast<std::size_t>(i)]) slide[i] = 0.0;
            }
            return slide;
        }
        case JointKind::screw:
            return {joint.lead * free.turn / (2.0 * std::numbers::pi), 0.0, 0.0};
        case JointKind::plane:
            return free.across;
        case JointKind::distance:
            return joint.length * free.direction;
        case JointKind::cam: {
            const PlaneCurve::Place place = joint.cam->curve->find_place(free.turn);
            const Vec3 point(free.slide, place.point.x(), place.point.y());
            return point +
                   joint.cam->side * joint.cam->roller * Vec3(0.0, place.tangent.y(), -place.tangent.x());
        }
        default:
            return Vec3::Zero();
    }
}

}  // namespace

NodeMotion close(const Joint& joint, const NodeMotion& a, const FreeCoordinates& free) {
    NodeMotion b;
    b.Lambda = a.Lambda * turn_free(joint, free);
    b.r = a.r + a.Lambda * (joint.a.anchor.arm + joint.a.axes * slide_free(joint, free)) -
          b.Lambda * joint.b.anchor.arm;
    return b;
}

NodeMotion move_rigidly(const NodeMotion& motion, const Quat& R, const Vec3& d) {
    NodeMotion moved = motion;
    moved.r = R * motion.r + d;
    moved.Lambda = R * motion.Lambda;
    for (Vec3 NodeMotion::*vector :
         {&NodeMotion::theta, &NodeMotion::v, &NodeMotion::a, &NodeMotion::omega, &NodeMotion::alpha})
        moved.*vector = R * motion.*vector;
    return moved;
}

}  // namespace gxrod::tools
