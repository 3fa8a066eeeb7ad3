#include <algorithm>
#include <cmath>
#include <numbers>

#include "deck/surroundings/surroundings_decks.hpp"
#include "deck/surroundings/surroundings_files.hpp"
#include "environment/dispersion.hpp"
#include "machine/file_error.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

const std::string airy = "[[wave]]\nairy = { height = 2, period = 8, phase = 0.5 }\n";

const Surroundings& around(const Problem& problem, std::size_t stage) {
    return stage == 0 ? problem.model.surroundings : problem.stages.at(stage).actions.surroundings;
}

// η of a wave at the origin.
double elevation(const WaveTrain& train, double time) {
    return train.amplitude * std::cos(train.phase - train.frequency * time);
}

std::string faults(const std::string& lines) { return faults_of(tube_deck() + lines); }

}  // namespace

TEST_CASE("Currents grow in a static stage and are whole afterwards", "[deck]") {
    const Problem problem = read(staged_tube_deck() + water_deck +
                                 "current = { table = [[-10, 1], [0, 3]], direction = [0, 2, 0] }\n"
                                 "[air]\ndensity = 1.2\nwind = { velocity = [7, \"x\", \"5*t\"] }\n");
    REQUIRE(problem.stages.size() == 3);
    const auto profile = [&](std::size_t i) { return *around(problem, i).water->current.profile; };
    const auto wind = [&](std::size_t i, double t) {
        return around(problem, i).air->wind.field(t, Vec3(3.0, 0.0, 0.0));
    };
    CHECK(profile(0).factor(0.25) == 0.25);
    CHECK(profile(1).factor(0.25) == 1.0);
    CHECK(wind(0, 0.5) == Vec3(3.5, 1.5, 2.5));
    CHECK(wind(1, 0.5) == Vec3(7.0, 3.0, 2.5));
}

TEST_CASE("Water and ground are there in some stages and grow by factors", "[deck]") {
    const Problem problem =
        read(staged_tube_deck() + water_deck + "factor = { storm = 0.5 }\n[seabed]\nz = -5\nstiffness = 1\n" +
             "friction = 0.4\nfactor = \"t\"\nstages = [\"hang\", \"calm\"]\n");
    const auto water = [&](std::size_t i) { return *around(problem, i).water; };
    const auto bed = [&](std::size_t i) { return *around(problem, i).seabed; };
    CHECK_FALSE(water(0).acts());  // before the first stage that is named
    CHECK(water(1).density_at(0.7) == 500.0);
    CHECK(water(2).factor.is_constant());
    CHECK(water(2).density_at(0.7) == 500.0);  // keeps the last value
    CHECK(water(2).changes);
    CHECK(bed(0).factor(0.25) == 0.25);
    CHECK_FALSE(bed(1).acts());
    CHECK_FALSE(bed(1).has_friction());
    CHECK(bed(1).friction_stiffness == 1.0);  // its memory has the same places in all stages
    CHECK(bed(2).factor(0.25) == 0.25);
    CHECK(bed(2).has_friction());
    // Without the keys they are there from the start, also in a static stage in which loads grow.
    const Problem plain = read(staged_tube_deck() + water_deck + "[seabed]\nz = -5\nstiffness = 1\n");
    CHECK(plain.model.surroundings.water->factor.is_constant());
    CHECK(plain.model.surroundings.water->factor(0.3) == 1.0);
    CHECK(plain.model.surroundings.seabed->factor(0.3) == 1.0);
    CHECK_FALSE(plain.model.surroundings.water->changes);
}

