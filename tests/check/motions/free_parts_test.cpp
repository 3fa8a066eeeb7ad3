#include "check/motions/free_parts.hpp"

#include "check/model_examination.hpp"
#include "tools/catch.hpp"
#include "tools/rod_models.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

int add_body(Model& model, const std::string& name, const Vec3& place) {
    const int node = static_cast<int>(model.nodes.size());
    model.nodes.push_back({name, place});
    Body body;
    body.name = name;
    body.node = node;
    body.mass = 1.0;
    body.inertia = Mat3::Identity();
    model.bodies.push_back(body);
    return node;
}

void add_spring(Model& model, const Anchor& a, const Anchor& b, double stretch = 1.0) {
    Spring spring;
    spring.name = "spring";
    spring.ends = {a, b};
    spring.stiffness = 10.0;
    spring.length = (find_place(model, b) - find_place(model, a)).norm() / stretch;
    model.springs.push_back(spring);
}

std::vector<std::string> describe(const Model& model) {
    std::vector<std::string> texts;
    for (const auto& [part, motions] : find_free_parts(model)) {
        for (const UnsupportedMotion& motion : motions)
            texts.push_back(name_part(part, model) + ": " + describe_unsupported_motion(model, part, motion));
    }
    return texts;
}

void hold_rotations(Model& model, int node) {
    Support support;
    support.node = node;
    support.fixed = {false, false, false, true, true, true};
    model.supports.push_back(support);
}

// Six legs from the ground to a platform, no two in one line: it cannot move.
Model make_platform(int legs) {
    Model model;
    const int node = add_body(model, "platform", Vec3(0.0, 0.0, 1.0));
    for (int i = 0; i < legs; ++i) {
        const double foot = 2.0 * M_PI / 3.0 * (i / 2);
        const double top = foot + (i % 2 == 0 ? 1.0 : -1.0);
        add_spring(model,
                   {-1, Vec3(2.0 * std::cos(foot), 2.0 * std::sin(foot), 0.0)},
                   {node, Vec3(std::cos(top), std::sin(top), 0.0)});
    }
    return model;
}

}  // namespace

TEST_CASE("springs hold what they resist", "[check]") {
    CHECK(describe(make_platform(6)).empty());
    CHECK(count_free_motions(make_platform(6)) == 0);
    CHECK(count_free_motions(make_platform(5)) == 1);
    CHECK(describe(make_platform(5)).size() == 1);
    CHECK(describe(make_platform(0)).size() == 6);
    StaticSettings settings;
    CHECK_FALSE(has_error(examine_model(make_platform(6), settings)));
    CHECK(has_error(examine_model(make_platform(5), settings)));
}

TEST_CASE("a slack spring holds its direction, a taut one others too", "[check]") {
    Model model;
    const int node = add_body(model, "b", Vec3(1.0, 0.0, 0.0));
    hold_rotations(model, node);
    add_spring(model, {-1, Vec3::Zero()}, {node});
    CHECK(describe(model) == std::vector<std::string>{"body b: move along y", "body b: move along z"});
    model.springs.clear();
    add_spring(model, {-1, Vec3::Zero()}, {node}, 1.1);
    CHECK(describe(model).empty());
    model.springs[0].stiffness = 0.0;  // a damper
    CHECK(describe(model).size() == 3);
}

TEST_CASE("parts that move together are all named", "[check]") {
    Model model;
    const int a = add_body(model, "a", Vec3::Zero());
    const int b = add_body(model, "b", Vec3(1.0, 0.0, 0.0));
    hold_rotations(model, a);
    hold_rotations(model, b);
    add_spring(model, {a}, {b}, 1.1);
    CHECK(find_parts(model).size() == 1);
    CHECK(find_parts(model, Ties::rods).size() == 2);
    CHECK(count_free_motions(model) == 3);
    CHECK(describe(model) == std::vector<std::string>{"body a: move along x",
                                                      "body a: move along y",
                                                      "body a: move along z",
                                                      "body b: move along x",
                                                      "body b: move along y",
                                                      "body b: move along z"});
}

TEST_CASE("parts that a damper alone ties are free", "[check]") {
    Model model;
    const int a = add_body(model, "a", Vec3::Zero());
    const int b = add_body(model, "b", Vec3(1.0, 0.0, 0.0));
    add_spring(model, {a}, {b});
    model.springs[0].stiffness = 0.0;
    model.springs[0].damping = 1.0;
    CHECK(count_free_motions(model) == 12);
}

TEST_CASE("a body on springs to a clamped rod is held by it", "[check]") {
    Model model = make_rod_model(along_x, 1.0, {2}, make_section({1.0, 1.0, 1.0, 1.0, 1.0, 1.0}));
    const int tip = last_node(model);
    const int node = add_body(model, "b", Vec3(1.0, 0.0, -1.0));
    hold_rotations(model, node);
    add_spring(model, {tip}, {node}, 1.5);
    CHECK(describe(model).size() > 0);  // nothing holds the rod yet
    clamp(model, 0);
    CHECK(describe(model).empty());
}

TEST_CASE("a model says its springs' trouble", "[check]") {
    Model model;
    const int node = add_body(model, "b", Vec3(1.0, 0.0, 0.0));
    add_spring(model, {-1, Vec3::Zero()}, {node});
    const auto findings = examine_model(model, StaticSettings());
    REQUIRE(!findings.empty());
    CHECK(findings[0].message ==
          "body b can move along y, move along z, turn about an axis along x, turn about an axis along y and "
          "turn about an axis along z; a static analysis needs supports or springs that prevent it");
}
