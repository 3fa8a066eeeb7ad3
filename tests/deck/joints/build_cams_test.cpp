#include <algorithm>
#include <cmath>
#include <fstream>

#include "deck/decks.hpp"
#include "machine/temporary_folder.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

// A body with the cam at (0, 0, 2), and one with the roller 4 to its side; lines 1 to 20.
const std::string cam_parts = rod_deck +
                              "[body.b]\nmass = 1\ninertia = [1, 1, 1]\nat = [0, 0, 2]\n"
                              "[body.c]\nmass = 1\ninertia = [1, 1, 1]\nat = [4, 0, 2]\n";

std::string cam_deck(const std::string& lines) {
    return cam_parts + "[joint.j]\ntype = \"cam\"\nbetween = [\"b\", \"c\"]\naxis = [0, 3, 0]\n" + lines;
}

Joint read_cam(const std::string& lines) { return read(cam_deck(lines)).model.joints.at(0); }
std::string cam_faults(const std::string& lines) { return faults_of(cam_deck(lines)); }

const std::string along_x = "x_axis = [2, 0, 0]\n";
const std::string circle = along_x + "curve = { radius = \"3 + 0*angle\" }\nroller = 1\n";

// Points of a circle of radius 3, so many.
std::string circle_points(int count, double sense = 1.0) {
    std::string rows;
    for (int i = 0; i < count; ++i) {
        const double angle = sense * 2.0 * M_PI * i / count;
        rows += (i > 0 ? ", [" : "[") + std::to_string(3.0 * std::cos(angle)) + ", " +
                std::to_string(3.0 * std::sin(angle)) + "]";
    }
    return "[" + rows + "]";
}

}  // namespace

TEST_CASE("A cam has its curve in a plane across its axis", "[deck][joint][cam]") {
    const Joint built = read_cam(circle);
    CHECK(built.kind == JointKind::cam);
    Mat3 axes;
    axes << 0, 1, 0, 1, 0, 0, 0, 0, -1;
    CHECK(built.a.axes.isApprox(axes, 1e-15));
    CHECK(built.b.axes == built.a.axes);
    REQUIRE(built.cam);
    CHECK(built.cam->roller == 1.0);
    CHECK(built.cam->side == 1.0);
    CHECK_FALSE(built.cam->lifts);
    CHECK_FALSE(built.has_stops());
    CHECK(built.cam->curve->is_closed());
    CHECK(built.cam->curve->length() == Approx(6.0 * M_PI).epsilon(1e-12));
    CHECK((built.cam->curve->find_place(1.5 * M_PI).point - PlaneCurve::Point(0, 3)).norm() < 1e-10);
    CHECK(built.b.anchor.arm.norm() < 1e-12);
    // The first of the global axes that are across the axis.
    CHECK(read_cam("curve = { radius = 3 }\nroller = 1\n").a.axes.isApprox(axes, 1e-15));
    CHECK(read_cam(circle + "lifts = true\n").has_stops());
}

TEST_CASE("The radius of a cam is a function of the angle from its x axis", "[deck][joint][cam]") {
    const Joint built =
        read_cam(along_x + "curve = { radius = \"3 + 0.5*sin(angle)^2 + 0.2*sin(angle)^3\" }\nroller = 1\n");
    for (const PlaneCurve::Place& place : built.cam->curve->list_places(3)) {
        const double angle = std::atan2(place.point.y(), place.point.x());
        const double sine = std::sin(angle);
        CHECK(place.point.norm() ==
              Approx(3.0 + 0.5 * sine * sine + 0.2 * sine * sine * sine).epsilon(1e-12));
    }
    CHECK(cam_faults(along_x + "curve = { radius = \"3 + 0.1*angle\" }\nroller = 1\n") ==
          "x.toml:26:20: joint.j.curve.radius: is 3 at angle = 0 and 3.62831853 at 2*pi; expected a curve "
          "that closes");
    CHECK_THAT(
        cam_faults(along_x + "curve = { radius = \"1 - angle\" }\n"),
        Contains("x.toml:26:20: joint.j.curve.radius: is ") && Contains("expected a radius greater than 0"));
    CHECK_THAT(cam_faults(along_x + "curve = { radius = \"1/angle\" }\n"),
               Contains("joint.j.curve.radius: \"1/angle\" is inf at angle = 0"));
    CHECK_THAT(cam_faults(along_x + "curve = { radius = \"3*t\" }\n"),
               Contains("\"t\" (time) is not allowed here: this value is a function of angle"));
    CHECK_THAT(faults_of("parameters = { angle = 2 }\n" + cam_deck(circle)),
               Contains("\"angle\" is the angle about the centre here and also a parameter"));
    CHECK(cam_faults(along_x + "curve = { radius = 3, closed = false }\nroller = 1\n") ==
          "x.toml:26:32: joint.j.curve.closed: a curve by radius is closed; expected points of an open one");
}

