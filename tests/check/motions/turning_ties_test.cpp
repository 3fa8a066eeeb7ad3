#include "check/motions/turning_ties.hpp"

#include "elements/bushing_element.hpp"
#include "elements/carried_bushing_element.hpp"
#include "tools/catch.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;
using Catch::Contains;

namespace {

const TurningFrame frame{.axis = Vec3::UnitX(), .through = Vec3(0.0, 1.0, -2.0), .speed = TimeFunction(2.0)};
const Vec3 on_axis(3.0, 1.0, -2.0);
const Vec3 off_axis(3.0, 1.5, -2.0);

using Diagonal = std::array<double, 6>;

Mat6 diagonal(const Diagonal& values) { return Vec6(values.data()).asDiagonal(); }

// From the ground to a node, at one place.
Bushing make_bushing(BushingAxes carrier, const Diagonal& stiffness, const Diagonal& damping = {}) {
    return {.name = "b",
            .ends = {Anchor{-1, on_axis}, Anchor{0, Vec3(0.1, 0.0, 0.0)}},
            .carrier = carrier,
            .stiffness = diagonal(stiffness),
            .damping = diagonal(damping)};
}

std::string find_of(const Bushing& bushing) {
    Model model;
    model.nodes.resize(2);
    model.bushings.push_back(bushing);
    return find_unsteady_tie(model, frame);
}

NodeMotion turned_about_axis(const NodeMotion& motion, double angle) {
    const Quat turn(Eigen::AngleAxisd(angle, frame.axis));
    NodeMotion turned = motion;
    turned.r = frame.through + turn * (motion.r - frame.through);
    turned.Lambda = turn * motion.Lambda;
    turned.v = turn * motion.v;
    turned.omega = turn * motion.omega;
    return turned;
}

// How much the force of a bushing to the ground differs, where all is turned about the axis, from the force
// turned likewise.
template <class Element>
double measure_change(const Bushing& bushing, unsigned seed) {
    RandomValues random(seed);
    const Element element(bushing);
    NodeMotion motion;
    motion.r = on_axis - bushing.ends[1].arm + random.vector(0.2);
    motion.Lambda = exp_quaternion(random.vector(0.3));
    motion.v = random.vector(1.0);
    motion.omega = random.vector(1.0);
    const auto compute = [&](const NodeMotion& at) {
        NodalVector<1> force = NodalVector<1>::Zero();
        element.add_internal_force({&at}, {}, force);
        element.add_damping_force({&at}, {}, force);
        return Vec6(force);
    };
    const double angle = 0.7;
    const Quat turn(Eigen::AngleAxisd(angle, frame.axis));
    const Vec6 before = compute(motion), after = compute(turned_about_axis(motion, angle));
    Vec6 expected;
    expected << turn * Vec3(before.head<3>()), turn * Vec3(before.tail<3>());
    return (after - expected).norm() / before.norm();
}

}  // namespace

TEST_CASE("bushings to the ground are steady in a turning frame if they turn what they are given",
          "[check]") {
    struct Row {
        BushingAxes carrier;
        Diagonal stiffness, damping;
        bool is_steady;
    };
    const std::vector<Row> rows{
        {BushingAxes::ground, {1.0, 4.0, 4.0}, {0.0, 0.3, 0.3}, true},
        {BushingAxes::ground, {1.0, 4.0, 4.0, 0.0, 2.0, 2.0}, {0.5, 0.3, 0.3, 0.2, 0.1, 0.1}, true},
        {BushingAxes::ground, {}, {0.0, 0.0, 0.0, 0.2, 0.1, 0.1}, true},
        {BushingAxes::ground, {1.0, 4.0, 4.1}, {}, false},
        {BushingAxes::ground, {1.0, 4.0, 4.0}, {0.0, 0.3, 0.0}, false},
        {BushingAxes::ground, {1.0, 4.0, 4.0, 0.0, 2.0, 1.0}, {}, false},
        {BushingAxes::ground, {1.0, 4.0, 4.0, 1.0, 2.0, 2.0}, {}, false},
        {BushingAxes::ground, {4.0, 4.0, 4.0, 2.0, 0.0, 2.0}, {}, false},
        {BushingAxes::b, {1.0, 4.0, 7.0}, {0.1, 0.3, 0.0}, true},
        {BushingAxes::b, {1.0, 4.0, 7.0, 0.0, 2.0, 1.0}, {0.1, 0.3, 0.0, 0.4, 0.1, 0.0}, true},
        {BushingAxes::b, {1.0, 4.0, 7.0, 3.0, 2.0, 1.0}, {}, false},
        {BushingAxes::a, {1.0, 4.0, 4.0, 0.0, 2.0, 2.0}, {0.0, 0.3, 0.3}, true},
        {BushingAxes::a, {1.0, 4.0, 3.0}, {}, false}};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        INFO("row " << i);
        const Bushing bushing = make_bushing(rows[i].carrier, rows[i].stiffness, rows[i].damping);
        CHECK(find_of(bushing).empty() == rows[i].is_steady);
        double change = 0.0;
        for (unsigned seed = 1; seed < 4; ++seed)
            change = std::max(change, measure_change<CarriedBushingElement<1>>(bushing, seed));
        CHECK((change < 1e-12) == rows[i].is_steady);
    }
    const Bushing between = make_bushing(BushingAxes::between, {1.0, 4.0, 4.0});
    CHECK_THAT(find_of(between), Contains("half way between the ground and what turns"));
    CHECK(measure_change<BushingElement<1>>(between, 5) > 1e-3);
}

