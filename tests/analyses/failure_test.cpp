// Messages about a step that fails.
#include <numbers>

#include "analyses/dynamic.hpp"
#include "tools/catch.hpp"
#include "tools/rod_models.hpp"
#include "tools/run.hpp"
#include "tools/static_run.hpp"
#include "tools/tops.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// A cantilever of length 2 in 4 elements, pushed sideways, as soft about z as requested.
Model make_cantilever(double EIz) {
    Model model = make_rod_model(along_x, 2.0, {4}, make_section({1e3, 1e3, 1e3, 10.0, 10.0, EIz}));
    clamp(model, 0);
    add_ramp(model, last_node(model), Vec3(0.0, 1.0, 0.0), Vec3::Zero());
    return model;
}

// The first step that fails, in words; or of the start.
std::string find_failure(const Model& model, const DynamicSettings& settings) {
    DynamicAnalysis analysis(model, settings);
    EquilibriumReport report = analysis.start();
    while (report.converged() && !analysis.finished()) report = analysis.advance();
    REQUIRE_FALSE(report.converged());
    return describe_failure(analysis.explain(report));
}

}  // namespace

TEST_CASE("a load step without convergence names the three worst places", "[analyses]") {
    StaticSettings settings = make_static_settings(1);
    settings.newton.max_iterations = 1;
    Model model = make_cantilever(1.0);
    model.loads[0].force[1] = ramp(1e6);
    const std::string failure = try_static(model, settings).failure;
    INFO(failure);
    CHECK_THAT(failure, Catch::StartsWith("the step from load factor 0 failed, even with one of "));
    CHECK_THAT(failure,
               Catch::Contains("Newton's method did not converge in 1 iterations") ||
                   Catch::Contains("one element's nodes turn"));
    CHECK_THAT(failure, Catch::Contains("rod node"));
    CHECK_THAT(failure, !Catch::Contains("Nothing resists"));
    CHECK_THAT(failure, Catch::Contains("Try more steps") || Catch::Contains("Try more elements"));
}

TEST_CASE("a rod without bending stiffness says which motion nothing resists", "[analyses]") {
    const std::string failure = try_static(make_cantilever(0.0), make_static_settings(1)).failure;
    INFO(failure);
    CHECK_THAT(failure, Catch::StartsWith("the step from load factor 0 failed, even with one of "));
    CHECK_THAT(failure, Catch::Contains("Nothing resists this motion: rod rod, node "));
    CHECK_THAT(failure, Catch::Contains(": bending about z. Try a support that holds this motion"));
}

TEST_CASE("a body without inertia about an axis says so before the first step", "[analyses]") {
    const Model model = make_free_body(Vec3(1.0, 0.0, 1.0), Vec3::Zero());
    CHECK(find_failure(model, make_settings(Scheme::newmark_simplified, 1.0, 10)) ==
          "the initial accelerations cannot be found: the system of equations is singular at body (ry). "
          "Nothing resists this motion: the whole model turns about y. Try inertia for this motion: rhoA, "
          "rhoJ, rhoIy, rhoIz of a section, mass and inertia of a body");
}

TEST_CASE("a step that turns too far says when, where and what to try", "[analyses]") {
    const Model model = make_free_body(Vec3(1.0, 2.0, 3.0), Vec3(1e9, 0.0, 0.0));
    const std::string failure = find_failure(model, make_settings(Scheme::newmark_simplified, 1.0, 10));
    CHECK_THAT(failure, Catch::StartsWith("the step from t = 0 failed, even with Δt = "));
    CHECK_THAT(
        failure,
        Catch::EndsWith("the rotation within one step reaches half a turn at body. Try a smaller time_step"));
}

TEST_CASE("an explicit step that breaks speaks of its stability", "[analyses]") {
    Model model = make_rod_model(
        along_x, 2.0, {4}, make_section({1e8, 1e8, 1e8, 1e4, 1e4, 1e4}, {1.0, 1.0, 1.0, 0.1, 0.1, 0.1}));
    clamp(model, 0);
    add_ramp(model, last_node(model), Vec3(0.0, 1.0, 0.0), Vec3::Zero());
    const std::string failure = find_failure(model, make_settings(Scheme::runge_kutta_4, 10.0, 100));
    INFO(failure);
    CHECK_THAT(failure, Catch::Contains("the rotation within one step reaches half a turn at rod node "));
    CHECK_THAT(failure, Catch::Contains("Try a smaller time_step: runge-kutta-4 is stable only while"));
}

TEST_CASE("an explicit step does not wind an element beyond half a turn", "[analyses]") {
    // Two heavy disks on a soft element, which turn against each other by 8 rad/s.
    Model model =
        make_rod_model(along_x, 1.0, {1}, make_section({1.0, 1.0, 1.0, 0.01, 1.0, 1.0}, {1, 1, 1, 1, 1, 1}));
    model.nodes[0].angular_velocity = Vec3(4.0, 0.0, 0.0);
    model.nodes[1].angular_velocity = Vec3(-4.0, 0.0, 0.0);
    DynamicAnalysis analysis(model, make_settings(Scheme::runge_kutta_4, 1.0, 100));
    EquilibriumReport report = analysis.start();
    while (report.converged() && !analysis.finished()) report = analysis.advance();
    CHECK(report.outcome == Outcome::element_too_turned);
    CHECK(analysis.state().time == Approx(std::numbers::pi / 8.0).margin(0.011));
}
