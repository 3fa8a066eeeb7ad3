// Rods at rest whose reference axes are turned by half turns and whole turns, exactly and by a unit of the
// last place more or less, are free of strain, force and motion.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "deck/decks.hpp"
#include "model/energy_round_off.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/run.hpp"
#include "tools/static_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

using std::numbers::pi;

// The double nearest to k π, or a neighbour of it.
double half_turns(int k, int beside) {
    return beside == 0 ? k * pi : std::nextafter(k * pi, beside > 0 ? 1e3 : -1e3);
}

// Rods of a few elements. A line may run in any direction; a ring is closed.
std::string line_to(double x, double y) {
    return fmt::format("line = {{ from = [0, 0, 0], to = [{}, {}, 0] }}", x, y);
}
const std::string half_ring = R"(arc = { from = [0, 0, 0], through = [-3, 3, 0], to = [-6, 0, 0] })";
const std::string ring =
    R"(arc = { centre = [0, 3, 0], axis = [0, 0, 1], from = [0, 0, 0], angle = "2*pi" })";

Problem read_at_rest(const std::string& shape,
                     const std::string& element,
                     int order,
                     double twist,
                     const std::string& analysis) {
    const std::string deck =
        fmt::format(R"([section.s]
stiffness = {{ EA = 1e4, GAy = 2e4, GAz = 3e4, GJ = 500, EIy = 600, EIz = 700 }}
inertia = {{ rhoA = 1.0, rhoJ = 20, rhoIy = 10, rhoIz = 11 }}
[rod.r]
section = "s"
{}
elements = 8
order = {}
element = "{}"
twist = {:.17g}
[[support]]
at = "r.start"
fix = "all"
[analysis]
{}
{})",
                    shape,
                    order,
                    element,
                    twist,
                    analysis,
                    shape == ring ? "[[connect]]\npoints = [\"r.start\", \"r.end\"]\n" : "");
    return test::read(deck);
}

void check_unstrained(std::span<const SectionValues> elements, double force_round_off) {
    for (const SectionValues& values : elements) {
        CHECK(values.strain.norm() < 1e-13);
        CHECK(values.curvature.norm() < 1e-13);
        CHECK(values.force.norm() < force_round_off);
        CHECK(values.moment.norm() < force_round_off);
    }
}

void check_statics(const Problem& problem) {
    const StaticRun at_rest = run_static(problem.model, make_static_settings(2, 1e-8));
    check_unstrained(at_rest.elements, 1e-8);
    CHECK(at_rest.ledger.strain_energy < compute_energy_round_off(problem.model));
    for (std::size_t i = 0; i < at_rest.state.trial.size(); ++i) {
        const NodeMotion& node = at_rest.state.trial[i];
        CHECK((node.r - problem.model.nodes[i].position).norm() < 1e-12);
        CHECK(node.Lambda.angularDistance(Quat::Identity()) < 1e-12);
    }
}

void check_dynamics(const Problem& problem, Scheme scheme) {
    DynamicSettings settings = make_settings(scheme, 1.0, 4);
    settings.newton.tolerance = 1e-8;
    run(problem.model, settings, [&](DynamicAnalysis& analysis) {
        check_unstrained(analysis.snapshot().elements, 1e-8);
        CHECK(analysis.ledger_row().kinetic_energy < compute_energy_round_off(problem.model));
        for (const NodeMotion& node : analysis.state().trial) {
            CHECK(node.v.norm() < 1e-10);
            CHECK(node.omega.norm() < 1e-10);
            CHECK(node.Lambda.angularDistance(Quat::Identity()) < 1e-10);
        }
    });
}

// Both kinds of elements, straight and curved ones, in statics and dynamics.
void check_at_rest(const std::string& shape, double twist) {
    for (const char* element : {"objective", "simo"}) {
        for (const int order : {1, 3}) {
            INFO(element << " of order " << order << ", twist " << twist << ", " << shape);
            check_statics(read_at_rest(shape, element, order, twist, "kind = \"static\"\n"));
            const Problem moving =
                read_at_rest(shape, element, order, twist, "kind = \"dynamic\"\nend_time = 1\nsteps = 4\n");
            for (const Scheme scheme :
                 {Scheme::newmark_simplified, Scheme::generalized_alpha, Scheme::sdirk_4})
                check_dynamics(moving, scheme);
        }
    }
}

}  // namespace

TEST_CASE("Rods whose axes are half a turn from the global ones rest", "[analyses]") {
    for (const double y : {0.0, 1e-15, -1e-15}) check_at_rest(line_to(-10.0, y), 0.0);
    check_at_rest(half_ring, 0.0);
}

TEST_CASE("Rods that are twisted by half turns and whole turns, free of stress, rest", "[analyses]") {
    for (const int k : {1, 2, 4, -2}) {
        for (const int beside : {-1, 0, 1}) check_at_rest(line_to(-10.0, 0.0), half_turns(k, beside));
    }
    const Model model =
        read_at_rest(line_to(-10.0, 0.0), "objective", 1, 2.0 * pi, "kind = \"static\"\n").model;
    CHECK(model.rods[0].triads.front().angularDistance(model.rods[0].triads.back()) < 1e-15);
    CHECK(model.rods[0].triads.front().angularDistance(model.rods[0].triads[8]) == Approx(pi));
}

TEST_CASE("Closed rings rest, twisted by whole turns, too", "[analyses]") {
    for (const double twist : {0.0, half_turns(2, -1), half_turns(2, 0), half_turns(2, 1), pi})
        check_at_rest(ring, twist);
}
