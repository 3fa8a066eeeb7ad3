#include <cmath>

#include "deck/surroundings/surroundings_decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

const std::string air = "[air]\ndensity = 1.2\n";

Section section_of(const std::string& fluid) { return read(tube_deck(fluid) + air).model.sections.at(0); }

std::string with_shape(const std::string& shape, const std::string& fluid = "fluid = {}") {
    return replaced(tube_deck(fluid), "{ tube = { outer_radius = 0.25, inner_radius = 0.2 } }", shape) + air;
}

std::string without_shape(const std::string& fluid) {
    return replaced(static_rod_deck, "[rod.r]", fluid + "\n[rod.r]") + air;
}

// Two sections along a rod.
std::string two_sections(const std::string& first, const std::string& second) {
    const std::string start =
        "stiffness = { EA = 1e4, GAy = 2e4, GAz = 3e4, GJ = 500, EIy = 600, EIz = 700 }\n";
    return "[section.a]\n" + start + first + "[section.b]\n" + start + second +
           "[rod.r]\nsections = [[0, \"a\"], [1, \"b\"]]\nline = { from = [0, 0, 0], to = [8, 0, 0] }\n"
           "elements = 2\norder = 2\n[analysis]\nkind = \"static\"\n" +
           air;
}

}  // namespace

TEST_CASE("A section takes part with defaults and the size of its shape", "[deck]") {
    const SectionInFluid tube = *section_of("fluid = {}").fluid;
    CHECK(tube.diameter == 0.5);
    CHECK(tube.area == Approx(M_PI * 0.0625).epsilon(1e-15));
    CHECK(tube.drag == Vec3(0.0, 1.2, 1.2));
    CHECK(tube.added_mass == Vec3(0.0, 1.0, 1.0));
    CHECK(tube.contents_area == 0.0);
    CHECK(tube.poisson == 0.5);
    CHECK_FALSE(read(tube_deck("")).model.sections[0].fluid);
    const SectionInFluid circle = *read(with_shape("{ circle = { radius = 2 } }")).model.sections[0].fluid;
    CHECK(circle.diameter == 4.0);
    CHECK(circle.area == Approx(4.0 * M_PI));
    const std::string flat =
        with_shape("{ rectangle = { width_y = 2, height_z = 3 } }", "fluid = { outer_diameter = 3 }");
    CHECK(read(flat).model.sections[0].fluid->area == 6.0);
    CHECK(read(without_shape("fluid = { outer_diameter = 2 }")).model.sections[0].fluid->area ==
          Approx(M_PI));
}

TEST_CASE("Contents fill a tube and move with it", "[deck]") {
    const Section empty = section_of("fluid = {}");
    const Section full = section_of("fluid = { contents = { density = 900 } }");
    const double mass = 900.0 * M_PI * 0.04;
    CHECK(full.fluid->contents_area == Approx(M_PI * 0.04));
    const Mat6 added = full.mass - empty.mass;
    CHECK((added.diagonal().head<3>() - Vec3::Constant(mass)).norm() < 1e-12 * mass);
    CHECK(added.bottomRows<3>().isZero(0.0));
}

