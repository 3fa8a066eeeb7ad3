#include "deck/ties/ties.hpp"

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// A rod from x = 0 to 10, and a body at (0, 0, 2); lines 1 to 16, the bushing's keys begin in line 18.
const std::string bodies = rod_deck + "[body.b]\nmass = 1\ninertia = [1, 1, 1]\nat = [0, 0, 2]\n";

std::string bushing(const std::string& lines) { return bodies + "[bushing.m]\n" + lines; }

const std::string matrix_of_damping =
    "damping_matrix = "
    "[[1,0,0,0,0,0],[0,1,0,0,0,0],[0,0,1,0,0,0],[0,0,0,1,0,0],[0,0,0,0,1,0],[0,0,0,0,0,1]]\n";

}  // namespace

TEST_CASE("A bushing is where the deck says, or where its nodes are", "[deck]") {
    const Problem apart =
        read(bushing("between = [\"r.start\", \"b\"]\nat = [0, 1, 2]\nstiffness = { x = 3 }\n"));
    const Bushing& between = apart.model.bushings.at(0);
    CHECK(find_place(apart.model, between.ends[0]) == Vec3(0, 1, 2));
    CHECK(find_place(apart.model, between.ends[1]) == Vec3(0, 1, 2));
    CHECK(between.ends[1].arm == Vec3(0, 1, 0));
    const Problem held = read(bushing("between = [\"b\", \"ground\"]\ndamping = { rz = 3 }\n"));
    const Bushing& grounded = held.model.bushings.at(0);
    CHECK(grounded.has_ground());
    CHECK(grounded.ends[0].arm == Vec3::Zero());
    CHECK(find_place(held.model, grounded.ends[1]) == Vec3(0, 0, 2));
    CHECK(grounded.stiffness == Mat6(Mat6::Zero()));
    CHECK(grounded.damping(5, 5) == 3.0);
    CHECK(grounded.damping.sum() == 3.0);
}

TEST_CASE("A bushing has the axes and matrices of its keys", "[deck]") {
    const std::string ends = "between = [\"ground\", \"b\"]\n";
    const std::string rows = " = [[0, 1, 0], [0, 0, 1], [1, 0, 0]]\n";
    const std::string components = " = { x = 1, y = 2, z = 3, rx = 4, ry = 5, rz = 6 }\n";
    const std::string matrix =
        "_matrix = [[9,0,0,0,0,0],[0,2,0,0,0,1],[0,0,3,0,0,0],[0,0,0,4,0,0],[0,0,0,0,5,0],[0,1,0,0,0,6]]\n";
    const Mat6 diagonal = Vec6(1, 2, 3, 4, 5, 6).asDiagonal();
    Mat6 full = diagonal;
    full(0, 0) = 9.0;
    full(1, 5) = full(5, 1) = 1.0;
    const auto built = [&](const std::string& lines) {
        return read(bushing(ends + lines)).model.bushings.at(0);
    };
    const Bushing own = built("axes" + rows + "stiffness" + components + "damping" + matrix);
    CHECK((own.axes * Vec3::UnitX() - Vec3::UnitY()).norm() < 1e-15);
    CHECK(own.carrier == BushingAxes::between);
    CHECK(own.stiffness == diagonal);
    CHECK(own.damping == full);
    const Bushing carried =
        built("axes = \"b\"\ndirections" + rows + "stiffness" + matrix + "damping" + components);
    CHECK((carried.axes * Vec3::UnitX() - Vec3::UnitY()).norm() < 1e-15);
    CHECK(carried.carrier == BushingAxes::b);
    CHECK(carried.stiffness == full);
    CHECK(carried.damping == diagonal);
}

