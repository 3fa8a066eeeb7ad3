#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

const std::string dynamic = "[analysis]\nkind = \"dynamic\"\nend_time = 1\ntime_step = 0.1\n";
const std::string circle =
    "shape = { circle = { radius = 0.01 } }\nmaterial = { E = 1e9, nu = 0.3, density = 1000 }\n";
const std::string constants =
    "stiffness = { EA = 1, GAy = 1, GAz = 1, GJ = 1, EIy = 1, EIz = 1 }\n"
    "inertia = { rhoA = 1, rhoIy = 1, rhoIz = 1 }\n";
const std::string floor = "[obstacle.floor]\nplane = { point = [0, 0, -1], normal = [0, 0, 1] }\n";

// Of a square below, with one that is a line and one that is there already.
const std::string two_triangles = [] {
    std::string text = "solid square\n";
    for (const char* corners : {"0 0 -1/1 0 -1/1 1 -1",
                                "0 0 -1/1 0 -1/0.5 0 -1",
                                "1 0 -1/1 1 -1/0 0 -1",
                                "0 0 -1/1 1 -1/0 1.0e0 -1"}) {
        text += "facet normal 0 0 1\nouter loop\nvertex ";
        for (const char* letter = corners; *letter != '\0'; ++letter)
            text += *letter == '/' ? std::string("\nvertex ") : std::string(1, *letter);
        text += "\nendloop\nendfacet\n";
    }
    return text + "endsolid\n";
}();

std::string deck(const std::string& more,
                 const std::string& section = circle,
                 const std::string& analysis = dynamic) {
    return "[section.s]\n" + section +
           "[rod.a]\nsection = \"s\"\nline = { from = [0, 0, 0], to = [1, 0, 0] }\nelements = 4\n" + more +
           analysis;
}

std::string faults(const std::string& more,
                   const std::string& section = circle,
                   const std::string& analysis = dynamic) {
    return faults_of(deck(more, section, analysis));
}

}  // namespace

TEST_CASE("What touches has a radius", "[deck][touch]") {
    CHECK_THAT(
        faults(floor, constants),
        Contains("x.toml:4:1: rod.a: touches obstacles, but its section has no radius; expected `radius`"));
    CHECK(read(deck(floor, constants + "radius = 0.2\n")).model.contact.radii == std::vector{0.2});
    CHECK(read(deck(floor)).model.contact.radii == std::vector{0.01});
    CHECK(read(deck("", constants)).model.contact.is_empty());
}

TEST_CASE("Obstacles that cannot be are reported", "[deck][touch]") {
    CHECK_THAT(faults("[obstacle.o]\nplane = { point = [0, 0, 0], normal = [0, 0, 0] }\n"),
               Contains("obstacle.o.plane.normal: expected a direction, found a vector of zero length"));
    CHECK_THAT(faults("[obstacle.o]\ncylinder = { from = [0, 0, 1], to = [0, 0, 1], radius = 0.1 }\n"),
               Contains("obstacle.o.cylinder.to: expected an end away from its start"));
    CHECK_THAT(faults("[obstacle.o]\nsphere = { centre = [0, 0, 0], radius = 0.01, side = \"inside\" }\n"),
               Contains("obstacle.o: a rod of radius 0.01 is to be inside"));
    CHECK_THAT(faults("[obstacle.o]\nfriction = 1\n"), Contains("obstacle.o: missing; expected plane = "));
    CHECK_THAT(faults("[obstacle.a]\nplane = { point = [0, 0, -1], normal = [0, 0, 1] }\n"),
               Contains("has this name too"));
    CHECK_THAT(faults(floor + "move = { z = \"1 + t\" }\n"), Contains("obstacle.floor.move.z"));
}

