
#include "analyses/static.hpp"
#include "deck/decks.hpp"
#include "tools/catch.hpp"

// Weakly loaded parts next to strongly loaded ones were not solved: tolerances were those of the whole model.

namespace gxrod::test {
namespace {

// A hair of 0.1 from (x, 0, z) on, with a load of 1e-6 at its end.
std::string make_hair(const std::string& x, const std::string& z, const std::string& held) {
    return R"([section.h]
stiffness = { EA = 0.1, GAy = 0.1, GAz = 0.1, GJ = 1e-9, EIy = 1e-9, EIz = 1e-9 }
inertia = { rhoA = 1e-7, rhoIy = 1e-16, rhoIz = 1e-16 }
[rod.hair]
section = "h"
line = { from = [)" +
           x + ", 0, " + z + "], to = [\"" + x + R"( + 0.1", 0, )" + z + R"(] }
elements = 10
order = 2
[[load]]
at = "hair.end"
force = [0, 0, "-1e-6"]
)" + held;
}

const std::string held_alone = "[[support]]\nat = \"hair.start\"\nfix = \"all\"\n";

// A steel beam from the origin to (1, 0, 0) that is loaded a billion times as much.
const std::string beam = R"([section.b]
shape = { circle = { radius = 0.05 } }
material = { E = 2e11, nu = 0.3, density = 7850 }
[rod.beam]
section = "b"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 10
order = 2
[[support]]
at = "beam.start"
fix = "all"
[[load]]
at = "beam.end"
force = [0, 0, "-1e3"]
)";

const std::string one_step = "[analysis]\nkind = \"static\"\nsteps = 1\n";

// How far the end of rod 0 is from where it was, and from its start.
Vec3 run_hair(const std::string& deck) {
    const Problem problem = read(deck);
    const auto analysis = make_analysis(problem.model, problem.analysis());
    REQUIRE(analysis->start().converged());
    while (!analysis->finished()) REQUIRE(analysis->advance().converged());
    const std::vector<int>& nodes = problem.model.rods[0].nodes;
    const auto moved = [&](int node) {
        const auto i = static_cast<std::size_t>(node);
        return Vec3(analysis->state().trial[i].r - problem.model.nodes[i].position);
    };
    return moved(nodes.back()) - moved(nodes.front());
}

std::string make_dynamic(const std::string& integrator) {
    return "[analysis]\nkind = \"dynamic\"\nend_time = 0.02\ntime_step = 1e-3\n" + integrator;
}

}  // namespace

TEST_CASE("A hair next to a beam hangs as it does alone", "[issues]") {
    const Vec3 alone = run_hair(make_hair("0", "1", held_alone) + one_step);
    CHECK(alone.x() == Approx(-0.0555).margin(1e-4));
    CHECK(alone.z() == Approx(-0.0811).margin(1e-4));
    CHECK((run_hair(make_hair("0", "1", held_alone) + beam + one_step) - alone).norm() < 1e-8);
}

TEST_CASE("A hair on a beam hangs as on a clamp", "[issues]") {
    // The beam's end turns by 5e-4.
    const Vec3 alone = run_hair(make_hair("1", "0", held_alone) + one_step);
    const std::string connected = "[[connect]]\npoints = [\"beam.end\", \"hair.start\"]\n";
    CHECK((run_hair(make_hair("1", "0", connected) + beam + one_step) - alone).norm() < 1e-4);
}

TEST_CASE("A hair that moves next to a beam moves as it does alone", "[issues]") {
    for (const std::string integrator :
         {"", "integrator = \"sdirk-4\"\n", "integrator = \"generalized-alpha\"\n"}) {
        CAPTURE(integrator);
        const Vec3 alone = run_hair(make_hair("0", "1", held_alone) + make_dynamic(integrator));
        CHECK(alone.norm() > 1e-3);
        const Vec3 beside = run_hair(make_hair("0", "1", held_alone) + beam + make_dynamic(integrator));
        CHECK((beside - alone).norm() < 1e-6 * alone.norm());
    }
}

TEST_CASE("Steps by their error resolve the smallest part of a model", "[issues]") {
    // Of the hair's length, not of the distance to a beam that is a kilometre away.
    const std::string steps = make_dynamic(
        "integrator = \"sdirk-4\"\nadaptive = { tolerance = 1e-4 }\nnewton = { tolerance = 1e-12 }\n");
    const std::string far_beam = replaced(
        replaced(beam, "from = [0, 0, 0]", "from = [0, 0, -1000]"), "to = [1, 0, 0]", "to = [1, 0, -1000]");
    const Vec3 fine = run_hair(replaced(make_hair("0", "1", held_alone) + steps, "1e-4 }", "1e-8 }"));
    const Vec3 alone = run_hair(make_hair("0", "1", held_alone) + steps);
    CHECK((alone - fine).norm() < 1e-4);
    CHECK((run_hair(make_hair("0", "1", held_alone) + far_beam + steps) - fine).norm() < 1e-4);
}

}  // namespace gxrod::test
