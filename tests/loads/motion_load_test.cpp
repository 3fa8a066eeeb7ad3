// Loads that depend on the motion of their points: what they put on nodes, and its derivatives.
#include "loads/motion_load.hpp"

#include "loads/nodal_load.hpp"
#include "loads/shape_functions.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

const std::vector<Frame> frames{Frame::spatial, Frame::follower, Frame::body};

// Force and moment that depend on all of the motion, not linearly.
MotionLoad make_load() {
    RandomValues random(3);
    MotionLoad load;
    load.has_force = load.has_moment = load.turns = true;
    const Eigen::Matrix<double, 6, 12> by = random.matrix<6, 12>();
    load.value = [by](double time, double s, const PointMotion& motion) {
        Eigen::Matrix<double, 12, 1> all;
        all << motion.position, motion.velocity, motion.rotation, motion.spin;
        const Vec6 linear = by * all;
        return Vec6((time + s) * linear + 0.3 * linear.cwiseProduct(linear));
    };
    return load;
}

NodeMotion make_motion(RandomValues& random, double angle) {
    NodeMotion motion;
    motion.r = random.vector();
    motion.Lambda = exp_quaternion(random.vector(angle));
    motion.v = random.vector();
    motion.omega = random.vector();
    return motion;
}

// As the unknowns of a node move it.
NodeMotion move(NodeMotion motion, const NodeLinearization& by, const Vec6& step) {
    const Vec3 way = step.head<3>(), spin = step.tail<3>();
    motion.r += by.placement * way;
    motion.v += by.rate * way;
    motion.Lambda = exp_quaternion(Vec3(by.placement * spin)) * motion.Lambda;
    motion.omega += by.d_omega * spin;
    return motion;
}

std::vector<NodeLinearization> list_linearizations(RandomValues& random) {
    std::vector<NodeLinearization> all;
    for (const auto& [placement, rate] : {std::pair(1.0, 0.0), {0.0, 1.7}, {1.0, 1.7}}) {
        NodeLinearization one;
        one.placement = placement;
        one.rate = rate;
        if (rate != 0.0) one.d_omega = rate * Mat3::Identity() + 0.1 * random.matrix<3>();
        all.push_back(one);
    }
    return all;
}

// One curved element of three nodes.
LoadedElement make_element(const DistributedLoad& load) {
    RandomValues random(8);
    return {.load = &load,
            .nodes = {2, 0, 1},
            .triads = {random.rotation(), random.rotation(), random.rotation()},
            .arc_lengths = {0.5, 1.1, 1.9},
            .positions = {Vec3::Zero(), Vec3(0.6, 0.2, 0.0), Vec3(1.3, 0.0, 0.1)},
            .shapes = find_shape_functions(2)};
}

}  // namespace

TEST_CASE("the tangent of a load by motion is its derivative", "[loads]") {
    RandomValues random(4);
    for (const Frame frame : frames) {
        NodalLoad load;
        load.frame = frame;
        load.axes = random.rotation();
        load.by_motion = make_load();
        const NodeMotion motion = make_motion(random, 2.0);
        for (const NodeLinearization& by : list_linearizations(random)) {
            Mat6 expected;
            for (int i = 0; i < 6; ++i) {
                expected.col(i) = differentiate([&](double amount) {
                    return compute_load(load, move(motion, by, amount * Vec6::Unit(i)), 0.7);
                });
            }
            const Mat6 tangent = compute_motion_tangent(load, motion, by, 0.7, 2.0) +
                                 compute_load_tangent(load, compute_load(load, motion, 0.7), by);
            CHECK(relative_difference(tangent, expected) < 1e-8);
        }
    }
}

TEST_CASE("a load along a rod by motion is integrated with what nodes have of it", "[loads]") {
    // Springs along a straight element: −k ∫ N_I N_J ds r_J.
    DistributedLoad load;
    load.by_motion = MotionLoad([](double, const Vec3& r, const Vec3& v) { return Vec3(-3.0 * r - v); });
    LoadedElement element = make_element(load);
    element.arc_lengths = {0.0, 1.0};
    element.nodes = {1, 0};
    element.positions = {Vec3::Zero(), Vec3(0.0, 2.0, 0.0)};  // twice as long as its arc length says
    element.shapes = find_shape_functions(1);
    RandomValues random(5);
    const std::vector<NodeMotion> motions{make_motion(random, 1.0), make_motion(random, 1.0)};
    const LoadVector forces = compute_motion_load(element, 0.0, motions);
    const Vec3 first = -3.0 * motions[1].r - motions[1].v, last = -3.0 * motions[0].r - motions[0].v;
    CHECK((forces.segment<3>(0) - 2.0 / 6.0 * (2.0 * first + last)).norm() < 1e-14);
    CHECK((forces.segment<3>(6) - 2.0 / 6.0 * (first + 2.0 * last)).norm() < 1e-14);
    CHECK(forces.segment<3>(3).isZero(0.0));
}

TEST_CASE("the tangent of a load along a rod by motion is its derivative", "[loads]") {
    RandomValues random(6);
    for (const Frame frame : frames) {
        DistributedLoad load;
        load.frame = frame;
        load.by_motion = make_load();
        const LoadedElement element = make_element(load);
        std::vector<NodeMotion> motions;
        for (int i = 0; i < 3; ++i) motions.push_back(make_motion(random, 0.5));
        for (const NodeLinearization& by : list_linearizations(random)) {
            Eigen::MatrixXd expected(18, 18);
            for (int i = 0; i < 18; ++i) {
                const auto node = static_cast<std::size_t>(element.nodes[static_cast<std::size_t>(i / 6)]);
                expected.col(i) = differentiate([&](double amount) {
                    std::vector<NodeMotion> moved = motions;
                    moved[node] = move(motions[node], by, amount * Vec6::Unit(i % 6));
                    return Eigen::VectorXd(compute_motion_load(element, 0.7, moved));
                });
            }
            const LoadMatrix tangent = compute_motion_load_tangent(
                element, 0.7, motions, std::vector<NodeLinearization>(3, by), 2.0);
            CHECK(relative_difference(tangent, expected) < 1e-8);
        }
    }
}
