#include "analyses/static.hpp"
#include "check/findings/plane_findings.hpp"
#include "deck/decks.hpp"
#include "tools/catch.hpp"

using namespace gxrod;
using test::faults_of;
using test::read;
using test::replaced;

namespace {

const std::string arm = R"([section.s]
stiffness = { EA = 1e4, GAy = 2e4, GAz = 3e4, GJ = 500, EIy = 600, EIz = 700 }
[rod.r]
section = "s"
line = { from = [0, 0, 2], to = [10, 0, 2] }
elements = 5
order = 2
[[support]]
at = "r.start"
fix = "all"
[[load]]
at = "r.end"
force = [3, 40, 0]
[analysis]
kind = "static"
newton = { tolerance = 1e-12 }
)";

const std::string in_plane = "plane = \"xy\"\n" + arm;

}  // namespace

TEST_CASE("A model in its plane has three unknowns a node and the same equilibrium", "[deck][plane]") {
    const Problem free = read(arm);
    const Problem plane = read(in_plane);
    StaticAnalysis in_space(free.model, std::get<StaticSettings>(free.analysis()));
    StaticAnalysis flat(plane.model, std::get<StaticSettings>(plane.analysis()));
    CHECK(flat.system().equations().count() * 2 == in_space.system().equations().count());
    for (StaticAnalysis* analysis : {&in_space, &flat}) {
        REQUIRE(analysis->start().converged());
        while (!analysis->finished()) REQUIRE(analysis->advance().converged());
    }
    const NodeMotion& a = in_space.state().previous.back();
    const NodeMotion& b = flat.state().previous.back();
    CHECK((a.r - b.r).norm() < 1e-11);
    CHECK(a.Lambda.angularDistance(b.Lambda) < 1e-11);
    CHECK(b.r[1] > 4.0);
}

TEST_CASE("What leaves the plane of a deck is a fault", "[deck][plane]") {
    CHECK(faults_of(replaced(in_plane, "to = [10, 0, 2]", "to = [10, 0, 3]")) ==
          "x.toml:4:1: rod.r: leaves the plane xy of the deck: r node 1 is off it by 0.1");
    CHECK(
        faults_of(replaced(in_plane, "elements = 5", "elements = 5\ny_axis = [0, 1, 1]")) ==
        "x.toml:4:1: rod.r: its section leans out of the plane xy of the deck; expected the section's y or z "
        "across it");
    CHECK(faults_of(replaced(in_plane, "fix = \"all\"", "fix = [\"x\", \"y\"]\nmove = { z = \"t\" }")) ==
          "x.toml:12:8: support[0].move: z moves out of the plane xy of the deck");
    CHECK(
        faults_of(replaced(
            in_plane, "fix = \"all\"", "fix = \"all\"\naxes = [[1, 0, 0], [0, 0.6, 0.8], [0, -0.8, 0.6]]")) ==
        "x.toml:12:8: support[0].axes: expected one of the axes across the plane xy of the deck");
    CHECK(faults_of(replaced(in_plane, "\"xy\"", "\"yx\"")).find("expected one of \"yz\", \"xz\", \"xy\"") !=
          std::string::npos);
}

TEST_CASE("A model that lies in a plane gets the advice to stay there", "[deck][plane]") {
    CHECK(suggest_plane(read(arm).model)
              .starts_with("all of this lies in a plane: plane = \"xy\" keeps it there"));
    CHECK(suggest_plane(read(in_plane).model).empty());
    const auto advice = [](const std::string& from, const std::string& to) {
        return suggest_plane(read(replaced(arm, from, to)).model);
    };
    CHECK(advice("[3, 40, 0]", "[3, 40, 1]").empty());
    CHECK(advice("[3, 40, 0]", "[3, 40, 0]\nmoment = [1, 0, 0]").empty());
    CHECK(advice("[10, 0, 2]", "[10, 0, 3]").find("plane = \"xz\"") == std::string::npos);
    CHECK(advice("elements = 5", "elements = 5\ny_axis = [0, 1, 1]").empty());
}

TEST_CASE("What pushes out of the plane of a deck is named", "[deck][plane]") {
    CHECK(find_push_out_of_plane(read(in_plane).model).empty());
    CHECK(find_push_out_of_plane(read(replaced(in_plane, "[3, 40, 0]", "[3, 40, 1]")).model) ==
          "load[0] pushes out of the plane xy of the deck, which holds against it; only reactions feel it");
}

TEST_CASE("What acts within rods is named where it pushes out of the plane", "[deck][plane]") {
    const std::string warm = replaced(in_plane, "[section.s]", "[section.s]\nexpansion = 1e-5");
    const auto pusher = [&](const std::string& added) {
        const std::string push = find_push_out_of_plane(read(warm + added).model);
        return push.substr(0, push.find(' '));
    };
    // Section y is in the plane, z along its normal.
    REQUIRE(read(in_plane).model.rods.front().triads.front().isApprox(Quat::Identity()));
    const std::string rod = read(in_plane).model.rods.front().name;
    const std::string muscle = "[[actuation]]\non = \"" + rod + "\"\n";
    CHECK(pusher(muscle + "stretch = 0.1\ncurvature = [0, 0, \"0.2*s\"]\nshear = [0.1, 0]\n") == "");
    CHECK(pusher(muscle + "curvature = [0, 0.2, 0]\n") == "actuation[0]");
    CHECK(pusher(muscle + "curvature = [0.2, 0, 0]\n") == "actuation[0]");
    CHECK(pusher(muscle + "shear = [0, 0.1]\n") == "actuation[0]");
    CHECK(pusher(muscle + "temperature_gradient = [3, 0]\n") == "");
    CHECK(pusher(muscle + "temperature_gradient = [0, 3]\n") == "actuation[0]");
    const std::string tendon = "[tendon.t]\non = \"" + rod + "\"\ntension = 1\noffset = ";
    CHECK(pusher(tendon + "[0.1, 0]\n") == "");
    CHECK(pusher(tendon + "[0, 0.1]\n") == "tendon.t");
    CHECK(pusher(tendon + "[0, \"0.1*sin(s)\"]\n") == "tendon.t");
    const auto bent = [&](const std::string& curvature) {
        const std::string with_rest =
            replaced(in_plane, "elements = 5", "elements = 5\nrest = { curvature = " + curvature + " }");
        return find_push_out_of_plane(read(with_rest).model);
    };
    CHECK(bent("[0, 0, 0.3]").empty());
    CHECK_THAT(bent("[0, 0.3, 0]"), Catch::Contains("rod." + rod + ".rest pushes"));
}
