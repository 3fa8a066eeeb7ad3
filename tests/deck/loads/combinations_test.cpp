#include "deck/loads/combinations.hpp"

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

const std::string loads =
    "[[load]]\nat = \"r.end\"\nforce = [0, 0, -2]\ncase = \"dead\"\n"
    "[[load]]\nat = \"r.end\"\nforce = [0, 3, 0]\ncase = \"wind\"\n"
    "[[load]]\nat = \"r.end\"\nforce = [5, 0, 0]\n";
const std::string combinations =
    "[combination.a]\nfactors = { dead = 1.5 }\n"
    "[combination.b]\nfactors = { dead = 1.25, wind = -1, gravity = 2 }\n";
const std::string deck = "gravity = [0, 0, -10]\n" + static_rod_deck + loads;

Vec3 force_at(const NodalLoad& load, double t) {
    return {load.force[0](t), load.force[1](t), load.force[2](t)};
}

}  // namespace

TEST_CASE("One combination of load cases acts", "[deck]") {
    const Model first = read(deck + combinations).model;
    REQUIRE(first.loads.size() == 2);
    CHECK(force_at(first.loads[0], 0.5) == Vec3(0, 0, -1.5));
    CHECK(force_at(first.loads[1], 1.0) == Vec3(5, 0, 0));
    // Gravity is a case, as one of them names it.
    CHECK(first.gravity(1.0).isZero(0.0));
    const Model second = read(deck + combinations, {"apply=b"}).model;
    REQUIRE(second.loads.size() == 3);
    CHECK(force_at(second.loads[0], 1.0) == Vec3(0, 0, -2.5));
    CHECK(force_at(second.loads[1], 1.0) == Vec3(0, -3, 0));
    CHECK(second.gravity(1.0) == Vec3(0, 0, -20));
    // Without combinations all cases act as written.
    const Model plain = read(deck).model;
    CHECK(force_at(plain.loads.at(1), 1.0) == Vec3(0, 3, 0));
    CHECK(plain.gravity(1.0) == Vec3(0, 0, -10));
}

TEST_CASE("Loads along rods, by place and with factors have cases, too", "[deck]") {
    const auto load = [](const std::string& keys) {
        return read(static_rod_deck + "[[load]]\ncase = \"dead\"\n" + keys +
                    "[combination.a]\nfactors = { dead = 2 }\n")
            .model;
    };
    CHECK(load("on = \"r\"\nforce_per_length = [0, 0, \"s\"]\n").distributed_loads.at(0).force[2](0.5, 3.0) ==
          3.0);
    CHECK(load("at = \"r.end\"\nforce = [0, 0, 4]\nfactor = \"t^2\"\n").loads.at(0).force[2](0.5) == 2.0);
    const Model spring = load("at = \"r.end\"\nforce = [0, 0, \"-7*z\"]\n");
    PointMotion motion;
    motion.position = Vec3(0, 0, 2);
    CHECK(spring.loads.at(0).by_motion.value(1.0, 0.0, motion)[2] == -28.0);
}

TEST_CASE("Names of cases and combinations are checked", "[deck]") {
    CHECK(faults_of(deck + "[combination.a]\nfactors = { deda = 1 }\n") ==
          "x.toml:24:20: combination.a.factors.deda: no load has the case \"deda\"; did you mean \"dead\"?");
    CHECK(faults_of(static_rod_deck + loads + "[combination.a]\nfactors = { gravity = 1 }\n") ==
          "x.toml:23:23: combination.a.factors.gravity: the deck has no gravity");
    CHECK(faults_of(deck + combinations, {"apply=c"}) ==
          "--set apply=c: no combination \"c\"; the deck has a, b");
    CHECK_THAT(faults_of(deck + "[combination.a]\nfactors = { dead = \"t\" }\n"),
               Contains("a factor of a load case is a number"));
    CHECK_THAT(faults_of(deck + "[combination.a]\nfactors = 2\n"),
               Contains("expected a table of a number for each load case"));
}

TEST_CASE("Notes say what acts in which combination", "[deck]") {
    const std::vector<std::string> notes =
        read(static_rod_deck + loads +
             "[combination.a]\nfactors = { dead = 1 }\n[combination.b]\nfactors = { "
             "dead = 2 }\n")
            .notes;
    const auto has = [&](const std::string& text) {
        return std::ranges::any_of(notes, [&](const std::string& note) { return note.find(text) == 0; });
    };
    CHECK(has("combination.a acts, the first of 2; apply = \"NAME\" takes another one"));
    CHECK(has("load[2] acts as written in every combination"));
    CHECK(has("case \"wind\" is in no combination, so it never acts"));
}

}  // namespace gxrod::test
