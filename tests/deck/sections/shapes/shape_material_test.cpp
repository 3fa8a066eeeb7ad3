#include "deck/sections/shapes/shape_material.hpp"

#include "cross_section/cross_section.hpp"
#include "deck/decks.hpp"
#include "tools/catch.hpp"

// Materials by name of sections with a shape.
namespace gxrod::test {
namespace {

using Catch::Contains;

const std::string rest = R"deck([rod.r]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 2
[[support]]
at = "r.start"
fix = "all"
[analysis]
kind = "static"
)deck";

const std::string numbers = "E = 2.1e11, nu = 0.3, density = 7850, yield_stress = 235e6, expansion = 12e-6";

std::string steel_table() {
    std::string text = "[material.steel]\n" + numbers + "\n";
    for (std::size_t at = text.find(", "); at != std::string::npos; at = text.find(", "))
        text.replace(at, 2, "\n");
    return text;
}

std::string inline_deck(const std::string& shape) {
    return "units = \"m, N\"\n[section.s]\nshape = { " + shape + " }\nmaterial = { " + numbers + " }\n" +
           rest;
}

std::string named_deck(const std::string& shape, const std::string& material = steel_table()) {
    return "units = \"m, N\"\n" + material + "[section.s]\nshape = { " + shape +
           " }\nmaterial = \"steel\"\n" + rest;
}

}  // namespace

TEST_CASE("A material by its name is the same as its numbers in the section", "[deck][sections]") {
    for (const std::string shape : {"circle = { radius = 0.05 }",
                                    "tube = { outer_radius = 0.05, inner_radius = 0.04 }",
                                    "rectangle = { width_y = 0.1, height_z = 0.2 }",
                                    "box = { height = 0.2, width = 0.1, wall = 0.01 }"}) {
        INFO(shape);
        const Problem given = read(inline_deck(shape)), named = read(named_deck(shape));
        for (std::size_t i = 0; i < given.model.sections.size(); ++i) {
            const Section &a = given.model.sections[i], &b = named.model.sections[i];
            CHECK(a.stiffness == b.stiffness);
            CHECK(a.mass == b.mass);
            CHECK(b.expansion == 12e-6);
            REQUIRE((a.law != nullptr) == (b.law != nullptr));
            if (a.law) CHECK(a.law->describe() == b.law->describe());
        }
        CHECK(given.notes == named.notes);
    }
}

TEST_CASE("A material that stays elastic makes no law", "[deck][sections]") {
    const std::string circle = "circle = { radius = 0.05 }";
    CHECK(read(named_deck(circle)).model.sections[0].law != nullptr);
    CHECK(read(named_deck(circle, steel_table() + "elastic = true\n")).model.sections[0].law == nullptr);
    CHECK(faults_of(named_deck(circle, steel_table() + "elastic = true\ninteraction = true\n"))
              .ends_with("material.steel.elastic: interaction is given too; only one of them can be"));
}

TEST_CASE("An override reaches a material by its name", "[deck][sections]") {
    const std::string deck = named_deck("box = { height = 0.2, width = 0.1, wall = 0.01 }");
    const Mat6 stiff = read(deck, {"material.steel.E=4.2e11"}).model.sections[0].stiffness;
    const Mat6 soft = read(deck).model.sections[0].stiffness;
    CHECK((stiff - 2.0 * soft).norm() < 1e-9 * stiff.norm());
}

TEST_CASE("An orthotropic material has the axes of its section", "[deck][sections]") {
    const std::string wood =
        "[material.steel]\nE = [12e9, 0.8e9, 0.4e9]\nG = [0.7e9, 0.6e9, 0.06e9]\nnu = [0.4, 0.45, 0.3]\n"
        "density = 450\nexpansion = [4e-6, 30e-6, 40e-6]\n";
    const Problem problem = read(named_deck("rectangle = { width_y = 0.1, height_z = 0.2 }", wood));
    const Section& section = problem.model.sections[0];
    CHECK(section.stiffness(0, 0) == Approx(12e9 * 0.02).epsilon(1e-9));
    CHECK(section.stiffness(4, 4) == Approx(12e9 * 0.1 * 0.008 / 12.0).epsilon(1e-9));
    CHECK(section.mass(0, 0) == Approx(450 * 0.02));
    CHECK(section.expansion == 4e-6);
    // Saint-Venant's torsion with G13 = 0.6e9 against xz and G12 = 0.7e9 against xy is that of an isotropic
    // rectangle, G = 0.6e9, whose height is √(0.7/0.6) times as long; times √(0.6/0.7).
    const Problem scaled =
        read(replaced(named_deck("rectangle = { width_y = 0.1, height_z = 0.21602468994692867 }",
                                 "[material.steel]\nE = 1.5e9\nG = 0.6e9\n"),
                      "kind = \"static\"",
                      "kind = \"static\""));
    CHECK(section.stiffness(3, 3) ==
          Approx(scaled.model.sections[0].stiffness(3, 3) * std::sqrt(0.6 / 0.7)).epsilon(1e-4));
}

TEST_CASE("What is wrong with a material by its name is said with its place", "[deck][sections]") {
    const std::string box = "box = { height = 0.2, width = 0.1, wall = 0.01 }";
    CHECK_THAT(faults_of(replaced(named_deck(box), "\"steel\"", "\"stel\"")),
               Contains("section.s.material: no material \"stel\"; did you mean \"steel\"?"));
    CHECK_THAT(faults_of(replaced(named_deck("circle = { radius = 1 }", ""), "\"steel\"", "\"stel\"")),
               Contains("section.s.material: no material \"stel\"; the deck has no [material.NAME]"));
    CHECK_THAT(
        faults_of(replaced(named_deck("circle = { radius = 1 }"), "\"steel\"", "3")),
        Contains(
            "section.s.material: expected the name of a material, or a table material = { … }, found 3"));
    CHECK_THAT(faults_of(replaced(
                   named_deck(box), "material = \"steel\"", "material = \"steel\"\nexpansion = 1e-5")),
               Contains("section.s.expansion: its material has one too; only one of them can be given"));
    CHECK_THAT(faults_of(replaced(named_deck("circle = { radius = 1 }", "[material.steel]\nE = 1\nnu = 0\n"),
                                  "kind = \"static\"",
                                  "kind = \"dynamic\"\nend_time = 1\nsteps = 2")),
               Contains("material.steel.density: missing; a dynamic analysis needs the mass of the rods"));
    const Problem idle =
        read(named_deck("circle = { radius = 1 }", steel_table() + "[material.other]\nE = 1\nnu = 0\n"));
    CHECK_THAT(idle.notes.front(), Contains("material.other: no layup and no section has it"));
}

}  // namespace gxrod::test