TEST_CASE("What water sees of a section varies along a rod", "[deck]") {
    const Model tapered = read(with_shape("{ circle = { radius = \"0.5 - 0.02*s\" } }",
                                          "fluid = { drag = { y = \"1 + s\" }, poisson = \"0.1 + 0.01*s\" }"))
                              .model;
    const auto& nodes = tapered.rods[0].varying.at_nodes;
    CHECK(nodes.at(1).fluid->diameter == Approx(2.0 * (0.5 - 0.02 * 2.5)));
    CHECK(nodes.at(1).fluid->drag == Vec3(0.0, 3.5, 1.2));
    CHECK(nodes.back().fluid->poisson == Approx(0.2));
    const Model mixed =
        read(two_sections("fluid = { outer_diameter = 1, drag = 1, contents = { density = 100, "
                          "inner_diameter = 0.5, pressure = 4 } }\n",
                          "fluid = { outer_diameter = 3, drag = 2, added_mass = 3, poisson = 0.3 }\n"))
            .model;
    const SectionInFluid& middle = *mixed.rods[0].varying.at_nodes.at(1).fluid;  // a quarter of the length
    CHECK(middle.diameter == Approx(1.5));
    CHECK(middle.area == Approx(0.25 * M_PI * (0.75 + 0.25 * 9.0)));
    CHECK(middle.drag == Vec3(0.0, 1.25, 1.25));
    CHECK(middle.added_mass == Vec3(0.0, 1.5, 1.5));
    CHECK(middle.contents_area == Approx(0.75 * M_PI * 0.0625));
    CHECK(middle.contents_density == Approx(75.0));
    CHECK(middle.contents_pressure == Approx(3.0));
    CHECK(middle.poisson == Approx(0.45));
    const Section& mean = mixed.sections[static_cast<std::size_t>(mixed.rods[0].section)];
    REQUIRE(mean.fluid);
    CHECK(mean.fluid->diameter == Approx(2.0));
    CHECK(mean.fluid->drag.y() == Approx(1.5));
    CHECK(mean.fluid->poisson == Approx(0.4));
}

TEST_CASE("What is wrong with a section in fluids is said where it stands", "[deck]") {
    CHECK_THAT(faults_of(without_shape("fluid = {}")),
               Contains("x.toml:4") && Contains("section.s.fluid.outer_diameter: missing"));
    CHECK_THAT(faults_of(with_shape("{ rectangle = { width_y = 2, height_z = 3 } }")),
               Contains("section.s.fluid.outer_diameter: missing; only a circle or a tube has one"));
    const auto fluid = [](const std::string& keys) {
        return faults_of(tube_deck("fluid = { " + keys + " }") + air);
    };
    CHECK_THAT(fluid("diameter = 1"), Contains("did you mean \"outer_diameter\"?"));
    CHECK_THAT(fluid("cd = 1"), Contains("did you mean \"drag\"?"));
    CHECK_THAT(fluid("outer_diameter = 0"), Contains("greater than 0"));
    CHECK_THAT(fluid("outer_diameter = \"1 - s\""),
               Contains("section.s.fluid.outer_diameter") && Contains("at s = 2.5 of rod.r"));
    CHECK_THAT(fluid("drag = { normal = 1, y = 2 }"), Contains("only one of them can be"));
    CHECK_THAT(fluid("drag = { tangential = 1, x = 2 }"), Contains("only one of them can be"));
    CHECK_THAT(fluid("drag = { normal = -1 }"), Contains("section.s.fluid.drag.normal"));
    CHECK_THAT(fluid("poisson = 0.6"), Contains("section.s.fluid.poisson"));
    CHECK_THAT(fluid("contents = { pressure = 1 }"), Contains("section.s.fluid.contents.density: missing"));
    CHECK_THAT(
        fluid("contents = { density = 1, inner_diameter = 0.6 }"),
        Contains("section.s.fluid.contents.inner_diameter: expected less than the outer diameter 0.5"));
    CHECK_THAT(faults_of(without_shape("fluid = { outer_diameter = 1, contents = { density = 1 } }")),
               Contains("section.s.fluid.contents.inner_diameter: missing"));
    CHECK_THAT(faults_of(two_sections("", "fluid = { outer_diameter = 3 }\n")),
               Contains("rod.r.sections: section \"b\" has `fluid` and \"a\" has not"));
}