TEST_CASE("What is wrong with factors and stages of water and ground is said where it stands", "[deck]") {
    const std::string bed = "[seabed]\nz = -5\nstiffness = 1\n";
    CHECK_THAT(faults(water_deck + "stages = \"storm\"\n"),
               Contains("fluid.stages") && Contains("no stage \"storm\""));
    CHECK_THAT(faults(bed + "factor = { calm = 1 }\n"),
               Contains("seabed.factor.calm") && Contains("no stage \"calm\""));
    CHECK_THAT(faults(bed + "factor = \"1 - 2*t\"\n"),
               Contains("seabed.factor: is -0.2 at t = 0.6; expected at least 0"));
    CHECK_THAT(faults(water_deck + "factor = -1\n"), Contains("fluid.factor: is -1 at t = 0"));
    CHECK_THAT(faults(bed + "factor = \"1/(t - t)\"\n"), Contains("seabed.factor"));
    CHECK_THAT(faults(water_deck + "factor = \"t\"\n"),
               Contains("x.toml:17") && Contains("fluid.factor: changes with t in a dynamic analysis") &&
                   Contains("its mass cannot come and go"));
    CHECK_THAT(faults_of(staged_tube_deck() + water_deck + "factor = { hang = \"t\", storm = \"t/2\" }\n"),
               Contains("in the dynamic stage \"storm\"") && Contains("or added_mass = 0"));
    // Without added mass, without inertia and without time it may change.
    CHECK(faults_of(tube_deck("fluid = { added_mass = 0 }") + water_deck + "factor = \"t\"\n").empty());
    CHECK(faults_of(staged_tube_deck() + water_deck +
                    "factor = { hang = \"t\", storm = 1, calm = \"1 - t/3\" }\n")
              .empty());
    CHECK(faults_of(staged_tube_deck() + water_deck + "factor = { hang = \"t\" }\n").empty());
}

TEST_CASE("Waves act in stages with time and go on from one to the next", "[deck]") {
    const Problem problem = read(staged_tube_deck() + water_deck + "depth = 40\nramp = 3\n" + airy);
    CHECK(around(problem, 0).water->waves.empty());
    const Water& storm = *around(problem, 1).water;
    const Water& calm = *around(problem, 2).water;
    REQUIRE(storm.waves.size() == 1);
    REQUIRE(calm.waves.size() == 1);
    CHECK(storm.ramp_start == 0.0);
    CHECK(calm.ramp_start == -2.0);
    CHECK(storm.ramp == 3.0);
    // The second stage begins where the first one, of 2, ended.
    CHECK(elevation(calm.waves[0], 0.7) == Approx(elevation(storm.waves[0], 2.7)));
    CHECK(elevation(storm.waves[0], 0.7) == Approx(std::cos(0.5 - 2.0 * M_PI / 8.0 * 0.7)));
}

TEST_CASE("t of waves begins in the first stage that has them", "[deck]") {
    const Problem problem = read(staged_tube_deck() + water_deck + airy + "stages = \"calm\"\n");
    CHECK(around(problem, 1).water->waves.empty());
    const Water& calm = *around(problem, 2).water;
    CHECK(calm.ramp_start == 0.0);
    CHECK(calm.waves.at(0).phase == 0.5);
}

TEST_CASE("Waves feel the ground below them", "[deck]") {
    const auto depth = [](const std::string& lines) {
        return read(tube_deck() + water_deck + lines + airy).model.surroundings.water->depth;
    };
    CHECK_FALSE(depth(""));
    CHECK(depth("[seabed]\nz = -12\nstiffness = 1\n") == 12.0);
    CHECK(depth("[seabed]\nplane = { point = [7, 8, -9], normal = [0, 0, 3] }\nstiffness = 1\n") == 9.0);
    CHECK(depth("depth = 30\n[seabed]\nz = -12\nstiffness = 1\n") == 30.0);
    const Model model = read(tube_deck() + water_deck + "[seabed]\nz = -12\nstiffness = 1\n" + airy).model;
    const WaveTrain& wave = model.surroundings.water->waves.at(0);
    CHECK(wave.frequency * wave.frequency ==
          Approx(9.81 * wave.number * std::tanh(12.0 * wave.number)).epsilon(1e-12));
}

TEST_CASE("A record gives back its surface where it was measured", "[deck]") {
    const std::string file = GXROD_SOURCE_DIR "/tests/deck/surroundings/eta.csv";
    const Model model = read(tube_deck() + water_deck + "[[wave]]\nelevation = { file = \"" + file +
                             "\", at = [100, 50, 0] }\ndirection = [3, 4, 0]\n")
                            .model;
    double height = 0.0;
    const double along = 0.6 * 100.0 + 0.8 * 50.0;
    for (const WaveTrain& wave : model.surroundings.water->waves)
        height += wave.amplitude * std::cos(wave.number * along - wave.frequency * 3.0 + wave.phase);
    CHECK(height == Approx(1.2 * std::cos(0.75 * M_PI + 0.3) + 0.3 * std::cos(1.5 * M_PI)).margin(1e-5));
}

