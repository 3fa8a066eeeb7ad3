#include "deck/output/stress_checks.hpp"

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// A strip of two plies, of a bar with a [[history]] named "a" at its end. Its materials are in lines 1 to 8.
std::string strip_deck(const std::string& inner, const std::string& outer, const std::string& rest) {
    return "[material.inner]\nE = 2e11\nnu = 0.3\n" + inner + "\n[material.outer]\nE = 1e11\nnu = 0.3\n" +
           outer +
           "\n[layup.l]\nplies = [[\"inner\", 0.01, 0], [\"outer\", 0.01, 0]]\n"
           "[section.s]\nshape = { walls = { corners = [[0, 0], [0.1, 0]], layup = \"l\" } }\n"
           "[rod.r]\nsection = \"s\"\nline = { from = [0, 0, 0], to = [2, 0, 0] }\nelements = 2\n"
           "y_axis = [0, 1, 0]\n[analysis]\nkind = \"static\"\n" +
           rest;
}

std::string history(const std::string& keys) {
    return "[[history]]\nname = \"a\"\nat = \"r.end\"\nquantities = [\"stress\", \"exposure\"]\n" + keys +
           "\n";
}

const std::string yield = "yield_stress = 2e8", nothing = "# nothing";
const std::string strength = "strength = { Xt = 2, Xc = 1, Yt = 2, Yc = 1, S12 = 1, S23 = 1 }";

// The notes of a deck about stresses.
std::string notes_of(const std::string& deck) {
    std::string all;
    for (const std::string& note : read(deck).notes) {
        if (note.starts_with("history") || note.starts_with("output")) all += note + "\n";
    }
    return all;
}

}  // namespace

TEST_CASE("A criterion for which no material has the numbers is refused", "[deck]") {
    const std::string hashin = history("criterion = \"hashin\"");
    CHECK(faults_of(strip_deck(yield, nothing, hashin)) ==
          "x.toml:24:13: history[0].criterion: \"hashin\" needs the strength of a material, and inner, outer "
          "have "
          "none; give it, or take \"von-mises\"");
    CHECK(faults_of(strip_deck(yield, nothing, "[output]\nstresses = \"tsai-wu\"\n")) ==
          "x.toml:21:12: output.stresses: \"tsai-wu\" needs the strength of a material, and inner, outer "
          "have none; "
          "give it, or take \"von-mises\"");
    // Exposure without a criterion is by yield stresses.
    CHECK(faults_of(strip_deck(strength, strength, history(""))) ==
          "x.toml:23:25: history[0].quantities[1]: \"von-mises\" needs the yield_stress of a material, and "
          "inner, "
          "outer have none; give it, or take \"tsai-wu\", \"hashin\", \"max-stress\"");
    CHECK(faults_of(strip_deck(yield, yield, "[output]\nstresses = \"von-mises\"\n" + history(""))).empty());
    CHECK(notes_of(strip_deck(yield, yield, "[output]\nstresses = \"von-mises\"\n" + history(""))).empty());
    CHECK(notes_of(strip_deck(nothing, nothing, "[output]\nstresses = \"von-mises\"\n")).empty());
}

TEST_CASE("Materials that another criterion compares, or none, are noted", "[deck]") {
    const std::string hashin = history("criterion = \"hashin\"");
    CHECK(notes_of(strip_deck(strength, yield, hashin)) ==
          "history[0].criterion: outer has no strength: exposure there is by \"von-mises\"\n");
    CHECK(notes_of(strip_deck(strength, nothing, hashin)) ==
          "history[0].criterion: outer has no strength and no yield_stress: no exposure there\n");
    CHECK(notes_of(strip_deck(strength, yield, "[output]\nstresses = \"von-mises\"\n")) ==
          "output.stresses: inner has no yield_stress: no exposure there\n");
    CHECK(notes_of(strip_deck(strength, strength, "[output]\nstresses = \"von-mises\"\n")) ==
          "output.stresses: inner, outer have no yield_stress: no exposure there\n");
}

TEST_CASE("A point that is not in the section is refused, and one next to it noted", "[deck]") {
    const auto at = [](const std::string& point) {
        return strip_deck(yield, yield, history("point = " + point));
    };
    CHECK(
        faults_of(at("[5, 5]")) ==
        "x.toml:24:9: history[0].point: (5, 5) is not in walls; its nearest point is (0.1, 0.01), 6.99 away");
    CHECK(notes_of(at("[0.1, 0.013]")) ==
          "history[0].point: stresses are those of the nearest point of walls, (0.1, 0.01), 0.003 away\n");
    CHECK(notes_of(at("[0.1, 0.0105]")).empty());
    CHECK(faults_of(at("[0.1, 0.0201]")).find("0.0101 away") != std::string::npos);
    CHECK(faults_of(at("[0.1, 0.0199]")).empty());
}

}  // namespace gxrod::test
