#include "constraints/supports.hpp"

#include <catch2/catch.hpp>

using namespace gxrod;

TEST_CASE("supports hold the components that they name", "[constraints]") {
    Model model;
    model.nodes.resize(3);
    model.supports.push_back({0, {true, true, true, false, false, false}});
    model.supports.push_back({2, {false, false, false, true, true, false}});
    const auto fixed = compute_fixed_components(model);
    REQUIRE(fixed.size() == 3);
    CHECK(fixed[0] == FixedComponents{true, true, true, false, false, false});
    CHECK(fixed[1] == FixedComponents{});
    CHECK(fixed[2] == FixedComponents{false, false, false, true, true, false});
}

TEST_CASE("supports of one node add up", "[constraints]") {
    Model model;
    model.nodes.resize(1);
    model.supports.push_back({0, {true, false, false, false, false, false}});
    model.supports.push_back({0, {true, false, true, false, false, true}});
    CHECK(compute_fixed_components(model)[0] == FixedComponents{true, false, true, false, false, true});
}
