#include "check/failure_advice.hpp"

#include "tools/catch.hpp"

using namespace gxrod;

namespace {

using Phase = Failure::Phase;

Failure make_failure(Phase phase, Outcome outcome) {
    Failure failure;
    failure.phase = phase;
    failure.outcome = outcome;
    failure.time = 0.3;
    failure.time_step = 0.000125;
    return failure;
}

const std::string stability =
    "a smaller time_step: runge-kutta-4 is stable only while the step is short compared with the shortest "
    "period, "
    "which the shortest and stiffest element has; or an implicit integrator, such as generalized-alpha";

}  // namespace

TEST_CASE("a step without convergence names the time, the worst places and what to try", "[check]") {
    Failure failure = make_failure(Phase::implicit_step, Outcome::out_of_iterations);
    failure.iterations = 20;
    failure.residual = 0.031;
    failure.places = {"flyer.end (ry)", "flyer node 14 (x)", "flyer node 13 (x)"};
    CHECK(describe_failure(failure) ==
          "the step from t = 0.3 failed, even with Δt = 0.000125: Newton's method did not converge in 20 "
          "iterations; the residual, 3.10e-02 of the largest force or moment, is largest at flyer.end "
          "(ry), flyer node 14 (x), flyer node 13 (x). Try a smaller time_step; or a finer mesh (elements, "
          "order) there; or a larger newton.max_iterations");
}

TEST_CASE("advice on a load step names the load factor and jumps", "[check]") {
    Failure failure = make_failure(Phase::load_step, Outcome::out_of_iterations);
    failure.iterations = 7;
    failure.residual = 2.0;
    failure.weakness = "rod cable, node 14: twist";
    CHECK(describe_failure(failure) ==
          "the step from load factor 0.3 failed, even with one of 0.000125: Newton's method did not converge "
          "in 7 iterations; the residual, 2.00e+00 of the largest force or moment, is largest. Nothing "
          "resists this motion: rod cable, node 14: twist. Try more steps; or a finer mesh (elements, order) "
          "there; or a larger newton.max_iterations; or a dynamic analysis, if this is a load that the "
          "structure cannot carry without a jump to another shape");
}

TEST_CASE("next to a stiff rod round-off is the reason", "[check]") {
    Failure failure = make_failure(Phase::load_step, Outcome::singular);
    failure.places = {"q.end (z)"};
    failure.contrast = "rod q is too stiff compared with what bends rod r";
    failure.contrast_advice = "longer elements";
    CHECK(
        describe_failure(failure) ==
        "the step from load factor 0.3 failed, even with one of 0.000125: the system of equations is "
        "singular at q.end (z). Likely because rod q is too stiff compared with what bends rod r. Try longer "
        "elements");
    failure.phase = Phase::implicit_step;
    failure.outcome = Outcome::out_of_iterations;
    CHECK(advise(failure) == std::vector<std::string>{"longer elements", "a larger newton.max_iterations"});
}

TEST_CASE("a singular system names the motion that nothing holds", "[check]") {
    Failure failure = make_failure(Phase::load_step, Outcome::singular);
    failure.places = {"cable.start (rx)"};
    failure.weakness = "the whole model turns about its own axis";
    CHECK(describe_failure(failure) ==
          "the step from load factor 0.3 failed, even with one of 0.000125: the system of equations is "
          "singular at cable.start (rx). Nothing resists this motion: the whole model turns about its own "
          "axis. Try a support that holds this motion, or stiffness against it; or a small load sideways, if "
          "the structure buckles here");
}

TEST_CASE("in dynamics a singular system lacks inertia", "[check]") {
    const std::string inertia =
        "inertia for this motion: rhoA, rhoJ, rhoIy, rhoIz of a section, mass and inertia of a body";
    const auto advice = [](Phase phase) { return advise(make_failure(phase, Outcome::singular)); };
    CHECK(advice(Phase::initial_accelerations) == std::vector<std::string>{inertia});
    CHECK(advice(Phase::explicit_step) == std::vector<std::string>{inertia});
    CHECK(advice(Phase::implicit_step) == std::vector<std::string>{inertia, "a smaller time_step"});
    CHECK(describe_failure(make_failure(Phase::initial_accelerations, Outcome::singular)) ==
          "the initial accelerations cannot be found: the system of equations is singular. Try " + inertia);
}

TEST_CASE("an explicit scheme that blows up is distinguished from a bad load", "[check]") {
    Failure failure = make_failure(Phase::explicit_step, Outcome::not_finite);
    failure.places = {"tip (z)"};
    CHECK(describe_failure(failure) ==
          "the step from t = 0.3 failed, even with Δt = 0.000125: a force or increment is not a finite "
          "number at "
          "tip (z). Try " +
              stability + "; or a look at the values of the loads and functions at this time");
    failure.phase = Phase::implicit_step;
    CHECK(advise(failure) ==
          std::vector<std::string>{"a look at the values of the loads and functions at this time"});
}

TEST_CASE("too large rotations ask for shorter steps or elements", "[check]") {
    const auto text = [](Phase phase, Outcome outcome) {
        return describe_failure(make_failure(phase, outcome));
    };
    const std::string start = "the step from t = 0.3 failed, even with Δt = 0.000125: ";
    CHECK(text(Phase::implicit_step, Outcome::rotation_too_large) ==
          start + "the rotation within one step reaches half a turn. Try a smaller time_step");
    CHECK(text(Phase::explicit_step, Outcome::rotation_too_large) ==
          start + "the rotation within one step reaches half a turn. Try " + stability);
    CHECK(text(Phase::implicit_step, Outcome::element_too_turned) ==
          start +
              "one element's nodes turn against each other by half a turn. Try more elements; or a smaller "
              "time_step");
    CHECK(text(Phase::explicit_step, Outcome::element_too_turned) ==
          start + "one element's nodes turn against each other by half a turn. Try " + stability +
              "; or more elements");
    CHECK(advise(make_failure(Phase::load_step, Outcome::element_too_turned)) ==
          std::vector<std::string>{"more elements", "more steps"});
}

TEST_CASE("a step whose error stays too large asks for its limits to be widened", "[check]") {
    Failure failure = make_failure(Phase::implicit_step, Outcome::error_too_large);
    failure.step_error = 3.2e-3;
    failure.places = {"top (rz)"};
    CHECK(describe_failure(failure) ==
          "the step from t = 0.3 failed, even with Δt = 0.000125: the estimated error of the step, "
          "3.20e-03, is above the tolerance at top (rz). Try a smaller adaptive.min_step; or a larger "
          "adaptive.tolerance");
}