TEST_CASE("Friction by direction and speed says what it lacks", "[deck][touch]") {
    const auto of_friction = [](const std::string& keys) {
        return faults(floor + "friction = { " + keys + " }\n");
    };
    CHECK_THAT(of_friction("static = 0.4, kinetic = 0.3"),
               Contains("obstacle.floor.friction.kinetic: says how much is left at great speed; expected "
                        "`stribeck_speed` with it"));
    CHECK_THAT(of_friction("static = 0.4, stribeck_speed = 0.1"),
               Contains("obstacle.floor.friction.stribeck_speed: expected `kinetic` with it"));
    CHECK_THAT(
        of_friction("static = 0.4, kinetic = 0.5, stribeck_speed = 0.1"),
        Contains("obstacle.floor.friction.kinetic: friction that grows with the speed is not there yet; "
                 "expected at most 0.4"));
    CHECK_THAT(of_friction("forward = 0.1"), Contains("obstacle.floor.friction: missing; expected"));
    CHECK_THAT(of_friction("static = 0.4, across = 0.3"), Contains("obstacle.floor.friction"));
    CHECK_THAT(of_friction("static = 0.4, forward = 0.3"), Contains("obstacle.floor.friction"));
    CHECK_THAT(of_friction("static = 0.4, backward = 0.3"), Contains("obstacle.floor.friction"));
    const std::string weak = floor + "friction = { static = 0.4, kinetic = 0.3, stribeck_speed = 0.1 }\n";
    for (const std::string scheme : {"time_step = 0.1\nintegrator = \"radau-5\"",
                                     "time_step = 0.1\nintegrator = \"sdirk-4\"",
                                     "accuracy = 1e-3"})
        CHECK_THAT(
            faults(weak, circle, "[analysis]\nkind = \"dynamic\"\nend_time = 1\n" + scheme + "\n"),
            Contains("friction that falls with the speed (`kinetic`) does not go with schemes that resolve "
                     "impacts; expected integrator = \"generalized-alpha\" or \"newmark-simplified\""));
    CHECK(faults(weak).empty());
    // What is left out: backward as forward, and along as across.
    const auto shape_of = [](const std::string& keys) {
        return read(deck(floor + "friction = { " + keys + " }\n"))
            .model.contact.obstacles.at(0)
            .friction_shape;
    };
    CHECK(shape_of("across = 0.4, forward = 0.1") == FrictionShape{0.25, 0.25, 1.0});
    CHECK(shape_of("across = 0.4").is_plain());
    CHECK(shape_of("static = 0.4, kinetic = 0.4, stribeck_speed = 1").is_plain());
    CHECK(shape_of("across = 0, forward = 0").is_plain());
}

TEST_CASE("Pairs of contact name rods, parts of them and obstacles", "[deck][touch]") {
    const auto pair = [](const std::string& between, const std::string& more = "off = true") {
        return floor + "[contact]\n[[contact.pair]]\nbetween = [" + between + "]\n" + more + "\n";
    };
    const auto parts = [&](const std::string& between) {
        return read(deck(pair(between))).model.contact.exceptions.at(0).between;
    };
    CHECK(parts("\"a\", \"floor\"")[1].at(0).index == -1);
    CHECK(parts("\"*\", \"f*o*\"")[0].size() == 2);
    // Obstacles have no parts: the * stands for rods alone.
    CHECK(parts("\"*@0..0.5\", \"floor\"")[0].size() == 1);

    CHECK_THAT(
        faults(pair("\"a\", \"flor\"")),
        Contains("x.toml:12:17: contact.pair[0].between[1]: no rod and no obstacle \"flor\"; did you mean "
                 "\"floor\"?"));
    CHECK_THAT(faults(pair("\"z*\", \"floor\"")),
               Contains("no rod and no obstacle \"z*\"; the deck has a, floor"));
    CHECK_THAT(faults(pair("\"a@0.5\", \"floor\"")),
               Contains("expected two rising fractions from 0 to 1 after \"@\", such as \"a@0.9..1\", found "
                        "\"0.5\""));
    CHECK_THAT(faults(pair("\"a@0.5..0.2\", \"floor\"")), Contains("found \"0.5..0.2\""));
    // Elements end where the part ends; with too few of them there is none for each piece.
    const Rod rod = read(deck(pair("\"a@0.5..0.6\", \"floor\""))).model.rods.at(0);
    CHECK(std::ranges::count_if(rod.arc_length, [](double s) { return std::abs(s - 0.6) < 1e-12; }) == 2);
    CHECK(rod.element_count() == 4);
    CHECK_THAT(
        faults(pair("\"a@0.1..0.2\", \"floor\"]\noff = true\n[[contact.pair]]\nbetween = [\"a@0.5..0.6\", "
                    "\"floor\"")),
        Contains("rod.a.elements: expected at least 5, one for each piece between"));
    CHECK_THAT(faults(pair("\"floor@0..0.5\", \"a\"")),
               Contains("\"floor\" is an obstacle; only rods have parts"));
    CHECK_THAT(faults(pair("\"floor\", \"floor\"")),
               Contains("\"floor\" and \"floor\" do not touch: [contact] leaves them out"));
    CHECK_THAT(faults(pair("\"a\"")), Contains("expected an array of 2 names of rods and obstacles"));
    CHECK_THAT(faults(pair("\"a\", \"floor\"", "friction = 0.1\noff = true")),
               Contains("friction is given too; only one of them can be"));
    CHECK_THAT(faults(pair("\"a\", \"floor\"", "")),
               Contains("contact.pair[0]: missing; expected friction or restitution or off"));
    CHECK_THAT(faults(pair("\"a\", \"floor\"", "friction = -1")), Contains("expected a number at least 0"));
}

