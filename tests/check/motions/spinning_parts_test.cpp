#include "check/motions/spinning_parts.hpp"

#include "tools/catch.hpp"
#include "tools/rod_models.hpp"

using namespace gxrod;
using namespace gxrod::tools;
using Catch::Contains;

namespace {

const std::array<double, 6> round_stiffness{1e4, 400.0, 400.0, 5.0, 1.0, 1.0};
const std::array<double, 6> round_mass{1.0, 1.0, 1.0, 0.02, 0.01, 0.01};

// A shaft along x, and a node at rest next to its end.
Model make_shaft_model() {
    Model model = make_rod_model(along_x, 1.0, {2, 2}, make_section(round_stiffness, round_mass));
    model.rods[0].name = "shaft";
    model.nodes.push_back({"pedestal", Vec3(1.0, 0.0, 0.0)});
    return model;
}

std::string find_in(const Model& model) {
    TurningFrame frame{.axis = Vec3::UnitX(), .speed = TimeFunction(3.0)};
    frame.spinning.assign(model.nodes.size(), true);
    frame.spinning.back() = false;
    return find_unsteady_spin(model, frame);
}

Bushing make_bearing(const Model& model, BushingAxes carrier, const std::array<double, 6>& stiffness) {
    Bushing bushing{.name = "b", .carrier = carrier};
    bushing.ends = {Anchor{last_node(model)}, Anchor{last_node(model) - 1}};
    bushing.stiffness = Vec6(stiffness.data()).asDiagonal();
    return bushing;
}

}  // namespace

TEST_CASE("what spins in a frame at rest is round", "[check]") {
    Model model = make_shaft_model();
    CHECK(find_in(model).empty());
    SECTION("sections") {
        model.sections[0] = make_section({1e4, 400.0, 400.0, 5.0, 1.0, 1.1}, round_mass);
        CHECK_THAT(find_in(model), Contains("rod.shaft has a section that is not alike to all sides"));
        model.sections[0] = make_section(round_stiffness, {1.0, 1.0, 1.0, 0.02, 0.01, 0.02});
        CHECK_THAT(find_in(model), Contains("rod.shaft has a section that is not alike to all sides"));
        model.sections[0] = make_section(round_stiffness, round_mass);
        model.sections[0].kelvin_voigt_components = Vec6(0.1, 0.1, 0.1, 0.1, 0.1, 0.2);
        CHECK_THAT(find_in(model), Contains("rod.shaft has a section that is not alike to all sides"));
    }
    SECTION("bodies") {
        Body disc{.name = "disc", .node = 1, .mass = 1.0, .inertia = Vec3(2.0, 1.0, 1.0).asDiagonal()};
        disc.centre_of_mass.x() = 0.1;
        model.bodies.push_back(disc);
        CHECK(find_in(model).empty());
        model.bodies[0].attitude = Quat(Eigen::AngleAxisd(0.3, Vec3::UnitZ()));
        CHECK_THAT(find_in(model), Contains("body.disc spins, and its centre of mass is off its axis"));
        model.bodies[0].centre_of_mass.setZero();
        CHECK_THAT(find_in(model), Contains("body.disc spins, and its inertia is not alike to all sides"));
    }
    SECTION("shapes") {
        model.rods[0].rest_strains.assign(4, Vec6::Unit(4));
        CHECK_THAT(find_in(model), Contains("a stress-free shape of its own"));
        model.rods[0].rest_strains.clear();
        model.rods[0].triads[0] = Quat(Eigen::AngleAxisd(0.1, Vec3::UnitZ()));
        CHECK_THAT(find_in(model), Contains("is not straight along rotation.axis"));
    }
}

TEST_CASE("ties between what spins and what does not let it spin", "[check]") {
    Model model = make_shaft_model();
    for (const BushingAxes carrier : {BushingAxes::a, BushingAxes::ground}) {
        model.bushings = {make_bearing(model, carrier, {1.0, 2.0, 3.0, 0.0, 4.0, 5.0})};
        CHECK(find_in(model).empty());
        model.bushings = {make_bearing(model, carrier, {1.0, 2.0, 2.0, 1.0, 0.0, 0.0})};
        CHECK_THAT(find_in(model), Contains("bushing.b holds the spin"));
    }
    model.bushings = {make_bearing(model, BushingAxes::b, {1.0, 2.0, 3.0})};
    CHECK_THAT(find_in(model), Contains("bushing.b has axes that spin, and is not alike to all sides"));
    model.bushings = {make_bearing(model, BushingAxes::b, {1.0, 2.0, 2.0})};
    CHECK(find_in(model).empty());
    model.bushings = {make_bearing(model, BushingAxes::between, {1.0, 2.0, 2.0})};
    CHECK_THAT(find_in(model), Contains("half way between what spins and what does not"));
    model.bushings = {make_bearing(model, BushingAxes::ground, {1.0, 2.0, 3.0})};
    model.bushings[0].ends[1].arm = Vec3(0.0, 0.1, 0.0);
    CHECK_THAT(find_in(model), Contains("bushing.b is tied to a part that spins, off its axis"));
    model.bushings.clear();
    const auto find_joint = [&](JointKind kind, const Mat3& axes, auto&& change) {
        Joint joint;
        joint.name = "j";
        joint.kind = kind;
        joint.a = {Anchor{last_node(model)}, axes};
        joint.b = {Anchor{last_node(model) - 1}, axes};
        change(joint);
        model.joints = {joint};
        return find_in(model);
    };
    const auto as_is = [](Joint&) {};
    const Mat3 along = Mat3::Identity();
    Mat3 across;
    across << Vec3::UnitY(), Vec3::UnitZ(), Vec3::UnitX();
    for (const JointKind kind : {JointKind::ball, JointKind::hinge, JointKind::cylinder, JointKind::plane})
        CHECK(find_joint(kind, along, as_is).empty());
    CHECK_THAT(find_joint(JointKind::hinge, across, as_is),
               Contains("has an axis other than that of the spin"));
    for (const JointKind kind : {JointKind::weld, JointKind::slider, JointKind::screw})
        CHECK_THAT(find_joint(kind, along, as_is), Contains("joint.j holds the spin"));
    CHECK_THAT(find_joint(JointKind::hinge, along, [](Joint& joint) { joint.turn.stiffness = 1.0; }),
               Contains("on the turn against what spins"));
    const auto both = [](Joint& joint) { joint.a.anchor.node = 0; };
    CHECK(find_joint(JointKind::weld, across, both).empty());
    CHECK_THAT(find_joint(JointKind::universal, along, both), Contains("turns once a revolution"));
}

TEST_CASE("loads that turn with what spins are along its axis", "[check]") {
    Model model = make_shaft_model();
    add_ramp(model, 1, {0.0, 1.0, 0.0}, {0.0, 0.0, 2.0});
    model.loads.back().key = "load[0]";
    CHECK(find_in(model).empty());
    model.loads.back().frame = Frame::follower;
    CHECK_THAT(find_in(model), Contains("load[0] turns with a part that spins"));
    model.loads.back().node = last_node(model);
    CHECK(find_in(model).empty());
    model.gravity = TimeVector(Vec3(0.0, -9.81, 0.0));
    CHECK(find_in(model).empty());
}
