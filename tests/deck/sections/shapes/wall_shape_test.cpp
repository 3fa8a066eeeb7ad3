#include <cmath>
#include <numbers>

#include "cross_section/cross_section.hpp"
#include "deck/decks.hpp"
#include "tools/catch.hpp"

// Sections of walls of plies, and of meshes, from decks.
namespace gxrod::test {
namespace {

using std::numbers::pi;

// The box of benchmark X10. Lines 1 to 9.
const std::string box_deck = R"deck([material.carbon]
E = [20.59e6, 1.42e6]
G = [0.87e6, 0.87e6, 0.696e6]
nu = [0.30, 0.30, 0.34]
density = 2.0
[layup.skin]
plies = [["carbon", 0.005, "pi/12", 6]]
[section.s]
shape = { walls = { corners = [[-0.4765, -0.265], [0.4765, -0.265], [0.4765, 0.265], [-0.4765, 0.265]], closed = true, line = "right", layup = "skin" } }
)deck";

// A circle in two groups by Gmsh (tests/mesh/section_file_test). Lines 1 to 8.
const std::string circle_deck = R"deck([material.steel]
E = 210e9
nu = 0.3
density = 7850
[material.foam]
E = 210e9
G = 80769230769.23077
density = 7850
)deck";

const std::string rest = R"deck([rod.r]
section = "s"
line = { from = [0, 0, 0], to = [10, 0, 0] }
elements = 2
[[support]]
at = "r.start"
fix = "all"
[analysis]
kind = "static"
)deck";

std::string circle(const std::string& mesh, const std::string& file = "ring_triangles_3.msh") {
    return circle_deck +
           "[section.s]\nshape = { mesh = { file = \"" GXROD_SOURCE_DIR "/tests/mesh/section_files/" + file +
           "\", " + mesh + " } }\n" + rest;
}

std::string box(const std::string& from, const std::string& to) {
    return replaced(box_deck, from, to) + rest;
}

double find_error(const Mat6& K, int row, int column, double value) {
    return std::abs(K(row, column) - value) / std::sqrt(K(row, row) * K(column, column));
}

}  // namespace

TEST_CASE("walls of plies from a deck have the reference stiffness, benchmark X10", "[deck][sections]") {
    const Problem problem = read(box_deck + rest);
    const Section& section = problem.model.sections[0];
    CHECK(find_error(section.stiffness, 0, 0, 1437379.5) < 1e-4);
    CHECK(find_error(section.stiffness, 0, 3, 107400.6) < 1e-4);
    CHECK(find_error(section.stiffness, 1, 4, -52009.6) < 1e-4);
    CHECK(find_error(section.stiffness, 2, 5, -56335.0) < 1e-4);
    CHECK(find_error(section.stiffness, 5, 5, 172493.4) < 1e-4);
    CHECK(section.mass(0, 0) == Approx(2.0 * (0.953 * 0.53 - 0.893 * 0.47)).epsilon(1e-12));
    REQUIRE(section.shape);
    CHECK(section.shape->source == "walls");
    CHECK(section.shape->mesh.layers.size() == 6);
    CHECK(section.shape->mesh.layers[5].name == "skin ply 5");
    CHECK(section.shape->materials[0].name == "carbon");
    // A layup for each side is the same.
    const Problem by_side = read(box("layup = \"skin\"", "layup = [\"skin\", \"skin\", \"skin\", \"skin\"]"));
    CHECK((by_side.model.sections[0].stiffness - section.stiffness).norm() < 1e-9 * section.stiffness.norm());
}

TEST_CASE("materials have what a deck says", "[deck][sections]") {
    const Problem problem = read(box("density = 2.0",
                                     "density = 2.0\nexpansion = [1e-6, 2e-5]\n"
                                     "strength = { Xt = 1, Xc = 2, Yt = 3, Yc = 4, S12 = 5, S23 = 6 }"));
    const ElasticMaterial& carbon = problem.model.sections[0].shape->materials[0];
    REQUIRE(carbon.strength);
    CHECK(carbon.strength->S23 == 6.0);
    CHECK(carbon.strength->f12 == -0.5);
    CHECK(carbon.expansion[0] == 1e-6);
    CHECK(carbon.expansion[2] == 2e-5);
    CHECK_FALSE(carbon.is_isotropic);
    // G23 by transverse isotropy.
    const Problem short_of_G = read(box("[0.87e6, 0.87e6, 0.696e6]", "0.87e6"));
    CHECK(short_of_G.model.sections[0].shape->materials[0].stiffness(3, 3) ==
          Approx(1.42e6 / 2.68).epsilon(1e-12));
}

