#include <cmath>

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// rod_deck with other lines in [section.s]; they begin in line 2.
std::string with_section(const std::string& lines) {
    const std::size_t first = rod_deck.find("stiffness");
    const std::size_t last = rod_deck.find("[rod.r]");
    return std::string(rod_deck).replace(first, last - first, lines);
}

Section section_of(const std::string& lines) { return read(with_section(lines)).model.sections.at(0); }

const std::string stiffness =
    "stiffness = { EA = 1e4, GAy = 2e4, GAz = 3e4, GJ = 500, EIy = 600, EIz = 700 }\n";
const std::string identity =
    "[[1,0,0,0,0,0],[0,1,0,0,0,0],[0,0,1,0,0,0],[0,0,0,1,0,0],[0,0,0,0,1,0],[0,0,0,0,0,1]]\n";

}  // namespace

TEST_CASE("rhoJ is the sum of the other rotary inertias by default", "[deck]") {
    CHECK(read(replaced(rod_deck, "rhoJ = 20, ", "")).model.sections[0].mass(3, 3) == 21.0);
}

TEST_CASE("A shape and a material make a section", "[deck]") {
    const Section wire =
        section_of("shape = { circle = { radius = 0.1 } }\nmaterial = { E = 200, nu = 0.25, density = 3 }\n");
    const double area = M_PI * 0.01, I = M_PI * 1e-4 / 4.0;
    Vec6 expected;
    const double GA = 80.0 * area * 6.0 / 7.04;  // n = 0.2
    expected << 200.0 * area, GA, GA, 80.0 * 2.0 * I, 200.0 * I, 200.0 * I;
    CHECK(wire.stiffness.isApprox(Mat6(expected.asDiagonal()), 1e-14));
    expected << 3 * area, 3 * area, 3 * area, 6 * I, 3 * I, 3 * I;
    CHECK(wire.mass.isApprox(Mat6(expected.asDiagonal()), 1e-14));
    CHECK(wire.kelvin_voigt == 0.0);
    CHECK(wire.mass_proportional == 0.0);
}

TEST_CASE("A beam of the vibrating Timoshenko cantilever has its published constants", "[deck]") {
    // A steel rectangle 0.05 (y) × 0.1 (z) with k = 5/6.
    const Section beam = section_of(
        "shape = { rectangle = { width_y = 0.05, height_z = 0.1 } }\n"
        "material = { E = 2.1e11, nu = 0.3, density = 7850, shear_factor = \"5/6\" }\n");
    const double G = 2.1e11 / 2.6;
    CHECK(beam.stiffness(0, 0) == Approx(1.05e9));
    CHECK(beam.stiffness(1, 1) == Approx(5.0 / 6.0 * G * 0.005));
    CHECK(beam.stiffness(2, 2) == beam.stiffness(1, 1));
    CHECK(beam.stiffness(3, 3) == Approx(G * 2.8585e-6).epsilon(1e-4));
    CHECK(beam.stiffness(4, 4) == Approx(875000.0));
    CHECK(beam.stiffness(5, 5) == Approx(218750.0));
    CHECK(beam.mass(0, 0) == Approx(39.25));
    CHECK(beam.mass(3, 3) == Approx(7850.0 * (4.1666667e-6 + 1.0416667e-6)));
    CHECK(beam.mass(4, 4) == Approx(7850.0 * 4.1666667e-6));
    CHECK(beam.mass(5, 5) == Approx(7850.0 * 1.0416667e-6));
}

TEST_CASE("The square section of the 45 degree bend has its published constants", "[deck]") {
    const Section square = section_of(
        "shape = { rectangle = { width_y = 1, height_z = 1 } }\n"
        "material = { E = 1e7, G = 5e6, density = 1, shear_factor = 1 }\n");
    Vec6 expected;
    expected << 1e7, 5e6, 5e6, 5e6 * 0.140577014955, 1e7 / 12.0, 1e7 / 12.0;
    CHECK((square.stiffness.diagonal() - expected).cwiseQuotient(expected).cwiseAbs().maxCoeff() < 1e-11);
}

TEST_CASE("G means E/(2(1 + nu)), also in the shear factor", "[deck]") {
    const std::string shape = "shape = { tube = { outer_radius = 2, inner_radius = 1 } }\n";
    const Section by_nu = section_of(shape + "material = { E = 260, nu = 0.3, density = 1 }\n");
    const Section by_G = section_of(shape + "material = { E = 260, G = 100, density = 1 }\n");
    CHECK(by_G.stiffness.isApprox(by_nu.stiffness, 1e-14));
    CHECK(faults_of(with_section(shape + "material = { E = 260, G = 80, density = 1 }\n")) ==
          "x.toml:3:27: section.s.material.G: with E = 260 it means nu = 0.625, above 0.5, for which "
          "there is no shear factor; expected a greater G, or shear_factor");
    CHECK(section_of(shape + "material = { E = 260, G = 80, density = 1, shear_factor = 0.5 }\n")
              .stiffness(1, 1) == Approx(40.0 * M_PI * 3.0));
    // Incompressible.
    CHECK_NOTHROW(section_of(shape + "material = { E = 300, G = 100, density = 1 }\n"));
}

