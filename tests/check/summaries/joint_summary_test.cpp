#include "check/summaries/joint_summary.hpp"

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// A rod from x = 0 to 10, and a body at (0, 0, 2).
const std::string parts = rod_deck + "[body.b]\nmass = 1\ninertia = [1, 1, 1]\nat = [0, 0, 2]\n";

std::string describe_joint(const std::string& type, const std::string& lines) {
    const Problem problem = read(parts + "[joint.j]\ntype = \"" + type + "\"\n" + lines);
    const std::vector<std::string> items = list_joints(problem.model).items;
    REQUIRE(items.size() == 1);
    return items[0];
}

}  // namespace

TEST_CASE("A joint's line says what it is, where, and what acts on it", "[check][joint]") {
    const std::string ground = "between = [\"ground\", \"b\"]\n";
    CHECK(describe_joint("ball", ground) == "joint j: ball at (0, 0, 2) between the ground and b\n");
    CHECK(describe_joint("hinge", "between = [\"r.end\", \"b\"]\naxis = [0, 0, 2]\n") ==
          "joint j: hinge about (0, 0, 1) at (10, 0, 0) between r.end and b (by an arm of 10.198)\n");
    CHECK(describe_joint("slider", ground + "axis = [0, -2, 0]\nfriction = { force = 3 }\n") ==
          "joint j: slider along (0, -1, 0) at (0, 0, 2) between the ground and b; slide: friction 3\n");
    CHECK(describe_joint("universal", ground + "axis = [1, 0, 0]\naxis_b = [0, 1, 0]\ndrive = 1\n") ==
          "joint j: universal about (1, 0, 0) of A and (0, 1, 0) of B at (0, 0, 2) between the ground and b; "
          "turn: driven\n");
    CHECK(describe_joint("screw", ground + "axis = [1, 0, 0]\nlead = 0.02\n") ==
          "joint j: screw along (1, 0, 0), 0.02 a turn, at (0, 0, 2) between the ground and b\n");
    CHECK(describe_joint("plane", ground + "axis = [1, 0, 0]\n") ==
          "joint j: plane across (1, 0, 0) at (0, 0, 2) between the ground and b\n");
    CHECK(describe_joint("weld", ground) == "joint j: weld at (0, 0, 2) between the ground and b\n");
    CHECK(describe_joint("distance", ground + "at_a = [0, 0, 5]\nat_b = [0, 0, 3]\n") ==
          "joint j: distance of 2 between the ground at (0, 0, 5) and b by an arm of 1 to (0, 0, 3)\n");
    CHECK(describe_joint("cylinder",
                         ground + "axis = [1, 0, 0]\nmove = { turn = \"t^2\" }\n"
                                  "spring = { slide = { stiffness = 2, damping = 0.5 } }\n"
                                  "limits = { slide = { lower = -1, upper = 2, stiffness = 9 } }\n") ==
          "joint j: cylinder along (1, 0, 0) at (0, 0, 2) between the ground and b; turn: moved by a motor; "
          "slide: spring of stiffness 2, damping 0.5, limits -1 to 2 (stiffness 9)\n");
}

TEST_CASE("A free joint's line says along which axis it acts", "[check][joint]") {
    CHECK(describe_joint("free",
                         "between = [\"ground\", \"b\"]\naxis = [0, 0, 3]\nmove = { turn = \"0\" }\n") ==
          "joint j: free about and along (0, 0, 1) at (0, 0, 2) between the ground and b; turn: moved by a "
          "motor\n");
}

TEST_CASE("A sleeve's line says where on which rod it is", "[check][joint][sleeve]") {
    CHECK(
        describe_joint("sleeve",
                       "between = [\"r\", \"ground\"]\nat = [2.5, 0, 0]\nspring = { stiffness = 3 }\n") ==
        "joint j: sleeve at (2.5, 0, 0) between rod r, 2.5 of 10 along it, and the ground; slide: spring of "
        "stiffness 3\n");
}

TEST_CASE("A gear's line has its equation", "[check][gear]") {
    const Problem problem =
        read(parts +
             "[joint.j]\ntype = \"hinge\"\nbetween = [\"ground\", \"b\"]\naxis = [1, 0, 0]\n"
             "[joint.k]\ntype = \"slider\"\nbetween = [\"ground\", \"r.end\"]\naxis = [1, 0, 0]\n"
             "[gear.g]\njoints = [\"j\", \"k\"]\nratio = \"1/4\"\n");
    CHECK(list_gears(problem.model).items ==
          std::vector<std::string>{"gear g: 0.25 × turn of j + slide of k = 0\n"});
}

}  // namespace gxrod::test