TEST_CASE("Bushings that cannot be are errors", "[deck]") {
    const auto faults = [](const std::string& lines) { return faults_of(bushing(lines)); };
    const std::string k = "stiffness = { x = 1 }\n";
    CHECK(faults("between = [\"r.start\", \"b\"]\n" + k) ==
          "x.toml:18:11: bushing.m.between: the nodes are 2 apart; expected at = [x, y, z], the bushing's "
          "place");
    CHECK(faults("between = [\"r.start\", \"r@0\"]\n" + k) ==
          "x.toml:18:11: bushing.m.between: \"r.start\" and \"r@0\" are one node, whose points keep their "
          "distance");
    CHECK(faults("between = [\"r.end\", \"bb\"]\nat = [0, 0, 0]\n" + k) ==
          "x.toml:18:21: bushing.m.between[1]: no point \"bb\"; the deck has r.start, r.end, b");
    CHECK(faults("between = [\"ground\", \"b\"]\n") ==
          "x.toml:17:1: bushing.m: missing; expected stiffness = { … } or stiffness_matrix or damping = { … "
          "} or damping_matrix");
    CHECK(faults("between = [\"ground\", \"b\"]\ndamping = { x = 1 }\n" + matrix_of_damping) ==
          "x.toml:20:1: bushing.m.damping_matrix: damping is given too; only one of them can be");
    CHECK(faults("between = [\"ground\", \"b\"]\nstiffness = { x = -1 }\n") ==
          "x.toml:19:19: bushing.m.stiffness.x: expected a number at least 0, found -1");
    CHECK(faults("between = [\"ground\", \"b\"]\naxes = [[1, 0, 0], [0, 1, 0], [0, 0, 2]]\n" + k) ==
          "x.toml:19:8: bushing.m.axes: expected three rows of length 1 at right angles to each other, "
          "right-handed; the third row has length 2");
}

TEST_CASE("A bushing's matrix is symmetric and gives no negative energy", "[deck]") {
    const auto faults = [](const std::string& matrix) {
        return faults_of(bushing("between = [\"ground\", \"b\"]\nstiffness_matrix = " + matrix + "\n"));
    };
    const std::string rest = ",[0,0,1,0,0,0],[0,0,0,1,0,0],[0,0,0,0,1,0],[0,0,0,0,0,0]]";
    CHECK(faults("[[1,1,0,0,0,0],[1,1,0,0,0,0]" + rest).empty());  // semidefinite, and none about z
    CHECK(faults("[[1,2,0,0,0,0],[2,1,0,0,0,0]" + rest) ==
          "x.toml:19:20: bushing.m.stiffness_matrix: this matrix gives a negative energy to the displacement "
          "x 1, y -1");
    CHECK(
        faults("[[1,2,0,0,0,0],[3,9,0,0,0,0]" + rest) ==
        "x.toml:19:20: bushing.m.stiffness_matrix[1][0]: expected a symmetric matrix, found 3 here and 2 at "
        "[0][1]");
    CHECK(
        faults("[[-1,0,0,0,0,0],[0,1,0,0,0,0]" + rest) ==
        "x.toml:19:20: bushing.m.stiffness_matrix[0][0]: expected no negative number on the diagonal, found "
        "-1");
}

TEST_CASE("Histories of bushings have their quantities", "[deck]") {
    const std::string deck = bushing("between = [\"ground\", \"b\"]\nstiffness = { x = 1 }\n");
    const auto history = [](const std::string& lines) {
        return "[[history]]\nname = \"h\"\nat = \"m\"\n" + lines;
    };
    const Problem problem = read(deck + history("quantities = [\"displacement\", \"moment_spatial\"]\n"));
    CHECK(is_tie(problem.output.histories[0].target, TieKind::bushing));
    CHECK(std::get<WatchedTie>(problem.output.histories[0].target).index == 0);
    CHECK(faults_of(deck + history("quantities = \"velocity\"\n")) ==
          "x.toml:23:14: history[0].quantities: \"velocity\": a bushing does not have it");
    CHECK(
        faults_of(deck + history("relative_to = \"b\"\nquantities = \"displacement\"\n")) ==
        "x.toml:24:14: history[0].quantities: \"displacement\": cannot be relative to a point; write another "
        "history for it");
}

}  // namespace gxrod::test