TEST_CASE("a bushing off the axis is steady if only its place along the axis matters", "[check]") {
    Bushing bushing = make_bushing(BushingAxes::ground, {1.0, 4.0, 4.0});
    bushing.ends[0].arm = off_axis;
    CHECK_THAT(find_of(bushing), Contains("bushing.b is tied to the ground off the axis"));
    CHECK(measure_change<CarriedBushingElement<1>>(bushing, 1) > 1e-3);
    bushing = make_bushing(BushingAxes::ground, {1.0}, {0.1, 0.3, 0.3});
    bushing.ends[0].arm = off_axis;
    CHECK(find_of(bushing).empty());
    CHECK(measure_change<CarriedBushingElement<1>>(bushing, 1) < 1e-12);
    bushing = make_bushing(BushingAxes::b, {1.0});
    bushing.ends[0].arm = off_axis;
    CHECK_FALSE(find_of(bushing).empty());
    CHECK(measure_change<CarriedBushingElement<1>>(bushing, 1) > 1e-3);
}

TEST_CASE("bushings between parts that turn are steady, unless the ground carries their axes", "[check]") {
    for (const BushingAxes carrier : {BushingAxes::between, BushingAxes::a, BushingAxes::b}) {
        Bushing bushing = make_bushing(carrier, {1.0, 2.0, 3.0, 4.0, 5.0, 6.0});
        bushing.ends[0] = Anchor{1};
        CHECK(find_of(bushing).empty());
    }
    Bushing bushing = make_bushing(BushingAxes::ground, {1.0, 2.0, 3.0});
    bushing.ends[0] = Anchor{1};
    CHECK_THAT(find_of(bushing), Contains("not equally stiff and damped to all sides of the axis"));
    bushing.stiffness = diagonal({1.0, 2.0, 2.0, 4.0, 5.0, 5.0});
    CHECK(find_of(bushing).empty());
}

TEST_CASE("joints to the ground are steady in a turning frame along its axis", "[check]") {
    const auto find = [](JointKind kind, const Vec3& place, const Vec3& axis, auto&& change) {
        const Vec3 across = axis.unitOrthogonal();
        Mat3 axes;
        axes << axis, across, axis.cross(across);
        Joint joint{.name = "j",
                    .kind = kind,
                    .a = {Anchor{-1, place}, axes},
                    .b = {Anchor{0}, axes},
                    .turn = {},
                    .slide = {},
                    .strength = {}};
        change(joint);
        Model model;
        model.nodes.resize(1);
        model.joints.push_back(joint);
        return find_unsteady_tie(model, frame);
    };
    const auto as_is = [](Joint&) {};
    const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY();
    for (const JointKind kind :
         {JointKind::hinge, JointKind::cylinder, JointKind::ball, JointKind::distance}) {
        CHECK(find(kind, on_axis, x, as_is).empty());
        CHECK_THAT(find(kind, off_axis, x, as_is), Contains("joint.j is tied to the ground off the axis"));
    }
    CHECK(find(JointKind::plane, off_axis, x, as_is).empty());
    CHECK(find(JointKind::ball, on_axis, y, as_is).empty());
    CHECK_THAT(find(JointKind::hinge, on_axis, y, as_is),
               Contains("with the axis [0, 1, 0]: in a frame that turns about [1, 0, 0] it is not steady"));
    for (const JointKind kind : {JointKind::slider, JointKind::weld, JointKind::screw})
        CHECK_THAT(find(kind, on_axis, x, as_is), Contains("holds the turn about the axis"));
    CHECK(find(JointKind::hinge, on_axis, x, [](Joint& joint) { joint.turn.damping = 1.0; }).empty());
    CHECK(find(JointKind::cylinder, on_axis, x, [](Joint& joint) { joint.slide.stiffness = 1.0; }).empty());
    for (const auto set : {+[](Joint& joint) { joint.turn.stiffness = 1.0; },
                           +[](Joint& joint) { joint.turn.motion = TimeFunction(0.0); },
                           +[](Joint& joint) { joint.turn.limits.upper = 1.0; },
                           +[](Joint& joint) { joint.turn.friction.force = 1.0; }})
        CHECK_THAT(find(JointKind::hinge, on_axis, x, set), Contains("on the turn against the ground"));
    CHECK(find(JointKind::free, off_axis, y, as_is).empty());
    CHECK_FALSE(find(JointKind::free, off_axis, x, [](Joint& joint) { joint.slide.damping = 1.0; }).empty());
    const auto between = [](Joint& joint) { joint.a.anchor.node = 0; };
    CHECK(find(JointKind::weld, on_axis, y, between).empty());
}

TEST_CASE("what joints ask of what turns is listed in the order of their kinds", "[check]") {
    for (std::size_t i = 0; i < turning_joint_cards.size(); ++i)
        CHECK(static_cast<std::size_t>(turning_joint_cards[i].kind) == i);
}