TEST_CASE("A deck is rebuilt with the files that are kept with it", "[deck]") {
    const std::string file = GXROD_SOURCE_DIR "/tests/deck/surroundings/bed.csv";
    const Problem problem =
        read(tube_deck() + "[seabed]\nstiffness = 1\ngrid = { file = \"" + file + "\" }\n");
    const Problem again = rebuild_problem(problem.record);
    CHECK(again.model.surroundings.seabed->grid->z == std::vector<double>{-10.0, -11.0, -12.0, -13.0});
}

TEST_CASE("What is wrong with water, wind and ground is said where it stands", "[deck]") {
    CHECK_THAT(faults_of(tube_deck()),
               Contains("x.toml:5") && Contains("section.s.fluid") &&
                   Contains("the deck has no [fluid], [air] or [seabed]"));
    CHECK_THAT(faults_of(tube_deck("") + water_deck),
               Contains("x.toml:14") && Contains("fluid: passes everything by") && Contains("fluid = {}"));
    CHECK_THAT(faults_of(tube_deck("") + "[seabed]\nz = 0\nstiffness = 1\n"),
               Contains("seabed: passes everything by"));
    const std::string ball = gravity_down +
                             replaced(body_deck, "[analysis]", "fluid = { volume = 0.002 }\n[analysis]") +
                             water_deck;
    const std::string ground = "[seabed]\nz = -5\nstiffness = 1\n";
    CHECK(faults_of(ball).empty());
    CHECK_THAT(faults_of(ball + ground), Contains("seabed: holds nothing up: it acts on rods"));
    CHECK(faults_of(ball + ground + "[[wave]]\nairy = { height = 1, period = 8 }\n").empty());
    CHECK_THAT(faults_of(ball + "depth = 9\n" + ground + "[[wave]]\nairy = { height = 1, period = 8 }\n"),
               Contains("seabed: holds nothing up"));
    CHECK_THAT(faults("[fluid]\nsurface = 0\n"), Contains("fluid.density: missing"));
    CHECK_THAT(faults("[fluid]\ndensity = 1\ndepth = 5\n"),
               Contains("x.toml:16") && Contains("fluid.depth: goes with surface"));
    CHECK_THAT(faults("[fluid]\ndensity = 1\nramp = 5\n"), Contains("fluid.ramp: goes with surface"));
    CHECK_THAT(faults(water_deck + "stretching = \"whelr\"\n"), Contains("did you mean \"wheeler\"?"));
    CHECK_THAT(faults(water_deck + "current_stretching = true\n"),
               Contains("fluid.current_stretching: goes with a table of the current"));
    CHECK_THAT(faults(water_deck + "velocity = [1, 0, 0]\n"), Contains("did you mean \"current.velocity\"?"));
}

TEST_CASE("Water with a surface needs gravity that acts down", "[deck]") {
    const std::string wanted = "expected gravity = [0, 0, -g]";
    for (const char* other : {"[0, 0, 9.81]", "[0, -9.81, 0]", "[1, 0, -9.81]", "[0, 0, 0]"}) {
        CHECK_THAT(faults_of(replaced(tube_deck(), "[0, 0, -9.81]", other) + water_deck),
                   Contains("x.toml:16") && Contains("fluid.surface") && Contains(wanted));
    }
    CHECK_THAT(faults_of(replaced(tube_deck(), gravity_down, "") + water_deck), Contains(wanted));
    CHECK(faults_of(replaced(tube_deck(), gravity_down, "") + "[fluid]\ndensity = 1000\n").empty());
    CHECK(faults_of(replaced(tube_deck(), "-9.81", "\"-9.81*t\"") + water_deck).empty());
    CHECK_THAT(faults_of(replaced(tube_deck(), "-9.81", "\"-9.81*t\"") + water_deck + airy),
               Contains("x.toml:1:") && Contains("gravity[2]") && Contains("waves take a number"));
}

