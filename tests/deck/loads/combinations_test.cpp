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

// A deck whose section is in water or air.
std::string make_wet() {
    return replaced(
        static_rod_deck, "[rod.r]", "fluid = { outer_diameter = 0.1, drag = { normal = 1 } }\n[rod.r]");
}

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

TEST_CASE("Tendons and chambers and magnets and wind have cases, too", "[deck]") {
    const auto model = [](const std::string& tables, const std::string& factor = "1.5") {
        return read((tables.find("[air]") == 0 ? make_wet() : static_rod_deck) + tables +
                    "[combination.a]\nfactors = { w = " + factor + " }\n")
            .model;
    };
    const std::string tendon = "[tendon.t]\non = \"r\"\noffset = [0, 0.1]\ncase = \"w\"\n";
    CHECK(model(tendon + "tension = 4\n").tendons.at(0).tension(1.0) == 6.0);
    CHECK(model(tendon + "shortening = \"0.2*t\"\n").tendons.at(0).winch->shortening(1.0) == Approx(0.3));
    CHECK(model(tendon + "shortening = \"0.2*t\"\n", "0").tendons.at(0).winch->is_released);
    CHECK(model("[chamber.c]\non = \"r\"\noffset = [0, 0]\narea = 2\npressure = 3\ncase = \"w\"\n")
              .tendons.at(0)
              .tension(1.0) == -9.0);
    const Model magnet =
        model("[[magnetic]]\non = \"r\"\nmoment = [0, 0, 2]\nfield = [3, 0, 0]\ncase = \"w\"\n");
    CHECK(magnet.distributed_loads.at(0).field->at(1.0, Vec3::Zero()).x() == 4.5);
    // The force of a wind is proportional to the density of the air.
    const std::string air = "[air]\ndensity = 1.25\nwind = { velocity = [\"10\", 0, 0], case = \"w\" }\n";
    CHECK(model(air).surroundings.air->density == 1.875);
    CHECK(model(air).surroundings.air->wind.field(1.0, Vec3::Zero()).x() == 10.0);
    CHECK(model(air, "0").surroundings.air->density == 1.25);
    CHECK(model(air, "0").surroundings.air->wind.is_still());
}

TEST_CASE("Forces that are proportional to nothing have no factor of a case", "[deck]") {
    const auto faults = [](const std::string& tables, const std::string& factor) {
        return faults_of("gravity = [0, 0, -10]\n" +
                         (tables.find("[tendon") == 0 ? static_rod_deck : make_wet()) + tables +
                         "[combination.a]\nfactors = { w = " + factor + " }\n");
    };
    const std::string water = "[fluid]\ndensity = 1000\nsurface = 5\n";
    const std::string current = water + "current = { velocity = [1, 0, 0], case = \"w\" }\n";
    CHECK_THAT(faults(current, "1.5"),
               Contains("fluid.current.case: has the factor 1.5 in the combination that acts") &&
                   Contains("expected the factor 1 or 0"));
    CHECK(faults(current, "1") == "");
    CHECK(faults(current, "0") == "");
    const std::string wave = water + "[[wave]]\nairy = { height = 1, period = 5 }\ncase = \"w\"\n";
    CHECK_THAT(faults(wave, "1.35"), Contains("wave[0].case: has the factor 1.35"));
    CHECK_THAT(faults("[air]\ndensity = 1.25\nwind = { velocity = [1, 0, 0], case = \"w\" }\n", "-1"),
               Contains("air.wind.case: has the factor -1") && Contains("another wind for the other way"));
    CHECK_THAT(faults("[tendon.t]\non = \"r\"\noffset = [0, 1]\nlength = 9\ncase = \"w\"\n", "1.5"),
               Contains("tendon.t.case: of a length has no meaning"));
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