TEST_CASE("Messages explain shear factors and name the one that a section has", "[deck]") {
    const auto note = [](const std::string& shape, const std::string& material) {
        return read(with_section("shape = { " + shape + " }\nmaterial = { density = 1, " + material + " }\n"))
            .notes.at(0);
    };
    const std::string meaning = "section.s: shear stiffness is shear_factor G A; ";
    CHECK(note("tube = { outer_radius = 0.3, inner_radius = 0.1 }", "E = 73e9, nu = 0.33") ==
          meaning + "shear_factor follows from the exact flexure at nu = 0.33, 0.678779 along y and z");
    CHECK(
        note("rectangle = { width_y = 2, height_z = 1 }", "E = 1, nu = 0.3") ==
        meaning +
            "shear_factor follows from the exact flexure at nu = 0.3, 0.832942 along y and 0.784442 along z");
    CHECK(note("circle = { radius = 1 }", "E = 1, nu = 0, shear_factor = 1") ==
          meaning + "shear_factor 1 is given, where the exact flexure at nu = 0 has 0.857143 along y and z");
    CHECK(note("circle = { radius = 1 }", "E = 4, G = 1, shear_factor = 1") ==
          meaning + "shear_factor 1 is given");
}

TEST_CASE("A section can be matrices", "[deck]") {
    const Section section = section_of(
        "stiffness_matrix = [\n"
        "  [1e6,   0,   0,   0,   0,   0],\n"
        "  [  0, 4e5,   0,   0,   0,   0],\n"
        "  [  0,   0, 4e5,   0,   0,   0],\n"
        "  [  0,   0,   0,  50,  10,   0],\n"
        "  [  0,   0,   0,  10,  80,   0],\n"
        "  [  0,   0,   0,   0,   0, \"30^2\"]]\n"
        "mass_matrix = [\n"
        "  [2.0,   0,   0,    0,    0,    0],\n"
        "  [  0, 2.0,   0,    0,    0,  0.1],\n"
        "  [  0,   0, 2.0,    0, -0.1,    0],\n"
        "  [  0,   0,   0, 0.03,    0,    0],\n"
        "  [  0,   0, -0.1,   0, 0.02,    0],\n"
        "  [  0, 0.1,   0,    0,    0, 0.02]]\n");
    CHECK(section.stiffness(3, 4) == 10.0);
    CHECK(section.stiffness(5, 5) == 900.0);
    CHECK(section.mass(1, 5) == 0.1);
    CHECK(section.mass(4, 2) == -0.1);
}

TEST_CASE("A section's matrices are refused with their entry", "[deck]") {
    CHECK(
        faults_of(with_section("stiffness_matrix = " + replaced(identity, "[0,1,", "[0.5,1,") +
                               "mass_matrix = " + identity)) ==
        "x.toml:2:20: section.s.stiffness_matrix[1][0]: expected a symmetric matrix, found 0.5 here and 0 at "
        "[0][1]");
    CHECK(faults_of(with_section(stiffness + "mass_matrix = " + replaced(identity, "[0,0,1", "[0,0,4"))) ==
          "x.toml:3:15: section.s.mass_matrix[2][2]: expected 1 as in the inertia of a rigid slice, [m 1, −m "
          "[d]×; m [d]×, J], found 4");
}

TEST_CASE("A section has one kind of stiffness and one of inertia", "[deck]") {
    const std::string inertia = "inertia = { rhoA = 1, rhoIy = 1, rhoIz = 1 }\n";
    const std::string shape = "shape = { circle = { radius = 1 } }\n";
    const std::string material = "material = { E = 1, nu = 0, density = 1 }\n";
    CHECK(faults_of(with_section(inertia)) ==
          "x.toml:1:1: section.s: missing; expected stiffness = { … } or stiffness_matrix or shape = { … }");
    CHECK(faults_of(with_section(stiffness + shape + material)) ==
          "x.toml:3:1: section.s.shape: stiffness is given too; only one of them can be");
    CHECK(faults_of(with_section(stiffness + inertia + "mass_matrix = " + identity)) ==
          "x.toml:4:1: section.s.mass_matrix: inertia is given too; only one of them can be");
    CHECK(faults_of(with_section(shape)) ==
          "x.toml:1:1: section.s.material: missing; expected the name of a material, or a table "
          "material = { … }");
    CHECK(faults_of(with_section(shape + material + inertia)) ==
          "x.toml:3:1: section.s.material: inertia is given too; only one of them can be");
    CHECK(faults_of(with_section(stiffness + material)) ==
          "x.toml:3:1: section.s.material: goes with shape, and this table has stiffness");
    CHECK(faults_of(with_section(
              "shape = { circle = { radius = 1 }, tube = { outer_radius = 2, inner_radius = 1 } }\n" +
              material)) ==
          "x.toml:2:36: section.s.shape.tube: circle is given too; only one of them can be");
    CHECK(faults_of(with_section(shape + "material = { E = 1, nu = 0, G = 1, density = 1 }\n")) ==
          "x.toml:3:29: section.s.material.G: nu is given too; only one of them can be");
    CHECK(faults_of(with_section(shape + "material = { E = 1, density = 1 }\n")) ==
          "x.toml:3:12: section.s.material: missing; expected nu or G");
}

