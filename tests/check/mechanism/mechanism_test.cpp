#include "check/mechanism/mechanism.hpp"

#include "deck/decks.hpp"
#include "tools/catch.hpp"
#include "tools/mechanism_decks.hpp"

namespace gxrod::test {
namespace {

Model read_mechanism(const std::string& name, const std::vector<std::string>& overrides = {}) {
    return read_problem(tools::find_mechanism_deck(name), overrides).model;
}

Mechanism only_mechanism(const Model& model) {
    const std::vector<Mechanism> found = find_mechanisms(model);
    REQUIRE(found.size() == 1);
    return found.front();
}

// Two bodies in a row along x, at (0, 0, 0) and (1, 0, 0).
const std::string two_bodies =
    "[body.a]\nmass = 1\ninertia = [1, 1, 1]\n[body.b]\nmass = 1\ninertia = [1, 1, 1]\nat = [1, 0, 0]\n"
    "[analysis]\nkind = \"dynamic\"\nend_time = 1\nsteps = 10\n";

std::string joint(const std::string& name, const std::string& between, const std::string& lines) {
    return "[joint." + name + "]\nbetween = [" + between + "]\n" + lines + "\n";
}

const std::string about_z = "type = \"hinge\"\naxis = [0, 0, 1]\n";

}  // namespace

TEST_CASE("Equations of mechanisms have their known ranks", "[check][joint]") {
    struct Known {
        const char* name;
        int equations, rank, free_motions;
    };
    for (const Known& known : {Known{"double_pendulum", 10, 10, 2},
                               Known{"triple_pendulum", 15, 15, 3},
                               Known{"spatial_slider_crank", 17, 17, 1},
                               Known{"bricard", 30, 29, 1},
                               Known{"gimbals", 15, 15, 3},
                               Known{"double_four_bar", 35, 29, 1},
                               Known{"squeezer", 50, 41, 1}}) {
        INFO(known.name);
        const Mechanism found = only_mechanism(read_mechanism(known.name));
        CHECK(found.is_counted);
        CHECK(found.equations == known.equations);
        CHECK(found.equations - found.redundant == known.rank);
        CHECK(found.free_motions == known.free_motions);
        CHECK(found.unmoved == known.free_motions);
        CHECK(found.motors == 0);
    }
}

TEST_CASE("Redundant equations are those of the joints of a loop", "[check][joint]") {
    const Model model = read_mechanism("bricard");
    CHECK(only_mechanism(model).redundant_joints == std::vector{0, 1, 2, 3, 4, 5});
    const ItemList list = list_mechanisms(model);
    REQUIRE(list.items.size() == 1);
    CHECK(list.items[0] ==
          "mechanism: 5 bodies, 6 joints, 30 equations of rank 29: 1 free motion; 1 equation is redundant "
          "(joints p0, p1, p2, p3, p4, p5): the motion is unique, forces and moments of these joints are one "
          "choice of many\n");
}

TEST_CASE("A plane leaves the equations that it does not meet", "[check][joint]") {
    const Model in_space = read(two_bodies + joint("p", "\"ground\", \"a\"", about_z) +
                                joint("q", "\"a\", \"b\"", "at = [1, 0, 0]\n" + about_z))
                               .model;
    Model in_plane = in_space;
    in_plane.plane = Plane{2};
    CHECK(only_mechanism(in_space).equations == 10);
    const Mechanism found = only_mechanism(in_plane);
    CHECK(found.equations == 4);
    CHECK(found.redundant == 0);
    CHECK(found.free_motions == 2);
}

TEST_CASE("Motors move free motions, and conflict where they cannot", "[check][joint]") {
    const std::string p = joint("p", "\"ground\", \"a\"", about_z + "move = \"t^2\"\n");
    const std::string q = joint("q", "\"a\", \"b\"", "at = [1, 0, 0]\n" + about_z);
    const Model moved = read(two_bodies + p + q).model;
    const Mechanism found = only_mechanism(moved);
    CHECK(found.motors == 1);
    CHECK(found.equations == 10);
    CHECK(found.free_motions == 2);
    CHECK(found.unmoved == 1);
    CHECK(find_motor_conflicts(moved).empty());
    CHECK(list_mechanisms(moved).items.at(0) ==
          "mechanism: 2 bodies, 2 joints, 10 equations: 2 free motions, with 1 motor that leaves 1\n");
    const Model held =
        read(two_bodies + p + q + joint("r", "\"ground\", \"a\"", "at = [0, 1, 0]\n" + about_z)).model;
    CHECK(only_mechanism(held).conflicting_motors == std::vector{0});
    CHECK(find_motor_conflicts(held) ==
          std::vector<std::string>{"the motor of p moves what joints, supports or other motors hold or move "
                                   "already; leave one out, or drive it by `drive`"});
}

TEST_CASE("A gear ties mechanisms, and can hold what motors move", "[check][joint][gear]") {
    const std::string p = joint("p", "\"ground\", \"a\"", about_z);
    const std::string q = joint("q", "\"ground\", \"b\"", about_z);
    const std::string gear = "[gear.g]\njoints = [\"p\", \"q\"]\nratio = 3\n";
    CHECK(find_mechanisms(read(two_bodies + p + q).model).size() == 2);
    const Model geared = read(two_bodies + p + q + gear).model;
    const Mechanism found = only_mechanism(geared);
    CHECK(found.bodies == std::vector{0, 1});
    CHECK(found.gears == std::vector{0});
    CHECK(list_mechanisms(geared).items.at(0) ==
          "mechanism: 2 bodies, 2 joints, 1 gear, 11 equations: 1 free motion\n");
    const Model twice = read(two_bodies + p + q + gear + replaced(gear, "gear.g", "gear.h")).model;
    CHECK(
        list_mechanisms(twice).items.at(0) ==
        "mechanism: 2 bodies, 2 joints, 2 gears, 12 equations of rank 11: 1 free motion; 1 equation is "
        "redundant (joints gear g, gear h): the motion is unique, forces and moments of these joints are one "
        "choice of many\n");
    const std::string motor = "move = \"t^2\"\n";
    CHECK(find_motor_conflicts(read(two_bodies + p + motor + q + gear).model).empty());
    CHECK(
        find_motor_conflicts(read(two_bodies + p + motor + q + motor + gear).model) ==
        std::vector<std::string>{"the motors of p, q move what joints, supports or other motors hold or move "
                                 "already; leave one out, or drive it by `drive`"});
}

TEST_CASE("Supports hold bodies of mechanisms too", "[check][joint]") {
    const std::string deck = two_bodies + joint("q", "\"a\", \"b\"", "at = [1, 0, 0]\n" + about_z);
    CHECK(only_mechanism(read(deck).model).free_motions == 7);
    const Model held = read(deck +
                            "[[support]]\nat = \"a\"\nfix = [\"position\", \"rx\", \"ry\"]\n"
                            "[[support]]\nat = \"b\"\nfix = \"z\"\n")
                           .model;
    const Mechanism found = only_mechanism(held);
    CHECK(found.free_motions == 2);
    CHECK(found.redundant == 1);
    CHECK(found.has_redundant_supports);
}

TEST_CASE("Bodies on rods and rods are of no mechanism", "[check][joint]") {
    CHECK(find_mechanisms(read_mechanism("rubber_chain")).empty());
    const std::string deck = rod_deck +
                             "[body.a]\nmass = 1\ninertia = [1, 1, 1]\nat = [0, 0, 1]\n"
                             "[body.tip]\nmass = 1\nat = \"r.end\"\n" +
                             joint("p", "\"ground\", \"a\"", about_z) +
                             joint("q", "\"a\", \"r.start\"", about_z) +
                             joint("s", "\"tip\", \"ground\"", about_z);
    const Mechanism found = only_mechanism(read(deck).model);
    CHECK(found.bodies == std::vector{0});
    CHECK(found.joints == std::vector{0});
    CHECK(found.joints_to_rods == 1);
    CHECK(list_mechanisms(read(deck).model).items.at(0) ==
          "mechanism: 1 body, 1 joint and 1 to rods, 5 equations\n");
}

}  // namespace gxrod::test
