// A deck in other units is the same problem: the same steps, iterations and cuts, the same motion.

#include "tools/catch.hpp"
#include "tools/rod_models.hpp"
#include "tools/run.hpp"
#include "tools/static_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// How many of the units of a deck are one metre, newton and second.
struct Units {
    double length, force, time;
    double mass() const { return force * time * time / length; }
};

constexpr Units metres{1.0, 1.0, 1.0};
// Powers of two and others, either way.
const std::vector<Units> others{
    {1024.0, 1.0, 1.0}, {1.0, 0x1p-20, 1.0}, {1000.0, 1e-3, 1.0}, {0.025, 7e6, 1.0}, {1e3, 1e3, 1e-3}};

// A cantilever that a force and a moment at its end bend by a radian or two.
Model make_cantilever(const Units& u) {
    const double L = u.length;
    const double F = u.force;
    const double m = u.mass() / L;
    const double J = u.mass() * L;
    const Line line = [L](double s) { return Placement{Vec3(s, 0.3 * L, -0.2 * L), Quat::Identity()}; };
    Model model = make_rod_model(
        line,
        2.0 * L,
        {6, 2},
        make_section({1e4 * F, 5e3 * F, 5e3 * F, 80.0 * F * L * L, 100.0 * F * L * L, 120.0 * F * L * L},
                     {2.0 * m, 2.0 * m, 2.0 * m, 0.02 * J, 0.01 * J, 0.01 * J}));
    clamp(model, 0);
    NodalLoad load;
    load.node = last_node(model);
    const auto grows = [u](double value) {
        return TimeFunction([u, value](double t) { return value * std::min(1.0, t / u.time); });
    };
    load.force = {grows(0.0), grows(20.0 * F), grows(90.0 * F)};
    load.moment = {grows(30.0 * F * L), grows(0.0), grows(40.0 * F * L)};
    model.loads.push_back(load);
    return model;
}

}  // namespace

TEST_CASE("Newton's method does not notice units in statics", "[solvers]") {
    const StaticRun expected = run_static(make_cantilever(metres), make_static_settings(3, 1e-8));
    for (Units units : others) {
        INFO(units.length << " " << units.force);
        units.time = 1.0;
        const StaticRun run = run_static(make_cantilever(units), make_static_settings(3, 1e-8));
        CHECK(run.steps == expected.steps);
        CHECK(run.iterations == expected.iterations);
        CHECK(run.rejected_steps == expected.rejected_steps);
        CHECK((run.tip().r / units.length - expected.tip().r).norm() < 1e-9);
        CHECK(run.tip().Lambda.angularDistance(expected.tip().Lambda) < 1e-9);
    }
}

TEST_CASE("Newton's method does not notice units in dynamics", "[solvers]") {
    const auto fly = [](const Units& units) {
        DynamicSettings settings = make_settings(Scheme::newmark_simplified, 1.0 * units.time, 50);
        settings.newton.tolerance = 1e-8;
        std::pair<Vec3, long> end_and_iterations{Vec3::Zero(), 0};
        run(make_cantilever(units), settings, [&](const DynamicAnalysis& analysis) {
            end_and_iterations.first = analysis.state().trial.back().r / units.length;
            end_and_iterations.second += analysis.solver_row().newton_iterations;
        });
        return end_and_iterations;
    };
    const auto expected = fly(metres);
    CHECK(expected.second > 50);
    for (const Units& units : others) {
        INFO(units.length << " " << units.force << " " << units.time);
        const auto found = fly(units);
        CHECK(found.second == expected.second);
        CHECK((found.first - expected.first).norm() < 1e-7);
    }
}
