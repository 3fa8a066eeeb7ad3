#include "model/ties/ties.hpp"

#include "tools/catch.hpp"

using namespace gxrod;

namespace {

Anchor at_node(int node) { return {.node = node}; }

// A tie of each kind, and two joints more, which the gear couples.
Model make_tied_model() {
    Model model;
    model.nodes.resize(6);
    Rod rod;
    rod.nodes = {4, 5};
    model.rods = {rod};
    Spring spring;
    spring.name = "strut";
    spring.ends = {at_node(0), Anchor{}};
    model.springs = {spring};
    Bushing bushing;
    bushing.name = "mount";
    bushing.ends = {at_node(1), at_node(2)};
    model.bushings = {bushing};
    for (const int node : {1, 2, 3}) {
        Joint joint;
        joint.name = "pin" + std::to_string(node);
        joint.a.anchor = at_node(node);
        model.joints.push_back(joint);
    }
    model.joints[0].b.anchor = at_node(0);
    Gear gear;
    gear.name = "train";
    gear.sides = {GearSide{.joint = 1}, GearSide{.joint = 0}};
    model.gears = {gear};
    model.sleeves = {Sleeve{.name = "collar", .rod = 0, .point = at_node(3)}};
    return model;
}

}  // namespace

TEST_CASE("ties of all kinds are listed with their ends", "[model]") {
    const Model model = make_tied_model();
    const std::vector<std::pair<std::string, std::array<int, 2>>> expected{{"spring.strut", {0, -1}},
                                                                           {"bushing.mount", {1, 2}},
                                                                           {"joint.pin1", {1, 0}},
                                                                           {"joint.pin2", {2, -1}},
                                                                           {"joint.pin3", {3, -1}},
                                                                           {"gear.train", {2, 0}},
                                                                           {"joint.collar", {4, 3}}};
    const std::vector<Tie> ties = list_ties(model);
    REQUIRE(ties.size() == expected.size());
    for (std::size_t i = 0; i < ties.size(); ++i) {
        CHECK(key_of(ties[i]) == expected[i].first);
        CHECK(std::array{ties[i].ends[0].node, ties[i].ends[1].node} == expected[i].second);
        CHECK(ties[i].has_ground() == (expected[i].second[1] < 0));
    }
    CHECK(list_ties(model, TieKind::joint).at(2).index == 2);
}

TEST_CASE("ties that are elements are listed and visited in one order", "[model]") {
    Model model = make_tied_model();
    model.springs.push_back(model.springs[0]);
    model.springs[1].name = "stay";
    const std::vector<Tie> listed = list_element_ties(model);
    CHECK(count_element_ties(model) == listed.size());
    std::size_t count = 0;
    for_each_element_tie(model, [&](TieKind kind, const auto& tie) {
        REQUIRE(count < listed.size());
        CHECK(is_element(kind));
        CHECK(listed[count].kind == kind);
        CHECK(listed[count].name == &tie.name);
        ++count;
    });
    CHECK(count == 3);
    for_each_tie_list(
        model, [&](TieKind kind, const auto& list) { CHECK(list.size() == list_ties(model, kind).size()); });
}

TEST_CASE("each kind of tie that is an element answers what is asked of all", "[model]") {
    Model model = make_tied_model();
    Spring& spring = model.springs[0];
    Bushing& bushing = model.bushings[0];
    spring.ends[1].arm = Vec3(3, 0, 0);
    spring.stiffness = 5.0;
    spring.length = 3.0;
    bushing.stiffness.diagonal() << 1, 2, 3, 6, 5, 4;
    CHECK(stiffness_of(spring).displacement == 5.0);
    CHECK(stiffness_of(spring).turn == 0.0);
    CHECK(stiffness_of(spring).length == 3.0);
    CHECK(stiffness_of(bushing).displacement == 3.0);
    CHECK(stiffness_of(bushing).turn == 6.0);
    CHECK(list_numbers(spring).at(2).first == std::string("free length"));
    CHECK(list_numbers(spring).at(2).second == 3.0);
    CHECK(list_numbers(bushing).at(3).first == std::string("k rx"));
    CHECK(list_numbers(bushing).at(3).second == 6.0);
    const auto strains = [&](const auto& tie) { return is_strained(model, tie); };
    const auto is_damped = [](const auto& tie) { return tie.has_damping(); };
    CHECK_FALSE(any_element_tie(model, strains));
    spring.length = 2.0;
    CHECK(any_element_tie(model, strains));
    CHECK_FALSE(any_element_tie(model, is_damped));
    bushing.damping(3, 3) = 1.0;
    CHECK(any_element_tie(model, is_damped));
}

TEST_CASE("joints, gears and sleeves are numbered one after the other", "[model]") {
    const Model model = make_tied_model();
    CHECK(number_of(model, TieKind::joint, 2) == 2);
    CHECK(number_of(model, TieKind::gear, 0) == 3);
    CHECK(number_of(model, TieKind::sleeve, 0) == 4);
    CHECK(count_numbered_ties(model) == 5);
    std::vector<std::size_t> numbers;
    for_each_coordinates(model, [&](std::size_t number, const std::string&, const auto&, const auto&) {
        numbers.push_back(number);
    });
    CHECK(numbers == std::vector<std::size_t>{0, 1, 2, 4});
}

TEST_CASE("coordinates of joints and sleeves are asked together", "[model]") {
    for (const int which : {0, 1, 2}) {
        Model model = make_tied_model();
        CHECK_FALSE(has_joint_drive(model));
        CHECK_FALSE(has_joint_friction(model));
        JointCoordinate& one = which == 0   ? model.joints[1].turn
                               : which == 1 ? model.joints[2].slide
                                            : model.sleeves[0].slide;
        one.friction.force = 1.0;
        CHECK(has_joint_friction(model));
        one.rest = TimeFunction(0.5);
        CHECK_FALSE(has_joint_drive(model));  // without a spring
        one.stiffness = 2.0;
        CHECK(has_joint_drive(model));
        for_each_coordinates(model, [](std::size_t, const std::string&, auto& turn, auto& slide) {
            turn.friction.force = slide.friction.force = 0.0;
        });
        CHECK_FALSE(has_joint_friction(model));
    }
}