TEST_CASE("a mesh from a file is a section of its groups, in the deck's lengths", "[deck][sections]") {
    const std::string groups =
        "scale = 0.1, groups = { ring = { material = \"steel\", along = \"outline\" }, core = { material = "
        "\"foam\" } }";
    const Problem problem = read(circle(groups));
    const Section& section = problem.model.sections[0];
    // Both materials are steel, so that it is a circle: but for its coarse outline.
    CHECK(section.stiffness(0, 0) == Approx(210e9 * pi * 0.01).epsilon(5e-4));
    CHECK(section.stiffness(3, 3) == Approx(210e9 / 2.6 * pi / 2 * 1e-4).epsilon(1e-3));
    CHECK(section.mass(0, 0) == Approx(7850 * pi * 0.01).epsilon(5e-4));
    CHECK(section.shape->mesh.layers[0].name == "ring");
    const Problem whole = read(circle("scale = 0.1, material = \"steel\""));
    CHECK((whole.model.sections[0].stiffness - section.stiffness).norm() < 1e-9 * section.stiffness.norm());
    // Its bytes are kept with the run.
    CHECK(problem.record.meshes.size() == 1);
}

TEST_CASE("materials that cannot be are refused", "[deck][sections]") {
    const auto fault = [](const std::string& from, const std::string& to) {
        return faults_of(box(from, to));
    };
    CHECK(fault("nu = [0.30, 0.30, 0.34]", "nu = [4, 0.3, 0.34]") ==
          "x.toml:4:6: material.carbon.nu: the material is not positive definite: nu12 = 4 is more than "
          "√(E1/E2) = "
          "3.81");
    CHECK(
        fault("nu = [0.30, 0.30, 0.34]", "nu = [0.3, 0.34]") ==
        "x.toml:4:6: material.carbon.nu: expected [nu12, nu13, nu23], or one number for all three, as E has "
        "numbers by axis");
    CHECK(fault("E = [20.59e6, 1.42e6]", "E = 20.59e6") ==
          "x.toml:2:5: material.carbon.E: expected [E1, E2, E3], or [E1, E2] for E3 = E2, as G or nu has "
          "numbers "
          "by axis");
    CHECK(fault("E = [20.59e6, 1.42e6]", "E = [1, 2, 3, 4]") ==
          "x.toml:2:5: material.carbon.E: expected a number greater than 0 or an expression, or an array of "
          "up to "
          "3 of them, found an array of 4");
    CHECK(fault("G = [0.87e6, 0.87e6, 0.696e6]\n", "") ==
          "x.toml:1:1: material.carbon.G: missing; expected [G12, G13, G23], of which G13 and G23 can be "
          "left out, "
          "as E has numbers by axis");
    CHECK(fault("1.42e6]\nG = [0.87e6, 0.87e6, 0.696e6]", "1.42e6, 1.5e6]\nG = 0.87e6") ==
          "x.toml:3:5: material.carbon.G: expected [G12, G13, G23]: without G23 = E2/(2(1 + nu23)), as E2 "
          "and E3 "
          "differ");
    CHECK(faults_of(replaced(circle("material = \"steel\""), "nu = 0.3", "nu = 0.5")) ==
          "x.toml:3:6: material.steel.nu: nu = 0.5; expected more than -1 and at most 0.4999");
    CHECK(faults_of(replaced(circle("material = \"steel\""), "nu = 0.3\n", "")) ==
          "x.toml:1:1: material.steel.nu: missing; expected nu or G, or arrays by axis of E, G and nu");
    CHECK(faults_of(replaced(circle("material = \"steel\""), "nu = 0.3", "nu = 0.3\nG = 8e10")) ==
          "x.toml:4:5: material.steel.G: nu is given too; an isotropic material has one of them");
}