TEST_CASE("What a pair leaves out needs no room, and has no histories", "[deck][touch]") {
    const std::string ball =
        "[obstacle.o]\nsphere = { centre = [0, 0, 0], radius = 0.01, side = \"inside\" }\n";
    const std::string off = "[contact]\n[[contact.pair]]\nbetween = [\"a\", \"o\"]\noff = true\n";
    CHECK_NOTHROW(read(deck(ball + off)));
    CHECK_THAT(faults(ball + off + "[[contact.pair]]\nbetween = [\"a@0..0.5\", \"o\"]\noff = false\n"),
               Contains("a rod of radius 0.01 is to be inside"));
    CHECK_THAT(faults(ball + off +
                      "[[history]]\nname = \"h\"\nat = \"a\"\nwith = \"o\"\nquantities = \"least_gap\"\n"),
               Contains("history[0].with: \"a\" does not touch \"o\": [[contact.pair]] leaves it out"));
}

TEST_CASE("Meshes that cannot be are reported", "[deck][touch]") {
    const auto mesh = [](const std::string& file, const std::string& more = "") {
        return "[obstacle.o]\nmesh = { file = \"" + file + "\"" + more + " }\n";
    };
    const auto fault = [&](const std::string& name, const std::string& text) {
        const ScratchFile file(name, text);
        return faults(mesh(file.path().string()));
    };
    CHECK_THAT(faults(mesh("none.stl")),
               Contains("x.toml:9:17: obstacle.o.mesh.file: none.stl: cannot be read (No such file"));
    CHECK_THAT(fault("a.obj", ""), Contains("has another ending than .stl and .msh"));
    CHECK_THAT(fault("a.stl", "v 0 0 0\n"), Contains("is not STL: it neither starts with \"solid\" nor"));
    CHECK_THAT(fault("a.msh", "v 0 0 0\n"), Contains("is no mesh; a .msh file starts with $MeshFormat"));
    CHECK_THAT(fault("a.stl", "solid s\nendsolid s\n"), Contains("has no triangles"));
    CHECK_THAT(fault("a.stl", "solid s\nvertex 0 0 x\n"),
               Contains("line 2: expected three numbers after vertex, found \"x\""));
    CHECK_THAT(fault("a.stl", "solid s\nvertex 0 0 0\nendloop\n"),
               Contains("line 3: expected triangles, found 1 corners"));
    const ScratchFile good("a.stl", two_triangles);
    CHECK_THAT(faults(mesh(good.path().string(), ", scale = 0")), Contains("obstacle.o.mesh.scale"));
    CHECK_THAT(faults(mesh(good.path().string()) + "stiffness = 1\n"),
               Contains("obstacle.o.stiffness: a mesh does not yield"));
}

