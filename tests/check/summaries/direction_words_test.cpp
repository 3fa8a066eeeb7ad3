#include "check/summaries/direction_words.hpp"

#include <limits>
#include <numbers>

#include "check/motions/free_motions.hpp"
#include "integrators/integrator.hpp"
#include "model/parts.hpp"
#include "rotation/rotation_map.hpp"
#include "solvers/mechanisms.hpp"
#include "state/increment.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/tops.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

Weakness find_weakness(const Model& model) {
    const System system(model);
    const State state = system.initial_state();
    const auto weakness =
        describe_weakness(system, state, system.pattern(), compute_static_tangent(system, state));
    REQUIRE(weakness);
    return *weakness;
}

// What a mechanism can do, in words; the tangent is singular.
std::string find_mechanism(const Model& model) {
    const Weakness weakness = find_weakness(model);
    CHECK(weakness.stiffness < singular_stiffness);
    return weakness.words;
}

const Vec3 tip(0.0, 3.0, 4.0);

Model make_cantilever(const std::vector<int>& held, int order = 1) {
    Model model;
    add_rod(model, {"cable", Vec3(1.0, 0.0, 0.0), Vec3(11.0, 0.0, 0.0), 10, order});
    add_support(model, 0, held);
    return model;
}

}  // namespace

TEST_CASE("a free rod moves and turns in every way", "[check]") {
    Model model;
    add_rod(model, {"flyer", Vec3::Zero(), tip});
    CHECK(find_mechanism(model) == "the whole model moves along x, y or z, or turns about x, y or z");
    // Beside another one that is held.
    add_rod(model, {"held", Vec3(9.0, 0.0, 0.0), Vec3(9.0, 9.0, 0.0)});
    add_support(model, 5, {0, 1, 2, 3, 4, 5});
    CHECK(find_mechanism(model) == "rod flyer moves along x, y or z, or turns about x, y or z");
}

TEST_CASE("a rod with one free displacement is described by it", "[check]") {
    CHECK(find_mechanism(make_cantilever({0, 2, 3, 4, 5})) == "the whole model moves along y");
    Model model;
    add_rod(model, {"slider", Vec3::Zero(), tip});
    add_support(model, 0, {1, 2, 3, 4, 5});
    CHECK(find_mechanism(model) == "the whole model moves along x");
    // In the support's own axes, whose x is the rod's.
    model.supports[0].axes = turn_x_to(tip);
    CHECK(find_mechanism(model) == "the whole model moves along (0, 0.6, 0.8)");
}

TEST_CASE("a clamp reduced to a hinge or a ball joint names the axis of the rod's turn", "[check]") {
    CHECK(find_mechanism(make_cantilever({0, 1, 2, 3, 4})) ==
          "the whole model turns about z through cable.start");
    CHECK(find_mechanism(make_cantilever({0, 1, 2})) ==
          "the whole model turns about its own axis, y through cable.start or z through cable.start");
    Model model;
    add_rod(model, {"door", Vec3::Zero(), tip});
    add_support(model, 0, {0, 1, 2, 3, 4});
    model.supports[0].axes = exp_quaternion(Vec3(0.3, 0.0, 0.0));
    CHECK(find_mechanism(model) == "the whole model turns about (0, 0.296, -0.955) through door.start");
}

TEST_CASE("a rod that spins between two ball joints turns about its own axis", "[check]") {
    Model model;
    add_rod(model, {"shaft", Vec3::Zero(), tip});
    add_support(model, 0, {0, 1, 2});
    add_support(model, 4, {0, 1, 2});
    CHECK(find_mechanism(model) == "the whole model turns about its own axis");
    add_rod(model, {"other", Vec3(5.0, 0.0, 0.0), Vec3(5.0, 1.0, 0.0)});
    add_support(model, 5, {0, 1, 2, 3, 4, 5});
    CHECK(find_mechanism(model) == "rod shaft turns about its own axis");
    // Bent: about the line between the joints.
    Model bow;
    add_rod(bow, {"arm", Vec3::Zero(), Vec3(3.0, 0.0, 0.0)});
    add_rod(bow, {"leg", Vec3(3.0, 0.0, 0.0), Vec3(3.0, 4.0, 0.0)});
    connect_start(bow, 4);
    add_support(bow, 0, {0, 1, 2});
    add_support(bow, 8, {0, 1, 2});
    CHECK(find_mechanism(bow) == "the whole model turns about (0.6, 0.8, 0) through arm.start");
}

TEST_CASE("an axis that meets no node is said by a point", "[check]") {
    // Two nodes slide along x and y: the rod turns about the corner of the rectangle.
    Model model;
    add_rod(model, {"ladder", Vec3(0.0, 4.0, 0.0), Vec3(3.0, 0.0, 0.0), 3});
    add_support(model, 0, {0, 2, 3, 4});
    add_support(model, 3, {1, 2, 3, 4});
    CHECK(find_mechanism(model) == "the whole model turns about z through (3, 4, 0)");
}

