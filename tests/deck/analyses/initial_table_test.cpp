#include "deck/analyses/build_initial.hpp"

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

const std::string bent =
    rod_deck +
    "[rod.q]\nsection = \"s\"\nline = { from = [10, 0, 0], to = [10, 5, 0] }\nelements = 5\n"
    "element = \"simo\"\n[[connect]]\npoints = [\"r.end\", \"q.start\"]\n";  // lines 1 to 19

}  // namespace

TEST_CASE("Initial velocities are functions of place and arc length", "[deck]") {
    const Model model = read(bent +
                             "[function.f]\ntable = [[0, 1], [5, 2]]\n[parameters]\nomega = 2\n"
                             "[body.b]\nmass = 1\ninertia = [1, 1, 1]\nat = [1, 2, 3]\n"
                             "[[initial]]\non = \"q\"\nvelocity = [\"-omega*y\", \"omega*x\", \"f(s)\"]\n"
                             "angular_velocity = [0, 0, \"omega\"]\n"
                             "[[initial]]\non = \"b\"\nvelocity = [\"x\", \"y^2\", \"z + 1\"]\n")
                            .model;
    const Rod& rod = model.rods[1];
    for (int i = 0; i <= 5; ++i) {
        const Node& node = model.nodes[rod.nodes[i]];
        CHECK((node.velocity - Vec3(-2.0 * i, 20.0, 1.0 + 0.2 * i)).norm() < 1e-14);
        CHECK(node.angular_velocity == Vec3(0, 0, 2));
    }
    CHECK(model.nodes[9].velocity == Vec3::Zero());
    const Node& body = model.nodes[model.bodies[0].node];
    CHECK(body.velocity == Vec3(1, 4, 4));
    CHECK(body.angular_velocity == Vec3::Zero());
}

TEST_CASE("A node that two rods share has one velocity", "[deck]") {
    const auto fault = [](const std::string& of_q) {
        return faults_of(bent + "[[initial]]\non = \"r\"\nvelocity = [\"sin(pi*x/10)\", \"x\", 0]\n" +
                         "[[initial]]\non = \"q\"\nvelocity = " + of_q + "\n");
    };
    CHECK(fault("[0, 10, \"y\"]").empty());
    CHECK(fault("[0, 9, 0]") ==
          "x.toml:25:12: initial[1].velocity: gives [0, 9, 0] to r.end, to which initial[0].velocity gives "
          "[1.22465e-16, 10, 0]; a node has one velocity");
}

TEST_CASE("A body's own velocity is not set again", "[deck]") {
    const std::string deck = rod_deck +
                             "[body.b]\nmass = 1\ninertia = [1, 1, 1]\nat = \"r.end\"\nvelocity = [0, 3, 0]\n"
                             "[[initial]]\non = ";
    CHECK(
        faults_of(deck + "\"r\"\nvelocity = [0, \"s\", 0]\n") ==
        "x.toml:20:12: initial[0].velocity: gives [0, 10, 0] to r.end, to which body.b.velocity gives [0, 3, "
        "0]; a node has one velocity");
    CHECK(faults_of(deck + "\"r\"\nvelocity = [0, \"0.3*s\", 0]\n").empty());
    CHECK(
        faults_of(deck + "\"b\"\nvelocity = [0, 4, 0]\n") ==
        "x.toml:20:12: initial[0].velocity: gives [0, 4, 0] to r.end, to which body.b.velocity gives [0, 3, "
        "0]; a node has one velocity");
}

TEST_CASE("Initial velocities are of rods or bodies, finite, without t", "[deck]") {
    const auto fault = [](const std::string& on, const std::string& value) {
        return faults_of(rod_deck + "[body.b]\nmass = 1\ninertia = [1, 1, 1]\n[[initial]]\non = \"" + on +
                         "\"\nvelocity = [0, \"" + value + "\", 0]\n");
    };
    CHECK(fault("c", "x") == R"(x.toml:17:6: initial[0].on: no rod or body "c"; the deck has r, b)");
    CHECK(fault("b", "s") ==
          "x.toml:18:16: initial[0].velocity[1]: s is the arc length along a rod; this is a body");
    CHECK(fault("r", "1/(s - 3)") ==
          R"x(x.toml:18:16: initial[0].velocity[1]: "1/(s - 3)" is inf at x = 3, y = 0, z = 0, s = 3)x");
    CHECK(fault("b", "1/x") ==
          R"x(x.toml:18:16: initial[0].velocity[1]: "1/x" is inf at x = 0, y = 0, z = 0)x");
    CHECK(
        fault("r", "t") ==
        R"(x.toml:18:16: initial[0].velocity[1]: "t": "t" (time) is not allowed here: this value is that at t = 0)");
    const Problem still = read(static_rod_deck + "[[initial]]\non = \"r\"\nvelocity = [0, 0, 1]\n");
    CHECK(still.notes.back() ==
          "initial[0]: without effect: velocities act in dynamic analyses, and the deck has none");
    CHECK(still.model.nodes[1].velocity == Vec3::Zero());
}

}  // namespace gxrod::test