TEST_CASE("What is in a mesh is noted", "[deck][touch]") {
    const ScratchFile file("a.stl", two_triangles);
    const Problem problem = read(deck("[obstacle.o]\nmesh = { file = \"" + file.path().string() + "\" }\n"));
    CHECK_THAT(problem.notes,
               Catch::VectorContains(file.path().string() +
                                     ": 2 triangles, 4 open edges, 1 without area left out, 1 "
                                     "repeated ones left out; nothing is inside or outside: both "
                                     "sides stop rods"));
    const TriangleMesh& mesh = *problem.model.contact.obstacles.at(0).mesh();
    CHECK(mesh.positions.size() == 5);  // one of them of the line
    CHECK(mesh.numbers == std::vector{1, 4});
    SECTION("and goes with the results") {
        REQUIRE(problem.record.meshes.size() == 1);
        CHECK(problem.record.meshes[0].bytes == two_triangles);
        CHECK(rebuild_problem(problem.record).model.contact.obstacles.at(0).mesh()->positions ==
              mesh.positions);
    }
}

TEST_CASE("What rounding makes of a mesh is noted, and where it may be missing", "[deck][touch]") {
    // A quarter of a round bar below, by four facets: three edges turn by π/8.
    constexpr int facets = 4;
    std::string text = "solid bar\n";
    const auto corner = [](int i, double x) {
        const double angle = 0.5 * M_PI * i / facets;
        return fmt::format("vertex {} {:.9f} {:.9f}\n", x, std::cos(angle), std::sin(angle) - 5.0);
    };
    for (int i = 0; i < facets; ++i) {
        for (const std::string& corners : {corner(i, 0) + corner(i + 1, 0) + corner(i, 3),
                                           corner(i, 3) + corner(i + 1, 0) + corner(i + 1, 3)})
            text += "facet normal 0 0 0\nouter loop\n" + corners + "endloop\nendfacet\n";
    }
    const ScratchFile bar("bar.stl", text + "endsolid bar\n"), flat("flat.stl", two_triangles);
    const auto with = [](const ScratchFile& file, const std::string& more) {
        return read(deck("[obstacle.o]\nmesh = { file = \"" + file.path().string() + "\"" + more + " }\n"));
    };
    const std::string hint =
        ": 3 edges turn by 0.1 to 0.39 and count as sharp; if the facets stand for a curved "
        "surface, smooth = true rounds them";
    CHECK_THAT(with(bar, "").notes, Catch::VectorContains(bar.path().string() + hint));
    for (const auto& [file, more] : {std::pair(&bar, ", feature_angle = 0.2"), std::pair(&flat, "")}) {
        for (const std::string& note : with(*file, more).notes) CHECK_THAT(note, !Contains("smooth"));
    }
    const Problem round = with(bar, ", smooth = true");
    // Facets of 22.5 degrees become three; those at both ends have one neighbour and bow by half.
    CHECK_THAT(
        round.notes,
        Catch::VectorContains(bar.path().string() +
                              ": rounded into 72 triangles, which stand off its facets by up to 0.0172"));
    CHECK(round.model.contact.obstacles.at(0).mesh()->triangles.size() == 72);
    CHECK_THAT(with(flat, ", smooth = true").notes,
               Catch::VectorContains(flat.path().string() + ": no edge to round; smooth has no effect"));
}