TEST_CASE("A current turns by the shorter way from row to row", "[deck]") {
    const auto speeds = [](const std::string& rows) {
        return around(read(tube_deck() + water_deck + "current = { table = " + rows + " }\n"), 0)
            .water->current.profile->speeds;
    };
    const std::vector<double> turning = speeds("[[-9, 1, 350], [-5, 2, 10], [0, 3, 190]]");
    REQUIRE(turning.size() == 6);
    CHECK(std::abs(turning[3] - turning[1] - 20.0 * std::numbers::pi / 180.0) < 1e-14);
    CHECK(std::abs(std::abs(turning[5] - turning[3]) - std::numbers::pi) < 1e-14);
    CHECK(speeds("[[-9, 1, 2, 3], [0, 4, 5, 6]]") == std::vector<double>{1, 2, 3, 4, 5, 6});
}

TEST_CASE("What is wrong with currents and winds is said where it stands", "[deck]") {
    const auto current = [](const std::string& keys) {
        return faults(water_deck + "current = { " + keys + " }\n");
    };
    CHECK_THAT(current("table = [[0, 1], [0, 2]], direction = [1, 0, 0]"),
               Contains("x.toml:17") && Contains("fluid.current.table[1]") &&
                   Contains("z must rise from row to row: 0 follows 0"));
    CHECK_THAT(current("table = [[0, 1]], direction = [0, 0, 0]"),
               Contains("fluid.current.direction") && Contains("zero length"));
    CHECK_THAT(current("table = [[0, 1]]"),
               Contains("fluid.current.table: rows [z, speed] need the key direction"));
    CHECK_THAT(current("table = [[0, 1, 90]], direction = [1, 0, 0]"),
               Contains("fluid.current.direction: goes with rows [z, speed]"));
    CHECK_THAT(current("table = [[0, 1, 90], [1, 2]]"),
               Contains("fluid.current.table[1]: expected 3 numbers as in the first row, found 2"));
    CHECK_THAT(current("table = [[0, 1, 2, 3, 4]]"), Contains("fluid.current.table[0]: expected a row"));
    CHECK_THAT(current("velocity = [0, 0, 0], table = [[0, 1]], direction = [1, 0, 0]"),
               Contains("only one of them can be"));
    CHECK_THAT(current("velocity = [\"vx\", 0, 0]"), Contains("fluid.current.velocity[0]"));
    CHECK_THAT(current("velocity = [\"1/(t-t)\", 0, 0]"), Contains("fluid.current.velocity[0]"));
    CHECK_THAT(current("velocity = [1, 0, 0], stages = \"storm\""),
               Contains("fluid.current.stages") && Contains("no stage \"storm\""));
    CHECK_THAT(faults("[air]\ndensity = 1\nwind = { velocity = [1, 0, 0], factor = { calm = 1 } }\n"),
               Contains("air.wind.factor.calm") && Contains("no stage \"calm\""));
    CHECK_THAT(faults("[air]\ndensity = 1\nvelocity = [1, 0, 0]\n"),
               Contains("did you mean \"wind.velocity\"?"));
}

TEST_CASE("What is wrong with waves is said where it stands", "[deck]") {
    CHECK_THAT(faults(airy), Contains("x.toml:14") && Contains("wave[0]: waves need a surface"));
    CHECK_THAT(faults("[fluid]\ndensity = 1\n" + airy), Contains("wave[0]: waves need a surface"));
    CHECK_THAT(faults(water_deck + airy + "direction = [1, 0, 1]\n"),
               Contains("wave[0].direction: expected a horizontal direction"));
    CHECK_THAT(faults(water_deck + airy + "direction = [0, 0, 0]\n"),
               Contains("expected a horizontal direction"));
    CHECK_THAT(faults(water_deck + "[[wave]]\nairy = { height = 2, period = 0 }\n"),
               Contains("wave[0].airy.period") && Contains("greater than 0"));
    CHECK_THAT(faults(water_deck + "[[wave]]\n"), Contains("wave[0]: missing; expected airy = { … } or"));
    CHECK_THAT(faults_of(staged_tube_deck() + water_deck + airy + "stages = \"hang\"\n"),
               Contains("wave[0].stages: no stage with time among them"));
    const std::string statics =
        replaced(tube_deck(), "kind = \"dynamic\"\nend_time = 1.0\n", "kind = \"static\"\n");
    const std::vector<std::string> notes = read(statics + water_deck + airy).notes;
    CHECK(std::ranges::any_of(
        notes, [](const std::string& note) { return note.starts_with("wave[0]: without effect"); }));
    CHECK_THAT(faults(water_deck + airy + "[seabed]\nz = 3\nstiffness = 1\n"),
               Contains("x.toml:19") && Contains("seabed: at z = 3, which is not below the surface"));
    CHECK_THAT(faults(water_deck + airy +
                      "[seabed]\nplane = { point = [0, 0, -9], normal = [1, 0, 9] }\nstiffness = 1\n"),
               Contains("fluid.depth: missing; the ground is not horizontal"));
}