TEST_CASE("The curve of a cam goes through points", "[deck][joint][cam]") {
    for (const double sense : {1.0, -1.0}) {
        const Joint built =
            read_cam(along_x + "curve = { points = " + circle_points(60, sense) + " }\nroller = 1\n");
        CHECK(built.cam->side == sense);  // outside
        CHECK(built.cam->curve->length() == Approx(6.0 * M_PI).epsilon(1e-6));
    }
    // The first point again at the end is no other one.
    const std::string again = circle_points(60).substr(0, circle_points(60).size() - 1) + ", [3, 0]]";
    CHECK(read_cam(along_x + "curve = { points = " + again + " }\nroller = 1\n").cam->curve->length() ==
          Approx(6.0 * M_PI).epsilon(1e-6));
    const std::string line = "[[3, -3], [3, -2], [3, -1], [3, 0], [3, 1], [3, 2], [3, 3]]";
    const Joint open = read_cam(along_x + "curve = { points = " + line + ", closed = false }\nroller = 1\n");
    CHECK_FALSE(open.cam->curve->is_closed());
    CHECK(open.cam->curve->length() == Approx(6.0).epsilon(1e-12));
    CHECK(open.cam->side == 1.0);
    CHECK(cam_faults(along_x + "curve = { points = [[3, 0], [0, 3], [-3, 0], [0, -3]] }\nroller = 1\n") ==
          "x.toml:26:20: joint.j.curve.points: expected 6 to 10000 points, found 4");
    CHECK(cam_faults(along_x +
                     "curve = { points = [[3, 0], [2, 2], [2, 2], [0, 3], [-2, 2], [-3, 0], [0, -3]] }\n") ==
          "x.toml:26:20: joint.j.curve.points: points 2 and 3 are both [2, 2]; expected neighbours apart");
    CHECK_THAT(
        cam_faults(along_x + "curve = { points = [[3, 0], [2, 1], [-2, -1], [-3, 0], [-2, 1], [2, -1]] }\n"),
        Contains("joint.j.curve.points: the curve crosses itself near [") &&
            Contains("expected one without crossings"));
}

