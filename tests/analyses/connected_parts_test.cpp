#include "analyses/connected_parts.hpp"

#include <catch2/catch.hpp>

namespace gxrod {
namespace {

// Rods of one element a pair of nodes.
Model make_net(int nodes, const std::vector<std::vector<std::pair<int, int>>>& rods) {
    Model model;
    model.nodes.resize(static_cast<std::size_t>(nodes));
    for (std::size_t i = 0; i < rods.size(); ++i) {
        Rod rod;
        rod.name = std::string(1, static_cast<char>('a' + i));
        for (const auto& [first, second] : rods[i]) {
            rod.element_nodes.insert(rod.element_nodes.end(), {first, second});
            rod.nodes.insert(rod.nodes.end(), {first, second});
        }
        model.rods.push_back(rod);
    }
    return model;
}

Body make_body(const std::string& name, int node) {
    Body body;
    body.name = name;
    body.node = node;
    return body;
}

}  // namespace

TEST_CASE("Rods and bodies that share nodes are one part", "[analyses]") {
    Model model = make_net(8, {{{0, 1}, {1, 2}}, {{3, 4}}, {{4, 5}, {5, 2}}});
    model.bodies = {make_body("tip", 2), make_body("top", 6), make_body("pan", 7)};
    const std::vector<ConnectedPart> parts = find_connected_parts(model);
    REQUIRE(parts.size() == 3);
    CHECK(parts[0].nodes == std::vector{0, 1, 2, 3, 4, 5});
    CHECK(parts[0].rods == std::vector{0, 1, 2});
    CHECK(parts[0].bodies == std::vector{0});
    CHECK(describe_part(model, parts[0]) == "rods a, b and c, body tip");
    CHECK(parts[1].rods.empty());
    CHECK(describe_part(model, parts[1]) == "body top");
    CHECK(parts[2].nodes == std::vector{7});
}

TEST_CASE("A rod of a net in pieces is in several parts", "[analyses]") {
    const Model model = make_net(6, {{{0, 1}, {4, 5}}, {{2, 3}}, {{3, 5}}});
    const std::vector<ConnectedPart> parts = find_connected_parts(model);
    REQUIRE(parts.size() == 2);
    CHECK(describe_part(model, parts[0]) == "rod a");
    CHECK(describe_part(model, parts[1]) == "rods a, b and c");
}

TEST_CASE("Many names are cut short", "[analyses]") {
    std::vector<std::vector<std::pair<int, int>>> rods;
    for (int i = 0; i < 9; ++i) rods.push_back({{i, i + 1}});
    const Model model = make_net(10, rods);
    CHECK(describe_part(model, find_connected_parts(model)[0]) == "rods a, b, c, d, e, f and 3 more");
    Model bodies;
    bodies.nodes.resize(1);
    bodies.bodies = {make_body("p", 0), make_body("q", 0)};
    CHECK(describe_part(bodies, find_connected_parts(bodies)[0]) == "bodies p and q");
}

}  // namespace gxrod