TEST_CASE("Analyses that contact does not go with are reported", "[deck][touch]") {
    const auto with = [&](const std::string& analysis) {
        return faults(floor, circle, "[analysis]\n" + analysis);
    };
    for (const char* scheme : {"gauss-4", "runge-kutta-4", "energy-momentum"})
        CHECK_THAT(with("kind = \"dynamic\"\nend_time = 1\ntime_step = 0.1\nintegrator = \"" +
                        std::string(scheme) + "\"\n"),
                   Contains("analysis.integrator: this scheme does not go with contact"));
    const std::string motion = "[analysis]\nkind = \"dynamic\"\nend_time = 1\n";
    CHECK_NOTHROW(read(deck(floor, circle, motion + "accuracy = 1e-3\n")));
    CHECK_NOTHROW(read(deck(floor, circle, motion + "time_step = 0.1\nintegrator = \"sdirk-4\"\n")));
    CHECK_NOTHROW(read(deck(floor, circle, "[analysis]\nkind = \"path\"\nuntil = { steps = 3 }\n")));
    CHECK_THAT(faults(floor + "move = { z = \"0.01*t\" }\n",
                      circle,
                      "[analysis]\nkind = \"path\"\nuntil = { steps = 3 }\n"),
               Contains("a path cannot move obstacle floor"));
    CHECK_NOTHROW(read(deck(floor, circle, "[analysis]\nkind = \"static\"\n")));
    const Problem chosen =
        read(deck(floor,
                  circle,
                  "[analysis]\nkind = \"dynamic\"\nend_time = 1\ntime_step = 0.1\nintegrator = \"auto\"\n"));
    CHECK(std::get<DynamicSettings>(chosen.analysis()).scheme == Scheme::generalized_alpha);
    const std::string damped = "kind = \"dynamic\"\nend_time = 1\ntime_step = 0.1\ngamma = 0.6\n";
    CHECK_THAT(with(damped + "beta = 0.3025\n"),
               Contains("analysis.beta") && Contains("expected beta = 0.3"));
    CHECK_THAT(with(damped), Contains("analysis.gamma") && Contains("expected beta = 0.3"));
    CHECK_NOTHROW(read(deck(floor, circle, "[analysis]\n" + damped + "beta = 0.3\n")));
}

TEST_CASE("Histories of obstacles have quantities of their own", "[deck][touch]") {
    const auto history = [](const std::string& at, const std::string& quantity) {
        return "[[history]]\nname = \"h\"\nat = \"" + at + "\"\nquantities = [\"" + quantity + "\"]\n";
    };
    CHECK_THAT(faults(floor + history("floor", "position")),
               Contains("an obstacle has contact_force, contact_friction and least_gap only"));
    CHECK_THAT(faults(floor + history("a.end", "least_gap")), Contains("only obstacles have it"));
    const Problem problem = read(deck(floor + history("floor", "contact_force")));
    CHECK(std::get<WatchedObstacle>(problem.output.histories.at(0).target).index == 0);
}

TEST_CASE("An obstacle goes on in later stages from where it is", "[deck][touch]") {
    const Problem problem =
        read(deck(floor + "move = { z = \"2*t\" }\n",
                  circle,
                  "[[stage]]\nname = \"up\"\nkind = \"dynamic\"\nend_time = 0.25\ntime_step = 0.05\n"
                  "[[stage]]\nname = \"on\"\nkind = \"dynamic\"\nend_time = 1\ntime_step = 0.1\n"));
    const auto height = [](const Contact& contact, double t) {
        return contact.obstacles.at(0).motion->displacement(t).z();
    };
    CHECK(height(problem.model.contact, 0.1) == 0.2);
    CHECK(height(problem.stages.at(1).actions.contact, 0.0) == 0.5);
    CHECK(height(problem.stages.at(1).actions.contact, 0.5) == 1.5);
}

