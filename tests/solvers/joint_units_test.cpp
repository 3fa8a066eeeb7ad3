#include "analyses/dynamic.hpp"
#include "deck/decks.hpp"
#include "tools/catch.hpp"

// What joints add to Newton's method does not depend on units and steps.
using namespace gxrod;

namespace {

std::string chain(double unit) {
    const auto number = [&](double x) { return std::to_string(x * unit); };
    const std::string inertia = "inertia = [" + std::to_string(.002 * unit * unit) + ", " +
                                std::to_string(unit * unit / 12) + ", " + std::to_string(unit * unit / 12) +
                                "]\n";
    return "gravity = [0, " + number(-9.81) + ", 0]\n[body.a]\nmass = 1\n" + inertia + "at = [" + number(.5) +
           ", 0, 0]\n[body.b]\nmass = 1\n" + inertia + "at = [" + number(1.5) +
           ", 0, 0]\n[joint.one]\ntype = \"hinge\"\nbetween = [\"ground\", \"a\"]\nat = [0, 0, 0]\naxis = "
           "[0, 0, 1]\n"
           "[joint.two]\ntype = \"hinge\"\nbetween = [\"a\", \"b\"]\nat = [" +
           number(1.) + ", 0, 0]\naxis = [0, 1, 1]\n[analysis]\nkind = \"dynamic\"\n";
}

// Of twenty steps.
int count_iterations(double unit, double time_step, const std::string& scheme) {
    const Problem problem =
        test::read(chain(unit) + "integrator = \"" + scheme + "\"\ntime_step = " + std::to_string(time_step) +
                   "\nend_time = " + std::to_string(20 * time_step) + "\n");
    DynamicAnalysis analysis(problem.model, test::dynamic_of(problem));
    REQUIRE(analysis.start().converged());
    int iterations = 0;
    while (!analysis.finished()) {
        REQUIRE(analysis.advance().converged());
        iterations += analysis.solver_row().newton_iterations;
    }
    return iterations;
}

}  // namespace

TEST_CASE("Metres and millimetres take the same iterations, short steps no more than long ones",
          "[solvers][joints]") {
    for (const char* scheme : {"newmark-simplified", "generalized-alpha"}) {
        int before = count_iterations(1.0, 1e-2, scheme);
        for (const double time_step : {1e-2, 1e-3, 1e-4, 1e-5}) {
            INFO(scheme << ", " << time_step);
            const int iterations = count_iterations(1.0, time_step, scheme);
            CHECK(iterations == count_iterations(1000.0, time_step, scheme));
            CHECK(iterations <= before);
            before = iterations;
        }
    }
}
