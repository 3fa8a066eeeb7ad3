#include "check/surroundings/fluid_summary.hpp"

#include <fmt/format.h>

#include <cmath>

#include "deck/surroundings/surroundings_decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

std::string of_rod(const std::string& deck) {
    const Model model = read(deck).model;
    return describe_fluid(model, model.rods.at(0));
}

std::string list(const std::string& lines) {
    std::string all;
    for (const std::string& text : list_surroundings(read(tube_deck() + lines).model.surroundings))
        all += text;
    return all;
}

}  // namespace

TEST_CASE("What fluids see of a section is said, defaults too", "[check]") {
    const auto section = [](const std::string& fluid) {
        return describe_fluid(read(tube_deck(fluid) + "[air]\ndensity = 1\n").model.sections.at(0));
    };
    CHECK(
        section("fluid = {}") ==
        "  in fluids: diameter 0.5, area 0.19635, drag 1.2 across, 0 along, added mass 1 across, 0 along\n");
    CHECK(section("fluid = { drag = { x = 0.1, y = 2 }, contents = { density = 900, pressure = 7 } }") ==
          "  in fluids: diameter 0.5, area 0.19635, drag 0.1, 2, 1.2 along x, y, z, added mass 1 across, 0 "
          "along\n  contents: density 900, area 0.125664, 113.097 of the mass per length, pressure 7\n");
    CHECK(describe_fluid(Section{}).empty());
}

TEST_CASE("A rod is weighed in water and laid on the ground", "[check]") {
    const auto weight = [](double density) {
        return 9.81 * M_PI * (density * (0.25 * 0.25 - 0.2 * 0.2) - 1000.0 * 0.25 * 0.25);
    };
    CHECK(of_rod(tube_deck() + water_deck) ==
          fmt::format("  in water: displaced mass 1963.5, weight less buoyancy {:.6g} per length\n",
                      weight(7850.0)));
    const std::string light = replaced(tube_deck(), "density = 7850", "density = 785");
    CHECK_THAT(of_rod(light + water_deck),
               Contains(fmt::format("weight less buoyancy {:.6g} per length: it floats", weight(785.0))));
    const std::string tapered =
        replaced(tube_deck(), "outer_radius = 0.25", "outer_radius = \"0.205 + 0.01*s\"");
    CHECK_THAT(of_rod(tapered + water_deck), Contains(" … ") && Contains(": in parts it floats"));
    CHECK_THAT(of_rod(tube_deck() + water_deck + "[seabed]\nz = -10\nstiffness = 1e5\n"),
               Contains(fmt::format("  at rest on the ground: {:.6g} deep, 0.14 of the diameter\n",
                                    weight(7850.0) / (1e5 * 0.5))));
    CHECK(of_rod(tube_deck("")).empty());
}

TEST_CASE("A body that floats is said to", "[check]") {
    const auto body = [](const std::string& keys) {
        const Model model = read(replaced(body_deck, "[analysis]", "fluid = { " + keys + " }\n[analysis]") +
                                 water_deck.substr(0, 23))
                                .model;
        return describe_fluid(model, model.bodies.at(0));
    };
    CHECK(body("volume = 0.002, height = 0.1") ==
          "  in fluids: volume 0.002, 0.1 high, drag areas (0, 0, 0)\n  in water: displaced mass 2: it "
          "floats\n");
    CHECK_THAT(body("volume = 5e-4, drag_area = [1, 2, 3], drag_coefficient = 2"),
               Contains("drag areas (2, 4, 6)") && Contains("displaced mass 0.5\n"));
}

TEST_CASE("Water, waves, wind and ground are listed", "[check]") {
    CHECK_THAT(
        list(water_deck + "current = { table = [[-10, 1], [0, 3]], direction = [0, 2, 0] }\n"),
        Contains("water: density 1000, surface at z = 0; current 1 at z = -10 to 3 at z = 0, along (0, 1, "
                 "0)\n"));
    CHECK_THAT(list("[fluid]\ndensity = 2\ncurrent = { velocity = [\"z\", 0, 0] }\n"),
               Contains("water: density 2, everywhere; current by place and time\n"));
    // Deep water: λ = g T²/(2 π).
    CHECK_THAT(list(water_deck + "[[wave]]\nairy = { height = 2, period = 8 }\ndirection = [0, 1, 0]\n"),
               Contains("wave: height 2, period 8, number 0.0628") && Contains("length 99.92") &&
                   Contains("steepness 0.02, towards 90° from x"));
    CHECK_THAT(list(water_deck + "depth = 30\n[[wave]]\njonswap = { Hs = 4, Tp = 10 }\n"),
               Contains("30 deep for waves") &&
                   Contains("waves: 200 components, significant height 4, mean period"));
    CHECK_THAT(list("[air]\ndensity = 1.2\nwind = { velocity = [1, 0, 0] }\n"),
               Contains("air: density 1.2; wind by place and time\n"));
    CHECK_THAT(list("[seabed]\nz = -5\nstiffness = 7\nfriction = { axial = 0.3, lateral = 0.6 }\n"),
               Contains("ground: z = -5, stiffness 7, damping 0, friction 0.3 along and 0.6 across, sliding "
                        "after stiffness 7\n"));
    CHECK_THAT(list("[seabed]\nplane = { point = [1, 2, 3], normal = [0, 3, 4] }\nstiffness = 7\n"),
               Contains("ground: a plane through (1, 2, 3) across (0, 0.6, 0.8)") && Contains("no friction"));
}

}  // namespace gxrod::test