TEST_CASE("Histories of what touches a rod", "[deck][touch]") {
    const auto history = [](const std::string& lines) {
        return floor + "[contact]\nself = false\n[[history]]\nname = \"h\"\n" + lines;
    };
    const Problem problem = read(deck(
        history("at = \"a\"\nwith = \"floor\"\nquantities = [\"contact_force\", \"contact_friction\"]\n")));
    const ContactWatch& contact = std::get<WatchedContacts>(problem.output.histories.at(0).target).contact;
    CHECK(contact.other == -1);
    CHECK_FALSE(contact.wants_gap);
    const HistoryRequest request =
        read(deck(history("at = \"a\"\nquantities = \"least_gap\"\n"))).output.histories[0];
    CHECK_FALSE(contact_of(request.target)->other);

    CHECK_THAT(faults(history("at = \"a\"\nwith = \"flor\"\nquantities = \"least_gap\"\n")),
               Contains("history[0].with: no obstacle and no rod \"flor\"; did you mean \"floor\"?"));
    CHECK_THAT(faults(history("at = \"a\"\nwith = \"a\"\nquantities = \"least_gap\"\n")),
               Contains("\"a\" does not touch itself: [contact] leaves it out"));
    CHECK_THAT(faults(history("at = \"a.end\"\nwith = \"floor\"\nquantities = \"position\"\n")),
               Contains("with: goes with a rod as a whole as `at`"));
    CHECK_THAT(
        faults(history("at = \"a\"\nquantities = \"position\"\n")),
        Contains("a rod as a whole has contact and touch-down quantities only; expected a point of it, as in "
                 "\"ROD@0.5\""));
    CHECK_THAT(faults(history("at = \"a.end\"\nquantities = \"contact_force\"\n")),
               Contains("only obstacles have it, and rods as a whole"));
    // Without contact a rod is not a point.
    CHECK_THAT(faults("[[history]]\nname = \"h\"\nat = \"a\"\nquantities = \"contact_force\"\n"),
               Contains("history[0].at: \"a\" is a rod; expected a point of it"));
}

TEST_CASE("Bodies touch by a sphere or a capsule", "[deck][touch][bodies]") {
    const auto body = [](const std::string& keys, const std::string& velocity = "") {
        return "[body.b]\nmass = 2\ninertia = [1, 1, 1]\nat = [0, 0, 5]\n" + velocity + keys + "\n";
    };
    const auto bodies_of = [&](const std::string& lines) {
        return read(lines + dynamic).model.contact.bodies;
    };
    const std::string sphere = "sphere = { radius = 0.5 }";
    SECTION("whose force follows from what the deck says") {
        CHECK(bodies_of("gravity = [0, 0, -10]\n" + body(sphere) + floor).at(0).force == Approx(2e4));
        CHECK(bodies_of(body(sphere, "velocity = [3, 0, 0]\n") + floor).at(0).force ==
              Approx(4.0 * 2.0 * 9.0 / 0.01));
        // EA/1000 of the rod.
        CHECK(read(deck(body(sphere) + floor)).model.contact.bodies.at(0).force ==
              Approx(1e6 * M_PI * 1e-4).epsilon(1e-12));
        CHECK(bodies_of("gravity = [0, 0, -10]\n" + body("") + floor).empty());
        // Mass times Ω² r of a steady rotation.
        CHECK(read(body(sphere) + "[obstacle.ball]\nsphere = { centre = [0, 0, 0], radius = 1 }\n[rotation]\n"
                                  "axis = [1, 0, 0]\nspeed = 2\n[analysis]\nkind = \"steady\"\n")
                  .model.contact.bodies.at(0)
                  .force == Approx(1000.0 * 2.0 * 4.0 * 5.0));
    }
    SECTION("and errors are reported") {
        const auto errors = [&](const std::string& lines) { return faults_of(lines + dynamic); };
        CHECK_THAT(errors(body(sphere) + floor),
                   Contains("body.b.sphere.force: missing: neither weight nor velocity"));
        CHECK_THAT(errors("gravity = [0, 0, -10]\n" + body(sphere)),
                   Contains("x.toml:6:10: body.b.sphere: touches nothing; expected an [obstacle.NAME]"));
        CHECK_THAT(errors("gravity = [0, 0, -10]\n" +
                          body("capsule = { from = [1, 0, 0], to = [1, 0, 0], radius = 1 }") + floor),
                   Contains("body.b.capsule.to: expected an end away from its start"));
        CHECK_THAT(errors("gravity = [0, 0, -10]\n" + body("sphere = { radus = 1 }") + floor),
                   Contains("did you mean \"radius\"?"));
        CHECK_THAT(errors("gravity = [0, 0, -10]\n" + body(sphere) +
                          "[obstacle.o]\nsphere = { centre = [0, 0, 5], radius = 0.4, side = \"inside\" }\n"),
                   Contains("body.b.sphere.radius: this body is to be inside of \"o\", which is no wider"));
        CHECK_THAT(faults_of("gravity = [0, 0, -10]\n" + body(sphere) + floor +
                             "[analysis]\nkind = \"dynamic\"\nend_time = 1\ntime_step = 0.1\nintegrator = "
                             "\"newmark-simplified\"\nnewton = { tangent = \"paper\" }\n"),
                   Contains("what turns by newton.tangent = \"paper\" cannot be kept from obstacles"));
    }
    SECTION("and what they pass through is said") {
        const auto passes = [&](const std::string& lines) {
            return std::ranges::count(read(lines).notes,
                                      "bodies with a sphere or capsule pass through rods: only each_other of "
                                      "[contact] lets them touch");
        };
        CHECK(passes(deck(body(sphere) + floor)) == 1);
        CHECK(passes(deck(body(sphere) + floor + "[contact]\nself = false\n")) == 0);
    }
    SECTION("and histories have what touches them") {
        const auto history = [&](const std::string& lines) {
            return "gravity = [0, 0, -10]\n" + body(sphere) + floor +
                   "[[history]]\nname = \"h\"\nat = \"b\"\n" + lines + dynamic;
        };
        const HistoryRequest request =
            read(history("quantities = [\"position\", \"least_gap\"]\nwith = \"floor\"\n"))
                .output.histories[0];
        const ContactWatch* contact = contact_of(request.target);
        REQUIRE(contact != nullptr);
        CHECK(contact->rod == 0);
        CHECK(contact->other == -1);
        CHECK(contact->wants_gap);
        CHECK(std::get<WatchedBody>(request.target).index == 0);
        const HistoryRequest other = read(history("quantities = \"position\"\n")).output.histories[0];
        CHECK(contact_of(other.target) == nullptr);
        CHECK_THAT(
            faults_of("gravity = [0, 0, -10]\n" + body("") +
                      "[[history]]\nname = \"h\"\nat = \"b\"\nquantities = \"contact_force\"\n" + dynamic),
            Contains("this body touches nothing; expected its `sphere` or `capsule`"));
    }
}

