#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// Bodies a, b and c, and joints of the ground with them; lines 1 to 38.
const std::string parts = R"([body.a]
mass = 1
inertia = [1, 1, 1]
[body.b]
mass = 1
inertia = [1, 1, 1]
[body.c]
mass = 1
inertia = [1, 1, 1]
[joint.shaft]
type = "hinge"
between = ["ground", "a"]
axis = [0, 0, 1]
[joint.wheel]
type = "universal"
between = ["ground", "b"]
axis = [0, 0, 1]
axis_b = [0, 1, 0]
[joint.nut]
type = "cylinder"
between = ["ground", "c"]
axis = [1, 0, 0]
[joint.ball]
type = "ball"
between = ["a", "b"]
[joint.rail]
type = "slider"
between = ["b", "c"]
axis = [1, 0, 0]
[joint.any]
type = "free"
between = ["a", "c"]
axis = [1, 0, 0]
drive = { turn = 1 }
[analysis]
kind = "dynamic"
end_time = 1
steps = 10
)";

std::string gear(const std::string& joints, const std::string& ratio = "5") {
    return parts + "[gear.g]\njoints = [" + joints + "]\nratio = " + ratio + "\n";
}

Gear read_gear(const std::string& joints) { return read(gear(joints)).model.gears.at(0); }

}  // namespace

TEST_CASE("A gear ties the coordinates that its joints have", "[deck][gear]") {
    const auto check = [](const std::string& joints, int first, bool is_turn, int second, bool is_turn_too) {
        INFO(joints);
        const Gear built = read_gear(joints);
        CHECK(built.name == "g");
        CHECK(built.ratio == 5.0);
        CHECK(built.sides[0].joint == first);
        CHECK(built.sides[0].is_turn == is_turn);
        CHECK(built.sides[1].joint == second);
        CHECK(built.sides[1].is_turn == is_turn_too);
    };
    check("\"shaft\", \"wheel\"", 0, true, 1, true);
    check("\"wheel.turn\", \"nut.slide\"", 1, true, 2, false);
    check("\"rail\", \"nut.turn\"", 4, false, 2, true);
    check("\"rail.slide\", \"any.turn\"", 4, false, 5, true);
}

TEST_CASE("Gears that tie nothing are errors", "[deck][gear]") {
    const auto of = [](const std::string& joints) { return faults_of(gear(joints)); };
    const std::string second = "x.toml:40:20: gear.g.joints[1]: ";
    CHECK(of("\"shaft\", \"wheal\"") == second + "no joint \"wheal\"; did you mean \"wheel\"?");
    CHECK(of("\"shaft\", \"a\"") ==
          second + "no joint \"a\"; the deck has shaft, wheel, nut, ball, rail, any");
    CHECK(of("\"shaft\", \"ball\"") ==
          second + "a ball has no turn about one axis and no slide that a gear could tie");
    CHECK(of("\"shaft\", \"rail.turn\"") == second + "a slider has no turn");
    CHECK(of("\"shaft\", \"wheel.slide\"") == second + "a universal has no slide");
    CHECK(of("\"shaft\", \"nut.spin\"") == second + "no coordinate \"spin\"; expected turn or slide");
    CHECK(of("\"shaft\", \"nut\"") ==
          second + "a cylinder has a turn and a slide; expected \"nut.turn\" or \"nut.slide\"");
    CHECK(of("\"shaft\", \"any\"") ==
          second + "a free joint has a turn and a slide; expected \"any.turn\" or \"any.slide\"");
    CHECK(of("\"shaft\", \"shaft\"") ==
          second + "both are of joint shaft; expected another joint, or a screw for its turn and slide");
    CHECK(faults_of(gear("\"shaft\", \"wheel\"", "0")) ==
          "x.toml:41:9: gear.g.ratio: a ratio of 0 does not tie the joints; expected another number");
    CHECK(of("\"shaft\"") ==
          "x.toml:40:10: gear.g.joints: expected an array of 2 joints, such as [\"motor\", \"wheel\"], or of "
          "their coordinates, such as \"nut.slide\", found an array of 1");
    CHECK(of("\"shaft\", 3") == second + "expected a joint, such as \"wheel\", found 3");
    CHECK(faults_of(parts + "[gear.g]\njoints = [\"shaft\", \"wheel\"]\n") ==
          "x.toml:39:1: gear.g.ratio: missing; expected a number or an expression; how far the second goes "
          "back while the first goes on by 1");
    CHECK(faults_of(replaced(gear("\"shaft\", \"wheel\""), "[gear.g]", "[gear.shaft]")) ==
          "x.toml:39:1: gear.shaft: joint.shaft has this name too, and points go by it");
}

TEST_CASE("Teeth that yield have a stiffness, and may have backlash", "[deck][gear]") {
    const std::string rigid = gear("\"shaft\", \"wheel\"");
    CHECK_FALSE(read(rigid).model.gears.at(0).teeth);
    const auto teeth =
        *read(rigid + "backlash = 0.02\nstiffness = 300\ndamping = 4\n").model.gears.at(0).teeth;
    CHECK(teeth.lower == -0.01);
    CHECK(teeth.upper == 0.01);
    CHECK(teeth.stiffness == 300.0);
    CHECK(teeth.damping == 4.0);
    CHECK(read(rigid + "stiffness = 300\n").model.gears.at(0).teeth->upper == 0.0);
    for (const char* key : {"backlash = 0.02\n", "damping = 4\n"})
        CHECK(faults_of(rigid + key) ==
              "x.toml:39:1: gear.g.stiffness: missing; teeth with backlash or damping yield; expected how "
              "stiff "
              "they are");
}

TEST_CASE("A history of a gear has its moment and its gap", "[deck][gear]") {
    const auto history = [](const std::string& quantities) {
        return gear("\"shaft\", \"wheel\"") +
               "[[history]]\nname = \"h\"\nat = \"g\"\nquantities = " + quantities + "\n";
    };
    const HistoryRequest request = read(history("[\"drive\", \"gap\"]")).output.histories.at(0);
    CHECK(is_tie(request.target, TieKind::gear));
    CHECK(std::get<WatchedTie>(request.target).index == 0);
    CHECK(faults_of(history("\"moment\"")) ==
          "x.toml:45:14: history[0].quantities: \"moment\": a gear has drive, play and gap only; its joints "
          "have the "
          "rest; did you mean \"drive\"?");
}

}  // namespace gxrod::test
