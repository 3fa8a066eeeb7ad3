#include "check/findings/plausibility.hpp"

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

std::vector<std::string> ask(const std::string& deck) {
    const Problem problem = read(deck);
    std::vector<std::string> questions = problem.notes;
    for (const Finding& question : question_model(problem.model, problem.stages)) {
        CHECK(question.severity == Severity::note);
        questions.push_back(question.message);
    }
    return questions;
}

const std::string clamps =
    "[[support]]\nat = \"r.start\"\nfix = \"all\"\n[[support]]\nat = \"r.end\"\nfix = \"all\"\n";

// A steel rod of 1 m, clamped at both ends.
std::string make_deck(const std::string& section, const std::string& rest) {
    return "[section.s]\nshape = { circle = { radius = 0.01 } }\n" + section +
           "[rod.r]\nsection = \"s\"\nline = { from = [0, 0, 0], to = [1, 0, 0] }\ny_axis = [0, 1, 0]\n"
           "elements = 2\norder = 2\n" +
           clamps + rest;
}

const std::string steel = "material = { E = 2.1e11, nu = 0.3, density = 7850, shear_factor = 0.9 }\n";
const std::string fluid = "fluid = { drag = 1, added_mass = 1 }\n";
const std::string statics = "[analysis]\nkind = \"static\"\n";
const std::string dynamics = "[analysis]\nkind = \"dynamic\"\nend_time = 1\nsteps = 100\n";

void check_asked(const std::string& right, const std::string& wrong, const std::string& question) {
    for (const std::string& one : ask(right)) CHECK_THAT(one, Contains("shear_factor"));
    bool is_asked = false;
    for (const std::string& one : ask(wrong)) is_asked = is_asked || one.find(question) != std::string::npos;
    INFO(question);
    CHECK(is_asked);
}

}  // namespace

TEST_CASE("A model under its ground, or in water of another unit, is asked about", "[check]") {
    const auto deck = [](const std::string& z, const std::string& density) {
        return make_deck(
            steel + fluid,
            "[fluid]\ndensity = " + density + "\n[seabed]\nstiffness = 1e5\nz = " + z + "\n" + statics);
    };
    // What lies on the ground, half a diameter in it, is not under it.
    check_asked(deck("0.01", "1025"),
                deck("10", "1025"),
                "the whole model is under the ground of [seabed], by 10 or");
    check_asked(
        deck("-5", "1025"), deck("-5", "1.025"), "the density of [fluid], 1.025, is 1/7.66e+03 of that of");
}

TEST_CASE("An obstacle of another unit than the model is asked about with both boxes", "[check]") {
    const auto deck = [](const std::string& obstacle) {
        return make_deck(steel + "radius = 0.01\n", "[contact]\n[obstacle.o]\n" + obstacle + statics);
    };
    const std::string ball = "sphere = { centre = [0, 0, -1], radius = 0.5 }\n";
    check_asked(deck(ball),
                deck("sphere = { centre = [0, 0, -1001], radius = 1000 }\n"),
                "obstacle o is 2e+03 times as large as the model: its box is (-1000, -1000, -2001) to (1000, "
                "1000, -1), "
                "the model's (0, 0, 0) to (1, 0, 0)");
    check_asked(deck("cylinder = { from = [0, -500, -1], to = [0, 500, -1], radius = 0.5 }\n"),
                deck("sphere = { centre = [0, 0, -1], radius = 1e-3 }\n"),
                "obstacle o is 1/289 times as large as the model");
}

TEST_CASE("Coefficients of friction above 2 are asked about", "[check]") {
    const auto contact = [](const std::string& value) {
        return make_deck(steel + "radius = 0.01\n",
                         "[contact]\nfriction = " + value +
                             "\n[obstacle.o]\nplane = { point = [0, 0, -1], normal = [0, 0, 1] }\n" +
                             statics);
    };
    check_asked(contact("1.5"), contact("15"), "the coefficient of friction of [contact] is 15");
    const auto tendon = [](const std::string& value) {
        return make_deck(
            steel,
            "[tendon.t]\non = \"r\"\noffset = [0, 0.02]\ntension = 3\nstiffness = 1e4\nfriction = " + value +
                "\n" + statics);
    };
    check_asked(tendon("0.3"), tendon("30"), "the coefficient of friction of tendon t is 30");
}