TEST_CASE("A body touches by several shapes", "[deck][touch][bodies]") {
    const std::string heavy = "gravity = [0, 0, -10]\n";
    const std::string cart = "[body.cart]\nmass = 2\ninertia = [1, 1, 1]\nat = [0, 0, 5]\n";
    const std::string stick = "capsule = { from = [-1, 0, 0], to = [1, 0, 0], radius = 0.2 }\n";
    const auto bodies_of = [&](const std::string& lines) {
        return read(heavy + cart + lines + floor + dynamic).model.contact.bodies;
    };
    SECTION("as a list, as tables of their own, and of both kinds") {
        const std::vector<ContactBody> shapes = bodies_of(
            "sphere = [{ radius = 0.5 }, { radius = 0.3, centre = [1, 0, 0], force = 7 }]\n" + stick);
        REQUIRE(shapes.size() == 3);
        for (const ContactBody& one : shapes) CHECK(one.body == 0);
        CHECK(shapes[1].radius == 0.3);
        CHECK(shapes[1].ends[1] == Vec3(1, 0, 0));
        CHECK(shapes[1].force == 7.0);
        CHECK(shapes[2].ends == std::array{Vec3(-1, 0, 0), Vec3(1, 0, 0)});
        CHECK(bodies_of("[[body.cart.sphere]]\nradius = 0.5\n[[body.cart.sphere]]\nradius = 0.4\n").size() ==
              2);
        CHECK(bodies_of(stick).size() == 1);
    }
    SECTION("and is one thing for all that names it") {
        const Problem problem =
            read(heavy + cart + "sphere = [{ radius = 0.5 }, { radius = 0.3 }]\n" + stick + floor +
                 "[contact]\n[[contact.pair]]\nbetween = [\"cart\", \"floor\"]\nfriction = 0.1\n" + dynamic);
        CHECK(problem.model.contact.touching_bodies() == std::vector{0});
        CHECK(problem.model.contact.exceptions.at(0).between[0].size() == 1);
    }
    SECTION("which overrides reach") {
        const auto radius_of = [&](const std::string& lines, const std::string& change) {
            return read(heavy + cart + lines + floor + dynamic, {change}).model.contact.bodies.at(0).radius;
        };
        CHECK(radius_of("sphere = { radius = 0.5 }\n", "body.cart.sphere.radius=0.25") == 0.25);
        CHECK(radius_of("sphere = [{ radius = 0.5 }]\n", "body.cart.sphere[0].radius=0.25") == 0.25);
        CHECK(radius_of("", "body.cart.sphere.radius=0.25") == 0.25);
    }
    SECTION("and errors say where") {
        const auto errors = [&](const std::string& lines) {
            return faults_of(heavy + cart + lines + floor + dynamic);
        };
        CHECK_THAT(errors("sphere = []\n"),
                   Contains("body.cart.sphere: expected a table sphere = { … } or a list of them, found"));
        CHECK_THAT(errors("sphere = 3\n"),
                   Contains("body.cart.sphere: expected a table sphere = { … } or a list of them, found"));
        CHECK_THAT(errors("sphere = [{ radius = 0.5 }, { radius = -1 }]\n"),
                   Contains("body.cart.sphere[1].radius: "));
        CHECK_THAT(errors("capsule = [{ from = [0, 0, 0], to = [0, 0, 0], radius = 1 }]\n"),
                   Contains("body.cart.capsule[0].to: expected an end away from its start"));
        CHECK_THAT(
            faults_of(cart + "sphere = [{ radius = 0.5, force = 2 }, { radius = 0.4 }]\n" + floor + dynamic),
            Contains("body.cart.sphere[1].force: missing: neither weight nor velocity"));
        CHECK_THAT(faults_of(heavy + cart + "sphere = [{ radius = 0.5 }, { radius = 0.4 }]\n" + floor +
                             "[analysis]\nkind = \"path\"\nuntil = { t = 1, steps = 5 }\n"),
                   Contains("expected one radius for all shapes of cart"));
    }
}