TEST_CASE("A body in a fluid has the height of a sphere, if the deck says nothing", "[deck]") {
    const auto body = [](const std::string& keys) {
        return replaced(body_deck, "[analysis]", "fluid = { " + keys + " }\n[analysis]") + air;
    };
    const auto fluid = [&](const std::string& keys) { return *read(body(keys)).model.bodies.at(0).fluid; };
    const double radius = 0.5 * fluid("volume = 2").height;
    CHECK(4.0 / 3.0 * M_PI * radius * radius * radius == Approx(2.0));
    CHECK_THAT(faults_of(body("volume = 0")), Contains("body.top.fluid.height: missing"));
    CHECK_THAT(faults_of(body("height = 1")), Contains("body.top.fluid.volume: missing"));
    CHECK_THAT(faults_of(body("volume = 1, drag_area = [1, -1, 0]")),
               Contains("body.top.fluid.drag_area[1]"));
    const auto matrix = [&](const std::string& first, const std::string& second) {
        return faults_of(body("volume = 1, added_mass_matrix = [" + first + ", " + second +
                              ", [0,0,1,0,0,0], [0,0,0,1,0,0], [0,0,0,0,1,0], [0,0,0,0,0,1]]"));
    };
    CHECK(matrix("[1,0,0,0,0,0]", "[0,1,0,0,0,0]").empty());
    CHECK_THAT(matrix("[1,1,0,0,0,0]", "[0,1,0,0,0,0]"), Contains("expected a symmetric matrix"));
    CHECK_THAT(matrix("[1,2,0,0,0,0]", "[2,1,0,0,0,0]"), Contains("no eigenvalue below 0, found -1"));
}

TEST_CASE("Quantities of water and ground are for what takes part", "[deck]") {
    const auto faults = [](const std::string& deck, const std::string& quantity) {
        return faults_of(deck + "[[history]]\nname = \"h\"\nat = \"r.end\"\nquantities = \"" + quantity +
                         "\"\n");
    };
    CHECK(faults(tube_deck(""), "effective_tension").empty());
    for (const char* quantity : {"wall_tension", "water_velocity", "wet_fraction", "fluid_force"})
        CHECK(faults(tube_deck() + water_deck, quantity).empty());
    CHECK(faults(tube_deck() + "[seabed]\nz = 0\nstiffness = 1\n", "bed_force").empty());
    CHECK(faults(tube_deck() + air, "fluid_force").empty());
    for (const char* quantity : {"wall_tension", "water_velocity", "wet_fraction"})
        CHECK_THAT(faults(tube_deck() + air, quantity), Contains("the deck has no [fluid]"));
    CHECK_THAT(faults(tube_deck() + air, "bed_force"), Contains("the deck has no [seabed]"));
    CHECK_THAT(faults(tube_deck(""), "fluid_force"), Contains("the deck has no [fluid] and no [air]"));
    const std::string other =
        "[section.t]\nshape = { circle = { radius = 1 } }\nmaterial = { E = 1, nu = 0, "
        "density = 1 }\n[rod.q]\nsection = \"t\"\nline = { from = [0, 0, 1], to = [1, "
        "0, 1] }\nelements = 1\n";
    CHECK_THAT(faults_of(tube_deck() + water_deck + other +
                         "[[history]]\nname = \"h\"\nat = \"q.end\"\nquantities = \"wet_fraction\"\n"),
               Contains("the section of this rod has no `fluid`"));
    const auto of_body = [](const std::string& fluid, const std::string& quantity) {
        return faults_of(replaced(body_deck, "[analysis]", fluid + "[analysis]") + air +
                         "[section.s]\nshape = { circle = { radius = 1 } }\nmaterial = { E = 1, nu = 0, "
                         "density = 1 }\nfluid = {}\n[[history]]\nname = \"h\"\nat = \"top\"\nquantities = "
                         "\"" +
                         quantity + "\"\n");
    };
    CHECK(of_body("fluid = { volume = 1 }\n", "fluid_force").empty());
    CHECK_THAT(of_body("", "fluid_force"), Contains("this body has no `fluid`"));
    for (const char* quantity : {"effective_tension", "bed_force"})
        CHECK_THAT(of_body("fluid = { volume = 1 }\n", quantity), Contains("only points of rods have it"));
}

}  // namespace gxrod::test