TEST_CASE("What is wrong with the ground is said where it stands", "[deck]") {
    CHECK_THAT(faults("[seabed]\nz = 0\n"), Contains("seabed.stiffness: missing"));
    CHECK_THAT(faults("[seabed]\nstiffness = 1\n"), Contains("seabed: missing; expected z or"));
    CHECK_THAT(faults("[seabed]\nstiffness = 1\nplane = { point = [0, 0, 0], normal = [0, 0, 0] }\n"),
               Contains("seabed.plane.normal") && Contains("zero length"));
    CHECK_THAT(faults("[seabed]\nstiffness = 1\nz = 0\nfriction = \"-1\"\n"),
               Contains("seabed.friction: expected a number at least 0"));
    CHECK_THAT(faults("[seabed]\nstiffness = 1\nz = 0\nfriction = true\n"),
               Contains("seabed.friction: expected a number at least 0 or an expression, or a table "
                        "friction = { … }"));
    CHECK_THAT(faults("[seabed]\nstiffness = 1\nz = 0\nfriction = { axial = 1 }\n"),
               Contains("seabed.friction.lateral: missing"));
    CHECK_THAT(faults("[seabed]\nstiffness = 1\ngrid = { file = \"nowhere.csv\" }\n"),
               Contains("x.toml:16") && Contains("seabed.grid.file") && Contains("nowhere.csv"));
}

TEST_CASE("What is wrong with a file of waves or of the ground is said by its line", "[deck]") {
    const auto record = [](const char* text) {
        try {
            read_elevations(text, "eta.csv");
        } catch (const FileError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    const auto grid = [](const char* text) {
        try {
            read_ground_grid(text, "bed.csv");
        } catch (const FileError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK(record("t,eta\n0,1\n1,2\n2,0\n").empty());
    CHECK_THAT(record("t,eta\n0,1\n"), Contains("eta.csv:2") && Contains("two rows"));
    CHECK_THAT(record(""), Contains("eta.csv:1"));
    CHECK_THAT(record("0,1\n1,2,3\n"), Contains("eta.csv:2") && Contains("expected 2 columns, found 3"));
    CHECK_THAT(record("0,1\n1,x\n"), Contains("eta.csv:2") && Contains("found \"x\""));
    CHECK_THAT(record("0,1\n1,2\n1,3\n"), Contains("eta.csv:3") && Contains("a time after 1"));
    CHECK_THAT(record("0,1\n1,2\n3,3\n"), Contains("eta.csv:2") && Contains("equal steps, here 1.5"));
    const GroundGrid three = read_ground_grid("2,0,3\n0,1,4\n1,0,2\n0,0,1\n2,1,6\n1,1,5\n", "bed.csv");
    CHECK(three.x == std::vector<double>{0.0, 1.0, 2.0});
    CHECK(three.z == std::vector<double>{1.0, 2.0, 3.0, 4.0, 5.0, 6.0});
    CHECK(grid("0,0,1\n1,0,2\n0,1,3\n1,1,4\n").empty());
    CHECK_THAT(grid("0,0,1\n1,0,2\n"), Contains("bed.csv:1") && Contains("found 2 and 1"));
    CHECK_THAT(grid("0,0,1\n1,0,2\n0,1,3\n"), Contains("each of 2 x with each of 2 y, found 3 rows"));
    CHECK_THAT(grid("0,0,1\n1,0,2\n0,1,3\n0,1,4\n1,1,1\n"),
               Contains("bed.csv:4") && Contains("x = 0, y = 1 is there already"));
}

}  // namespace gxrod::test