TEST_CASE("Restitution takes the place of damping and dissipation", "[deck][touch]") {
    const auto contact_of_deck = [&](const std::string& lines) { return read(deck(lines)).model.contact; };
    CHECK(contact_of_deck(floor).dissipation == 1.0);
    CHECK(contact_of_deck(floor + "restitution = 0.5\n").dissipation == 0.0);
    CHECK(contact_of_deck(floor + "restitution = 0.5\n[contact]\ndissipation = 0.4\n").dissipation == 0.4);
    // Obstacles have their own, or that of [contact].
    const Contact both =
        contact_of_deck("[contact]\nrestitution = 0.3\n" + floor +
                        "[obstacle.wall]\nplane = { point = [-1, 0, 0], normal = [1, 0, 0] }\n"
                        "restitution = 0.9\n");
    REQUIRE(both.exceptions.size() == 2);
    CHECK(both.exceptions[0].restitution == 0.3);
    CHECK(both.exceptions[0].between[1].size() == 3);
    CHECK(both.exceptions[1].restitution == 0.9);
    CHECK(both.exceptions[1].between[1].at(0).index == -2);
    CHECK_THAT(faults("[contact]\nrestitution = 0.3\ndamping = 2\n"),
               Contains("contact.restitution: damping is given too"));
    CHECK_THAT(faults("[contact]\nrestitution = 0\n"),
               Contains("contact.restitution: expected a number greater than 0, at most 1"));
    CHECK_THAT(faults(floor + "restitution = 1.5\n"), Contains("obstacle.floor.restitution: "));
    CHECK_THAT(faults(floor + "[contact]\n[[contact.pair]]\nbetween = [\"a\", \"floor\"]\n"),
               Contains("expected friction or restitution or off"));
    CHECK_THAT(faults(floor + "[contact]\n[[contact.pair]]\nbetween = [\"a\", \"floor\"]\nrestitution = 0.4\n"
                              "off = true\n"),
               Contains("contact.pair[0]"));
}

}  // namespace gxrod::test
