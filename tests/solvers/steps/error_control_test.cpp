#include "solvers/steps/error_control.hpp"

#include <limits>

#include "tools/catch.hpp"

using namespace gxrod;

namespace {

constexpr int order = 4;

// Runs to the end with an error of `error(time, time_step)` and calls visit(steps) before each is accepted.
template <class Error, class Visit>
int run(ErrorControl& steps, Error&& error, Visit&& visit) {
    int rejected = 0;
    while (!steps.finished()) {
        while (!steps.admits(error(steps.time(), steps.time_step()))) {
            REQUIRE(steps.reject());
            ++rejected;
        }
        visit(steps);
        steps.accept();
    }
    return rejected;
}

}  // namespace

TEST_CASE("steps settle where their error is just below the tolerance", "[solvers]") {
    ErrorControl steps(100.0, 1e-3, order, {.tolerance = 1e-4});
    const auto error = [](double, double step) { return 2.0 * std::pow(step, order); };
    std::vector<double> lengths;
    const int rejected = run(steps, error, [&](const ErrorControl& s) { lengths.push_back(s.time_step()); });
    CHECK(rejected <= 1);
    const double ideal = std::pow(1e-4 / 2.0, 1.0 / order);
    for (std::size_t i = 20; i + 2 < lengths.size(); ++i) {
        CHECK(lengths[i] > 0.8 * ideal);
        CHECK(lengths[i] < ideal);
    }
    CHECK(steps.time() == 100.0);
    CHECK(steps.steps_done() == static_cast<long>(lengths.size()));
}

TEST_CASE("growth and cuts are bounded, and a step does not grow right after a rejection", "[solvers]") {
    ErrorControl steps(1.0, 1e-4, order, {.tolerance = 1e-4});
    REQUIRE(steps.admits(0.0));
    steps.accept();
    CHECK(steps.time() == 1e-4);
    CHECK(steps.time_step() == Approx(3e-4).epsilon(1e-14));
    CHECK_FALSE(steps.admits(1e6));
    REQUIRE(steps.reject());
    CHECK(steps.time_step() == Approx(0.2 * 3e-4).epsilon(1e-14));
    CHECK_FALSE(steps.admits(1.0001e-4));
    REQUIRE(steps.reject());
    CHECK(steps.time_step() == Approx(0.9 * 0.2 * 3e-4).epsilon(1e-4));
    const double before = steps.time_step();
    REQUIRE(steps.admits(1e-9));
    steps.accept();
    CHECK(steps.time_step() == Approx(before).epsilon(1e-14));
    REQUIRE(steps.admits(1e-9));
    steps.accept();
    CHECK(steps.time_step() > 2.0 * before);
}

TEST_CASE("a step that fails for another reason is halved", "[solvers]") {
    ErrorControl steps(1.0, 0.1, order, {});
    REQUIRE(steps.reject());
    CHECK(steps.time_step() == 0.05);
    REQUIRE(steps.reject());
    CHECK(steps.time_step() == 0.025);
    // An error from before does not count.
    CHECK_FALSE(steps.admits(1.0));
    REQUIRE(steps.reject());
    const double cut = steps.time_step();
    REQUIRE(steps.reject());
    CHECK(steps.time_step() == 0.5 * cut);
    // Nor does one that is no number.
    CHECK_FALSE(steps.admits(std::numeric_limits<double>::quiet_NaN()));
    REQUIRE(steps.reject());
    CHECK(steps.time_step() == 0.25 * cut);
}

TEST_CASE("steps keep within their limits", "[solvers]") {
    ErrorControl steps(1.0, 1.0, order, {.tolerance = 1e-4, .min_step = 1e-3, .max_step = 0.07});
    CHECK(steps.time_step() == 0.07);
    run(
        steps,
        [](double, double) { return 0.0; },
        [](const ErrorControl& s) { CHECK(s.time_step() <= 0.07); });
    CHECK(steps.time() == 1.0);
    ErrorControl short_steps(1.0, 1e-6, order, {.tolerance = 1e-4, .min_step = 1e-3, .max_step = 0.07});
    CHECK(short_steps.time_step() == 1e-3);
    CHECK_FALSE(short_steps.reject());
    ErrorControl failing(1.0, 4e-3, order, {.tolerance = 1e-4, .min_step = 1e-3});
    CHECK_FALSE(failing.admits(1.0));
    REQUIRE(failing.reject());
    CHECK(failing.time_step() == 1e-3);
    CHECK_FALSE(failing.admits(1.0));
    CHECK_FALSE(failing.reject());
    CHECK(failing.time() == 0.0);
}

TEST_CASE("without a shortest step a failure still ends", "[solvers]") {
    ErrorControl steps(10.0, 1.0, order, {});
    int rejected = 0;
    while (steps.reject()) ++rejected;
    CHECK(rejected == 37);  // 2⁻³⁷ < 1e-11
}

TEST_CASE("the end is met exactly and without a sliver", "[solvers]") {
    for (const double first : {0.1, 0.3, 1.0 / 3.0, 0.0123, 0.69999999, 0.7, 5.0}) {
        ErrorControl steps(0.7, first, order, {.max_step = first});
        double shortest = first;
        run(
            steps,
            [](double, double) { return 0.0; },
            [&](const ErrorControl& s) { shortest = std::min(shortest, s.time_step()); });
        CHECK(steps.time() == 0.7);
        CHECK(steps.part_done() == 1.0);
        CHECK(shortest >= 0.499 * std::min(first, 0.7));
    }
}

TEST_CASE("progress counts accepted steps and time", "[solvers]") {
    ErrorControl steps(1.0, 0.1, order, {.max_step = 0.1});
    CHECK(steps.steps_in_all() == 0);
    CHECK(steps.is_frame_due(3));
    for (int i = 1; i <= 7; ++i) {
        REQUIRE(steps.admits(0.0));
        steps.accept();
        CHECK(steps.steps_done() == i);
        CHECK(steps.part_done() == Approx(0.1 * i));
        CHECK(steps.is_frame_due(3) == (i % 3 == 0));
    }
}

TEST_CASE("the settings choose equal steps or steps by error", "[solvers]") {
    DynamicSettings settings;
    settings.end_time = 2.0;
    settings.steps = 8;
    CHECK(make_step_sequence(settings)->steps_in_all() == 8);
    CHECK(make_step_sequence(settings)->time_step() == 0.25);
    CHECK_FALSE(make_step_sequence(settings)->needs_error());
    settings.scheme = Scheme::sdirk_4;
    settings.adaptive = AdaptiveSettings{.tolerance = 0.5};
    const auto steps = make_step_sequence(settings);
    CHECK(steps->needs_error());
    CHECK(steps->steps_in_all() == 0);
    CHECK(steps->time_step() == 0.25);
    CHECK(steps->admits(0.5));
    CHECK_FALSE(steps->admits(0.51));
}
