#include "deck/decks.hpp"
#include "deck/round_trips.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

// A blade on a hub, and another rod that is left alone.
const std::string rotor =
    rod_deck +
    "[rod.q]\nsection = \"s\"\nline = { from = [10, 0, 0], to = [10, 5, 1] }\n"
    "elements = 5\n[[connect]]\npoints = [\"r.end\", \"q.start\"]\n"
    "[body.hub]\nmass = 1\ninertia = [1, 1, 1]\nat = \"r.start\"\n"
    "[rod.other]\nsection = \"s\"\nline = { from = [0, 0, 9], to = [1, 0, 9] }\nelements = 1\n";

std::string spinning(const std::string& lines) {
    return rotor + "[[initial]]\non = [\"r\", \"q\", \"hub\"]\n" + lines;
}

const std::string spin = "spin = { axis = [0, 3, 4], through = [1, 2, 3], rate = 10 }\n";

}  // namespace

std::vector<RoundTrip> spin_trips() {
    const auto first = [](const Problem& p) { return p.model.nodes[0]; };
    return {
        {"initial.spin.axis",
         rod_deck + "[[initial]]\non = \"r\"\nspin = { axis = [0, 2, 0], rate = 3 }\n",
         [=](const Problem& p) { return first(p).angular_velocity == Vec3(0, 3, 0); }},
        {"initial.spin.rate",
         rod_deck + "[[initial]]\non = \"r\"\nspin = { axis = [0, 0, 1], rate = 7 }\n",
         [=](const Problem& p) { return first(p).angular_velocity == Vec3(0, 0, 7); }},
        {"initial.spin.through",
         rod_deck + "[[initial]]\non = \"r\"\nspin = { axis = [0, 0, 1], rate = 3, through = [0, 1, 0] }\n",
         [=](const Problem& p) { return first(p).velocity == Vec3(3, 0, 0); }}};
}

TEST_CASE("several parts spin as one rigid body", "[deck]") {
    const Model model = read(spinning(spin + "velocity = [1, 2, 3]\n")).model;
    const Vec3 rate(0.0, 6.0, 8.0);
    for (const Node& node : model.nodes) {
        if (node.position.z() == 9.0) {
            CHECK(node.velocity == Vec3::Zero());
            CHECK(node.angular_velocity == Vec3::Zero());
            continue;
        }
        const Vec3 expected = Vec3(1, 2, 3) + rate.cross(node.position - Vec3(1, 2, 3));
        CHECK((node.velocity - expected).norm() < 1e-12);
        CHECK((node.angular_velocity - rate).norm() < 1e-14);
    }
    CHECK(model.nodes[static_cast<std::size_t>(model.bodies[0].node)].velocity.norm() > 1.0);
}

TEST_CASE("a spin keeps distances", "[deck]") {
    const Model model = read(spinning(spin)).model;
    const Node& a = model.nodes[3];
    const Node& b = model.nodes[14];
    CHECK(a.velocity.norm() > 1.0);
    CHECK(std::abs((a.velocity - b.velocity).dot(a.position - b.position)) < 1e-11);
}

TEST_CASE("what is wrong with a spin is said", "[deck]") {
    CHECK_THROWS_WITH(read(spinning("spin = { axis = [0, 0, 0], rate = 1 }\n")),
                      Contains("initial[0].spin.axis: expected a direction, found a vector of zero length"));
    CHECK_THROWS_WITH(read(spinning("spin = { axis = [0, 0, 1] }\n")),
                      Contains("initial[0].spin.rate: missing"));
    CHECK_THROWS_WITH(read(spinning(spin + "angular_velocity = [0, 0, 1]\n")), Contains("only one of them"));
    CHECK_THROWS_WITH(read(replaced(spinning(spin), "\"hub\"]", "\"hob\"]")),
                      Contains("initial[0].on[2]: no rod or body \"hob\"; did you mean \"hub\"?"));
    CHECK_THROWS_WITH(
        read(spinning(spin) + "[[initial]]\non = \"q\"\nvelocity = [1, 2, 3]\n"),
        Contains("initial[1].velocity: gives [1, 2, 3] to r.end, to which initial[0].spin gives"));
}

}  // namespace gxrod::test