TEST_CASE("layups and walls that cannot be are refused", "[deck][sections]") {
    const auto fault = [](const std::string& from, const std::string& to) {
        return faults_of(box(from, to));
    };
    CHECK(fault("\"carbon\"", "\"carbom\"") ==
          "x.toml:7:11: layup.skin.plies[0][0]: no material \"carbom\"; did you mean \"carbon\"?");
    CHECK(fault("0.005", "0") == "x.toml:7:21: layup.skin.plies[0][1]: the thickness is zero");
    CHECK(fault("0.005", "-1") ==
          "x.toml:7:21: layup.skin.plies[0][1]: expected a thickness greater than 0, found -1");
    CHECK(fault("\"pi/12\", 6", "\"pi/12\", 1.5") ==
          "x.toml:7:37: layup.skin.plies[0][3]: expected an integer: how many times the ply is there, found "
          "1.5");
    CHECK(fault("[\"carbon\", 0.005, \"pi/12\", 6]", "[\"carbon\"]") ==
          "x.toml:7:10: layup.skin.plies[0]: expected a ply [\"material\", thickness, angle, times], of "
          "which angle "
          "and times can be left out, found an array of 1");
    CHECK(fault("layup = \"skin\"", "layup = \"web\"") ==
          "x.toml:9:144: section.s.shape.walls.layup: no layup \"web\"; the deck has skin");
    CHECK(fault("layup = \"skin\"", "layup = [\"skin\", \"skin\"]") ==
          "x.toml:9:144: section.s.shape.walls.layup: expected one for each of the 4 sides, found 2");
    CHECK(fault("[0.4765, 0.265]", "[0.4765, -0.265]") ==
          "x.toml:9:69: section.s.shape.walls.corners[2]: is at the same place as corners[1]");
    CHECK(fault("0.005", "0.05") ==
          "x.toml:9:31: section.s.shape.walls.corners: side 1 from corners[1] to corners[2] is 0.53 long, "
          "shorter "
          "than its mitres, which take 0.6");
    CHECK(fault("0.005", "5") ==
          "x.toml:9:144: section.s.shape.walls.layup: a ply of \"skin\" is 5 thick in a wall whose longest "
          "side is "
          "0.953: are both in one unit?");
    CHECK(fault("layup = \"skin\" } }", "layup = \"skin\" } }\nmaterial = { E = 1, nu = 0 }") ==
          "x.toml:10:12: section.s.material: walls and meshes have materials of their own, [material.NAME]");
}

TEST_CASE("meshes whose groups do not fit are refused", "[deck][sections]") {
    const auto fault = [](const std::string& mesh) {
        const std::string text = faults_of(circle(mesh));
        return text.substr(text.find("section.s"));
    };
    CHECK(fault("groups = { ring = { material = \"steel\" } }") ==
          "section.s.shape.mesh.groups: the group \"core\" of the file has no material here");
    CHECK(fault("groups = { ring = { material = \"steel\" }, cor = { material = \"foam\" } }")
              .ends_with(
                  "section.s.shape.mesh.groups.cor: no physical group \"cor\" of surfaces in the file; did "
                  "you mean \"core\"?"));
    CHECK(fault("groups = { ring = { material = \"steel\", along = \"edge\" }, core = { material = \"foam\" "
                "} }") ==
          "section.s.shape.mesh.groups.ring.along: no physical group \"edge\" of curves in the file; the "
          "file has "
          "outline");
    CHECK(fault("groups = { ring = { material = \"steel\" }, core = { material = \"wood\" } }") ==
          "section.s.shape.mesh.groups.core.material: no material \"wood\"; the deck has steel, foam");
    CHECK(fault("scale = 1") ==
          "section.s.shape.mesh: missing; expected groups = { NAME = { … } } or material");
    const std::string text = faults_of(circle("material = \"steel\"", "none.msh"));
    CHECK(text.find("none.msh: cannot be read") != std::string::npos);
}

TEST_CASE("materials and layups that nothing has are noted", "[deck][sections]") {
    const auto notes = [](const std::string& deck) {
        std::string text;
        for (const std::string& note : read(deck).notes) text += note + "\n";
        return text;
    };
    CHECK(notes(box_deck + rest).find("no section has it") == std::string::npos);
    const std::string more = "[layup.web]\nplies = [[\"carbon\", 1]]\n[material.iron]\nE = 1\nnu = 0\n";
    const std::string idle = notes(more + box_deck + rest);
    CHECK(idle.find("layup.web: no section has it\nmaterial.iron: no layup and no section has it\n") !=
          std::string::npos);
}

TEST_CASE("a section on cells without density has no mass", "[deck][sections]") {
    const std::string dynamic = replaced(
        box("density = 2.0\n", ""), "kind = \"static\"", "kind = \"dynamic\"\nend_time = 1\nsteps = 2");
    CHECK(faults_of(dynamic) ==
          "x.toml:8:9: section.s.shape: its materials have no density; a dynamic analysis needs the mass of "
          "the "
          "rods");
}

}  // namespace gxrod::test
