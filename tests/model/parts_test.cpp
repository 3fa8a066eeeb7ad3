#include "model/parts.hpp"

#include "model/ties/ties.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

Rod make_rod(const std::string& name, int order, const std::vector<int>& element_nodes) {
    Rod rod;
    rod.name = name;
    rod.order = order;
    rod.element_nodes = element_nodes;
    return rod;
}

// Nine nodes: rods a (0 1 2) and b (2 3) meet, c (5 6, 7 8) is a mesh of two lines; node 4 has a body.
Model make_model() {
    Model model;
    model.nodes.resize(9);
    model.nodes[4].name = "lone";
    model.rods = {make_rod("a", 2, {2, 1, 0}), make_rod("b", 1, {3, 2}), make_rod("c", 1, {5, 6, 7, 8})};
    model.bodies.resize(2);
    model.bodies[0].name = "head";
    model.bodies[0].node = 4;
    model.bodies[1].name = "top";
    model.bodies[1].node = 3;
    return model;
}

}  // namespace

TEST_CASE("nodes that elements tie are one part", "[model]") {
    const std::vector<ModelPart> parts = find_parts(make_model());
    REQUIRE(parts.size() == 4);
    CHECK(parts[0].nodes == std::vector{0, 1, 2, 3});
    CHECK(parts[0].rods == std::vector{0, 1});
    CHECK(parts[0].bodies == std::vector{1});
    CHECK(parts[1].nodes == std::vector{4});
    CHECK(parts[1].rods.empty());
    CHECK(parts[1].bodies == std::vector{0});
    CHECK(parts[2].nodes == std::vector{5, 6});
    CHECK(parts[3].nodes == std::vector{7, 8});
    CHECK(parts[2].rods == std::vector{2});
    CHECK(parts[3].rods == std::vector{2});
}

TEST_CASE("a part is named by what it is made of", "[model]") {
    Model model = make_model();
    const std::vector<ModelPart> parts = find_parts(model);
    CHECK(name_part(parts[0], model) == "the part with rods a and b, body top");
    CHECK(name_part(parts[1], model) == "body head");
    CHECK(name_part(parts[2], model) == "rod c");
    CHECK(name_part({{0}, {0, 1, 2}, {}}, model) == "the part with rods a, b and c");
    CHECK(name_part({{0}, {0, 1, 2, 0, 1, 2, 0, 1}, {}}, model) ==
          "the part with rods a, b, c, a, b, c and 2 more");
    CHECK(name_part({{0}, {}, {0, 1}}, model) == "the part with bodies head and top");
    CHECK(name_part({{4}, {}, {}}, model) == "lone");
}

TEST_CASE("a chain numbered backwards is one part", "[model]") {
    Model model;
    model.nodes.resize(100);
    std::vector<int> nodes;
    for (int i = 99; i > 0; --i) nodes.insert(nodes.end(), {i, i - 1});
    model.rods.push_back(make_rod("r", 1, nodes));
    CHECK(find_parts(model).size() == 1);
}

TEST_CASE("springs tie parts, if asked", "[model]") {
    Model model = make_model();
    Spring spring;
    spring.ends = {Anchor{4}, Anchor{6}};
    model.springs = {spring, spring};
    model.springs[1].ends[1] = Anchor{};  // the ground ties nothing
    const std::vector<ModelPart> parts = find_parts(model);
    REQUIRE(parts.size() == 3);
    CHECK(parts[1].nodes == std::vector{4, 5, 6});
    CHECK(parts[1].bodies == std::vector{0});
    CHECK(parts[1].ties(TieKind::spring) == std::vector{0, 1});
    CHECK(parts[0].ties(TieKind::spring).empty());
    const std::vector<ModelPart> by_rods = find_parts(model, Ties::rods);
    REQUIRE(by_rods.size() == 4);
    CHECK(by_rods[1].nodes == std::vector{4});
    CHECK(by_rods[1].ties(TieKind::spring) == std::vector{0, 1});
    CHECK(by_rods[2].ties(TieKind::spring) == std::vector{0});
}

TEST_CASE("bushings tie parts, if asked", "[model]") {
    Model model = make_model();
    Bushing bushing;
    bushing.ends = {Anchor{4}, Anchor{6}};
    model.bushings = {bushing, bushing};
    model.bushings[1].ends[1] = Anchor{};  // the ground ties nothing
    const std::vector<ModelPart> parts = find_parts(model);
    REQUIRE(parts.size() == 3);
    CHECK(parts[1].nodes == std::vector{4, 5, 6});
    CHECK(parts[1].ties(TieKind::bushing) == std::vector{0, 1});
    CHECK(parts[0].ties(TieKind::bushing).empty());
    CHECK(find_parts(model, Ties::rods).size() == 4);
}

TEST_CASE("joints tie parts, if asked", "[model][joint]") {
    Model model = make_model();
    Joint joint;
    joint.a.anchor.node = 4;
    joint.b.anchor.node = 6;
    model.joints = {joint, joint};
    model.joints[1].b.anchor.node = -1;  // the ground ties nothing
    const std::vector<ModelPart> parts = find_parts(model);
    REQUIRE(parts.size() == 3);
    CHECK(parts[1].nodes == std::vector{4, 5, 6});
    CHECK(parts[1].ties(TieKind::joint) == std::vector{0, 1});
    CHECK(parts[0].ties(TieKind::joint).empty());
    const std::vector<ModelPart> by_rods = find_parts(model, Ties::rods);
    REQUIRE(by_rods.size() == 4);
    CHECK(by_rods[1].ties(TieKind::joint) == std::vector{0, 1});
    CHECK(by_rods[2].ties(TieKind::joint) == std::vector{0});
}