TEST_CASE("Shapes and materials have ranges", "[deck]") {
    const std::string material = "material = { E = 1, nu = 0, density = 1 }\n";
    CHECK(faults_of(with_section("shape = { tube = { outer_radius = 2, inner_radius = 2 } }\n" + material)) ==
          "x.toml:2:53: section.s.shape.tube.inner_radius: expected less than outer_radius = 2, found 2");
    CHECK(faults_of(with_section("shape = { circle = { radius = 0 } }\n" + material)) ==
          "x.toml:2:31: section.s.shape.circle.radius: expected a number greater than 0, found 0");
    const std::string shape = "shape = { circle = { radius = 1 } }\n";
    CHECK(faults_of(with_section(shape + "material = { E = 1, nu = 0.51, density = 1 }\n")) ==
          "x.toml:3:26: section.s.material.nu: expected a number greater than -1, at most 0.5, found 0.51");
    CHECK(faults_of(with_section(shape + "material = { E = 1, nu = -1, density = 1 }\n")) ==
          "x.toml:3:26: section.s.material.nu: expected a number greater than -1, at most 0.5, found -1");
    CHECK(faults_of(replaced(rod_deck, "[rod.r]", "damping = { kelvin_voigt = -1e-3 }\n[rod.r]")) ==
          "x.toml:4:28: section.s.damping.kelvin_voigt: expected a number at least 0, found -0.001");
}

TEST_CASE("A dynamic analysis needs inertia, of rotations too", "[deck]") {
    CHECK(faults_of(with_section(stiffness)) ==
          "x.toml:1:1: section.s.inertia: missing; a dynamic analysis needs inertia = { … } or mass_matrix");
    CHECK(faults_of(with_section("shape = { circle = { radius = 1 } }\nmaterial = { E = 1, nu = 0 }\n")) ==
          "x.toml:3:12: section.s.material.density: missing; a dynamic analysis needs the mass of the rods");
    const std::string no_inertia = "; a rotation without inertia cannot be integrated in time";
    CHECK(faults_of(with_section(stiffness + "inertia = { rhoA = 1, rhoIz = 1 }\n")) ==
          "x.toml:3:11: section.s.inertia.rhoIy: missing; expected a number greater than 0 or an expression "
          "in s" +
              no_inertia);
    CHECK(faults_of(with_section(stiffness + "inertia = { rhoA = 1, rhoIy = 0, rhoIz = 1 }\n")) ==
          "x.toml:3:31: section.s.inertia.rhoIy: expected a number greater than 0, found 0" + no_inertia);
}

TEST_CASE("A static analysis can do without inertia, or with mass alone", "[deck]") {
    const std::string inertia = "inertia = { rhoA = 1.0, rhoJ = 20, rhoIy = 10, rhoIz = 11 }\n";
    const Problem without = read(replaced(static_rod_deck, inertia, ""));
    CHECK(without.model.sections[0].mass.isZero(0.0));
    CHECK(without.notes.size() == 1);
    const Section heavy =
        read(replaced(static_rod_deck, inertia, "inertia = { rhoA = 3 }\n")).model.sections[0];
    CHECK(heavy.mass.diagonal().head<3>() == Vec3(3, 3, 3));
    CHECK(heavy.mass.diagonal().tail<3>().isZero(0.0));
    const std::string first = static_rod_deck.substr(static_rod_deck.find("stiffness"));
    const std::string shape = "shape = { circle = { radius = 1 } }\nmaterial = { E = 1, nu = 0 }\n";
    CHECK(read(replaced(static_rod_deck, first.substr(0, first.find("[rod.r]")), shape))
              .model.sections[0]
              .mass.isZero(0.0));
    CHECK(faults_of(replaced(static_rod_deck, "rhoIy = 10", "rhoIy = 0")) ==
          "x.toml:3:44: section.s.inertia.rhoIy: expected a number greater than 0, found 0; a rotation "
          "without inertia "
          "cannot be integrated in time");
}

TEST_CASE("That gravity has nothing to act on is in the notes", "[deck]") {
    const std::string deck = replaced("gravity = [0, 0, -9.81]\n" + static_rod_deck,
                                      "inertia = { rhoA = 1.0, rhoJ = 20, rhoIy = 10, rhoIz = 11 }\n",
                                      "");
    CHECK(read(deck).notes.front() == "section.s: no inertia, so that gravity does not act on it");
}

}  // namespace gxrod::test