TEST_CASE("a body without rods is named, and turns about its node", "[check]") {
    Model model = make_free_body(Vec3(1.0, 2.0, 0.0), Vec3::Zero());
    add_rod(model, {"held", Vec3(9.0, 0.0, 0.0), Vec3(9.0, 9.0, 0.0)});
    add_support(model, 1, {0, 1, 2, 3, 4, 5});
    const System system(model);
    const State state = system.initial_state();
    std::vector<double> mass;
    system.compute_tangent(state, 0.0, mass_linearizations(state.trial.size()), mass);
    CHECK(describe_weakness(system, state, system.pattern(), mass)->words == "body body turns about z");
    CHECK(find_mechanism(model) == "body body moves along x, y or z, or turns about x, y or z");
}

TEST_CASE("a rod without one stiffness names the strain and the node that moves most", "[check]") {
    const auto weaken = [](int component, int order) {
        Model model = make_cantilever({0, 1, 2, 3, 4, 5}, order);
        model.sections[0].stiffness(component, component) *= 1e-6;
        return find_weakness(model);
    };
    for (const int order : {1, 2}) {
        INFO("order " << order);
        CHECK(weaken(3, order).words == "rod cable, cable.end: twist");
        CHECK(weaken(4, order).words == "rod cable, cable.end: bending about y");
        CHECK(weaken(5, order).words == "rod cable, cable.end: bending about z");
    }
    Model model = make_cantilever({0, 1, 2, 3, 4, 5});
    for (const int component : {0, 1, 2}) {
        model.sections[0].stiffness.diagonal() << 1e6, 1e6, 1e6, 1e8, 1e8, 1e8;
        model.sections[0].stiffness(component, component) = 1e-3;
        static constexpr const char* words[3] = {"extension", "shear along y", "shear along z"};
        CHECK(find_weakness(model).words == std::string("rod cable, cable.end: ") + words[component]);
    }
}

TEST_CASE("a node within a rod is named by its number", "[check]") {
    Model model = make_cantilever({0, 1, 2, 3, 4, 5});
    add_support(model, 10, {0, 1, 2, 3, 4, 5});
    model.sections[0].stiffness(3, 3) = 1e-6;
    CHECK(find_weakness(model).words == "rod cable, node 5: twist");
}

TEST_CASE("what is weak is named, not what it carries", "[check]") {
    Model model = make_cantilever({0, 1, 2, 3, 4, 5});
    model.sections[0].stiffness(3, 3) = 1e-6;
    add_rod(model, {"arm", Vec3(11.0, 0.0, 0.0), Vec3(11.0, 30.0, 0.0)});
    connect_start(model, 10);
    const std::string words = find_weakness(model).words;
    INFO(words);
    CHECK(words.starts_with("rod cable, "));
    CHECK(words.ends_with(": twist"));
}

TEST_CASE("section axes turn with the rod", "[check]") {
    // Weak about the section's y, which points along the global −x after a quarter turn of everything about
    // z.
    Model model = make_cantilever({0, 1, 2, 3, 4, 5});
    model.sections[0].stiffness(4, 4) = 1e-6;
    const System system(model);
    State state = system.initial_state();
    const Vec3 quarter(0.0, 0.0, 0.5 * std::numbers::pi);
    for (std::size_t i = 0; i < state.trial.size(); ++i) {
        place(state.previous[i], exp_quaternion(quarter) * state.previous[i].r, quarter, state.trial[i]);
    }
    const auto weakness =
        describe_weakness(system, state, system.pattern(), compute_static_tangent(system, state));
    REQUIRE(weakness);
    CHECK(weakness->words == "rod cable, cable.end: bending about y");
}

TEST_CASE("a sound structure is not near singular", "[check]") {
    const Weakness weakness = find_weakness(make_cantilever({0, 1, 2, 3, 4, 5}));
    CHECK(weakness.stiffness > 1e3 * singular_stiffness);
    CHECK(weakness.words.starts_with("rod cable, cable.end: bending about"));
}

TEST_CASE("without unknowns or finite values there is no weakness", "[check]") {
    Model model = make_free_body(Vec3::Ones(), Vec3::Zero());
    {
        const System system(model);
        const State state = system.initial_state();
        std::vector<double> values = compute_static_tangent(system, state);
        values[7] = std::numeric_limits<double>::quiet_NaN();
        CHECK_FALSE(describe_weakness(system, state, system.pattern(), values));
    }
    add_support(model, 0, {0, 1, 2, 3, 4, 5});
    const System system(model);
    const State state = system.initial_state();
    CHECK_FALSE(describe_weakness(system, state, system.pattern(), compute_static_tangent(system, state)));
}

TEST_CASE("a screw is not one of the simple motions", "[check]") {
    const Model model = make_cantilever({});
    const System system(model);
    const State state = system.initial_state();
    const ModelPart part = find_parts(model).front();
    const auto describe = [&](const Vec3& displacement, const Vec3& rotation) {
        return describe_rigid_motion({displacement, rotation, Vec3(1.0, 0.0, 0.0)}, part, system, state);
    };
    CHECK(describe({0.0, 2.0, 0.0}, {0.0, 3.0, 0.0}) == "moves and turns as a whole");
    CHECK(describe({0.0, 0.0, 0.0}, {0.0, 3.0, 0.0}) == "turns about y through cable.start");
    CHECK(describe({0.0, 2.0, 0.0}, {0.0, 0.0, 0.0}) == "moves along y");
}