TEST_CASE("A tendon far outside its rod is asked about", "[check]") {
    const auto deck = [](const std::string& offset) {
        return make_deck(steel,
                         "[tendon.t]\non = \"r\"\noffset = [0, " + offset + "]\ntension = 3\n" + statics);
    };
    check_asked(deck("0.1"),
                deck("10"),
                "tendon t passes 10 from the line of rod r, 500 times the size of its section");
}

TEST_CASE("Damping above twice the critical one in the lowest mode is asked about", "[check]") {
    const auto deck = [](const std::string& time) {
        return make_deck(steel + "damping = { kelvin_voigt = " + time + " }\n", dynamics);
    };
    check_asked(deck("1e-3"), deck("0.02"), "kelvin_voigt of section s, 0.02, damps the lowest mode");
}

TEST_CASE("A yield stress in another unit than E is asked about", "[check]") {
    const auto deck = [](const std::string& stress) {
        return make_deck(
            "material = { E = 2.1e11, nu = 0.3, density = 7850, shear_factor = 0.9, yield_stress = " +
                stress + " }\n",
            statics);
    };
    check_asked(deck("2.5e8"), deck("250"), "section.s.material.yield_stress: it is 1.2e-09 of E");
}

TEST_CASE("A modulus in another unit is asked about in motions, too", "[check]") {
    const std::string right = "gravity = [0, 0, -9.81]\n" + make_deck(steel, dynamics);
    check_asked(right, replaced(right, "E = 2.1e11", "E = 210"), "gravity and loads would strain rod r by");
    // Where no load strains it, its velocities do.
    const std::string free = replaced(make_deck(steel, dynamics), clamps, "");
    const std::string spun = free + "[[initial]]\non = \"r\"\nvelocity = [0, \"10*x\", 0]\n";
    check_asked(spun, replaced(spun, "E = 2.1e11", "E = 70"), "places of rod r move at 5 against each other");
    const std::string moved =
        make_deck(steel, dynamics) + "[[support]]\nat = \"r@0.5\"\nmove = { y = \"0.01*sin(20*t)\" }\n";
    check_asked(moved, replaced(moved, "E = 2.1e11", "E = 7"), "places of rod r move at");
}

TEST_CASE("Coarse rods are asked about where they are to buckle", "[check]") {
    const auto deck = [](const std::string& elements, const std::string& order) {
        return replaced(
            make_deck(steel,
                      "[[load]]\nat = \"r@0.5\"\nforce = [-1, 0, 0]\n[[stage]]\nname = \"load\"\nkind = "
                      "\"static\"\n[[stage]]\nname = \"buckle\"\nkind = \"buckling\"\n"),
            "elements = 2\norder = 2",
            "elements = " + elements + "\norder = " + order);
    };
    check_asked(deck("2", "2"),
                deck("4", "1"),
                "rod r has few elements of order 1 for a half wave of buckling along it: "
                "4 of them make its load 11 % too high");
    check_asked(deck("8", "1"), deck("2", "1"), "2 of them make its load 62 % too high");
}

TEST_CASE("An input that no expression reads is noted", "[check]") {
    const auto deck = [](const std::string& tension) {
        return make_deck(steel,
                         "[input.pull]\nvalue = 3\n[tendon.t]\non = \"r\"\noffset = [0, 0.02]\ntension = " +
                             tension + "\n" + statics);
    };
    check_asked(deck("\"pull\""), deck("3"), "input.pull: nothing uses it");
    // A function that reads it uses it, too.
    check_asked(deck("\"2*f(t)\"") + "[function.f]\nexpression = \"pull*t\"\n", deck("3"), "input.pull");
}

}  // namespace gxrod::test