TEST_CASE("The points of a cam can be in a file", "[deck][joint][cam]") {
    const TemporaryFolder folder("cams");
    const auto write = [&](const char* name, const std::string& text) {
        std::ofstream(folder.path() / name) << text;
    };
    std::string rows = "x,y\n";
    for (int i = 0; i < 60; ++i)
        rows += std::to_string(3.0 * std::cos(M_PI * i / 30)) + ", " +
                std::to_string(3.0 * std::sin(M_PI * i / 30)) + "\n";
    write("round.csv", rows);
    write("narrow.csv", "1\n2\n");
    write("words.csv", "x,y\n1,2\n1,two\n");
    const auto file = [](const std::string& name) {
        return cam_deck(along_x + "curve = { file = \"" + name + "\" }\nroller = 1\n");
    };
    write("deck.toml", file("round.csv"));
    const Problem problem = read_problem(folder.path() / "deck.toml");
    CHECK(problem.model.joints.at(0).cam->curve->length() == Approx(6.0 * M_PI).epsilon(1e-6));
    // A results file keeps it.
    const auto& kept = problem.record.meshes;
    CHECK(std::ranges::any_of(kept, [](const MeshRecord& one) { return one.file == "round.csv"; }));
    CHECK(rebuild_problem(problem.record, {}).model.joints.at(0).cam->curve->length() ==
          problem.model.joints.at(0).cam->curve->length());
    const auto message = [&](const std::string& name) {
        write("deck.toml", file(name));
        try {
            read_problem(folder.path() / "deck.toml");
        } catch (const std::exception& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK_THAT(message("none.csv"), Contains("joint.j.curve.file") && Contains("none.csv"));
    CHECK_THAT(message("narrow.csv"), Contains("narrow.csv:1: expected 2 columns, found 1"));
    CHECK_THAT(message("words.csv"), Contains("words.csv:3: expected a finite number, found \"two\""));
}

TEST_CASE("The roller of a cam touches its curve at t = 0", "[deck][joint][cam]") {
    CHECK(cam_faults(along_x + "curve = { radius = 3 }\nroller = 0.5\n") ==
          "x.toml:27:10: joint.j.roller: B's point is 1 from the curve at t = 0; expected the roller's "
          "radius, 0.5, as at_b = [3.5, 0, 2] is");
    CHECK(cam_faults(along_x + "curve = { radius = 3 }\nroller = 1.5\nlifts = true\n") ==
          "x.toml:27:10: joint.j.roller: B's point is 1 from the curve at t = 0; expected the roller's "
          "radius, 1.5, or more, as at_b = [4.5, 0, 2] is");
    CHECK_THAT(cam_faults(along_x + "curve = { radius = 3 }\n"),
               Contains("joint.j.roller: B's point is 1 from the curve"));
    CHECK(cam_faults(along_x + "curve = { radius = 3 }\nroller = 0.5\nlifts = true\n").empty());
    // Rounding of its numbers is taken up.
    const Joint near = read_cam(along_x + "curve = { radius = 3 }\nroller = 0.5\nat_b = [3.500001, 1, 2]\n");
    CHECK(near.b.anchor.arm.isApprox(Vec3(-0.5, 1, 0), 1e-12));
    // Inside of a ring, and a knife edge.
    CHECK(read_cam(along_x + "curve = { radius = 5 }\nroller = 1\n").cam->side == -1.0);
    CHECK(read_cam(along_x + "curve = { radius = 4 }\n").cam->side == 1.0);
    CHECK(read_cam(along_x + "curve = { radius = 3 }\nroller = 0.5\nat_a = [0.5, 0, 2]\n").a.anchor.arm ==
          Vec3(0.5, 0, 0));
}

TEST_CASE("The roller of a cam fits on its curve everywhere", "[deck][joint][cam]") {
    // Hollow with a radius of 1/3 on both sides.
    const std::string waist = along_x + "curve = { radius = \"2 + cos(2*angle)\" }\n";
    CHECK(cam_faults(waist + "roller = 1\n")
              .find("joint.j.roller: the roller does not fit on the curve near") != std::string::npos);
    CHECK_THAT(
        cam_faults(waist + "roller = 1\n"),
        Contains("the curve is hollow there with a radius of") && Contains("expected a smaller roller"));
    CHECK_THAT(cam_faults(waist + "roller = 1\nlifts = true\n"), Contains("does not fit"));
    CHECK(cam_faults(waist + "roller = 0.1\nat_b = [3.1, 0, 2]\n").empty());
    // A gap that is too narrow between arms that are not hollow themselves.
    CHECK_THAT(cam_faults(along_x + "curve = { radius = 5 }\nroller = 5\nat_b = [0.01, 0, 2]\n"),
               Contains("joint.j.roller: "));
}

TEST_CASE("A cam has keys of its own", "[deck][joint][cam]") {
    CHECK_THAT(cam_faults("roller = 1\n"), Contains("joint.j.curve: missing"));
    CHECK_THAT(cam_faults("curve = { closed = true }\n"), Contains("points, file") || Contains("points"));
    CHECK_THAT(cam_faults(circle + "slack = true\n"), Contains("does not use this key"));
    CHECK_THAT(cam_faults(circle + "move = \"t\"\n"), Contains("does not use this key"));
    CHECK_THAT(cam_faults("x_axis = [1, 1, 0]\ncurve = { radius = 3 }\nroller = 1\n"),
               Contains("joint.j.x_axis: expected a direction at right angles to axis"));
    CHECK_THAT(cam_faults("curve = { radius = 3 }\nroller = 1\ncopies = { count = 2, about = [0, 1, 0] }\n"),
               Contains("copies of a cam need x_axis, which is turned with them"));
    const auto history = [](const std::string& quantity) {
        return "[[history]]\nname = \"h\"\nat = \"j\"\nquantities = [\"" + quantity + "\"]\n";
    };
    for (const char* quantity : {"normal_force", "curve_place", "curve_gap"}) {
        CHECK(cam_faults(circle + history(quantity)).empty());
        CHECK_THAT(faults_of(cam_parts + "[joint.j]\ntype = \"ball\"\nbetween = [\"ground\", \"b\"]\n" +
                             history(quantity)),
                   Contains("this joint has no curve; a cam has one"));
    }
}

TEST_CASE("A roller that can lift needs an implicit scheme", "[deck][joint][cam]") {
    const std::string explicit_deck = replaced(
        cam_deck(circle + "lifts = true\n"), "steps = 10\n", "steps = 10\nintegrator = \"runge-kutta-4\"\n");
    CHECK_THAT(faults_of(explicit_deck),
               Contains("joint.j.lifts: a roller cannot come back to its curve in runge-kutta-4, an explicit "
                        "scheme; expected an implicit one, or lifts = false"));
    CHECK(faults_of(replaced(explicit_deck, "lifts = true", "lifts = false")).empty());
}

}  // namespace gxrod::test
