#include "check/step_advice.hpp"

#include <fmt/format.h>
#include <numbers>

#include "tools/catch.hpp"

using namespace gxrod;
using Catch::Contains;

namespace {

constexpr double cycle = 2.0 * std::numbers::pi;

// Periods of 1 and of 1/1000.
const MeshFrequencies found{cycle, 1000.0 * cycle, 0};

DynamicSettings make_settings(Scheme scheme, long steps) {
    DynamicSettings settings;
    settings.end_time = 1.0;
    settings.steps = steps;
    settings.scheme = scheme;
    return settings;
}

std::string describe(Scheme scheme, long steps) {
    return describe_steps(found, 0.0, make_settings(scheme, steps));
}

}  // namespace

TEST_CASE("A step is compared with the longest and the shortest period", "[check]") {
    CHECK(describe(Scheme::newmark_simplified, 40) ==
          "  a step of 0.025 is 1/40 of the longest period and 25 of the shortest\n");
    CHECK_THAT(describe(Scheme::newmark_simplified, 4000),
               Contains("1/4000 of the longest") && Contains("1/4 of the shortest"));
}

TEST_CASE("With contact no scheme is recommended that does not take it", "[check]") {
    const DynamicSettings settings = make_settings(Scheme::newmark_simplified, 10);
    CHECK_THAT(describe_steps(found, 0.0, settings), Contains("which takes radau-5"));
    CHECK_THAT(describe_steps(found, 0.0, settings, true),
               Contains("expected time_step = 0.05\n") && !Contains("radau"));
}

TEST_CASE("Steps too long for the longest period are reported by what each scheme needs", "[check]") {
    const std::string newmark = describe(Scheme::newmark_simplified, 19);
    CHECK_THAT(
        newmark,
        Contains("  newmark-simplified needs some 20 steps in a period that matters: expected time_step = "
                 "0.05, or accuracy = 1e-3 in its place, which takes radau-5\n"));
    CHECK_THAT(describe(Scheme::newmark_simplified, 21), !Contains("needs"));
    CHECK_THAT(describe(Scheme::generalized_alpha, 19), Contains("generalized-alpha needs some 20"));
    CHECK_THAT(describe(Scheme::radau_5, 5), !Contains("needs"));
    CHECK_THAT(describe(Scheme::radau_5, 3),
               Contains("radau-5 needs some 4 steps in a period that matters: expected time_step = 0.25, or "
                        "accuracy = 1e-3 in its place\n"));
}

TEST_CASE("Schemes that stiff rods do not suit are reported", "[check]") {
    // A step of a third of the shortest period is 2.1 rad of it.
    CHECK_THAT(describe(Scheme::sdirk_4, 2900),
               Contains("sdirk-4 with these steps does not resolve the highest"));
    CHECK_THAT(describe(Scheme::sdirk_4, 3200), !Contains("sdirk-4"));
    CHECK_THAT(describe(Scheme::gauss_4, 2900),
               Contains("gauss-4") && Contains("damps nothing") && Contains("radau-5"));
    CHECK_THAT(describe(Scheme::gauss_4, 3200), !Contains("gauss-4"));
    for (const Scheme scheme : {Scheme::newmark_simplified, Scheme::generalized_alpha, Scheme::radau_5})
        CHECK_THAT(describe(scheme, 2900), !Contains("resolve"));
}

TEST_CASE("An explicit scheme is compared with the longest stable step", "[check]") {
    // 2√2 over the highest angular frequency.
    const std::string limit =
        fmt::format("stable up to time steps of {:.3g}", 2.0 * std::numbers::sqrt2 / found.highest);
    CHECK_THAT(
        describe(Scheme::runge_kutta_4, 2221),
        Contains(limit + ": this deck's, 0.00045, will fail; accuracy = 1e-3 in its place takes radau-5\n"));
    CHECK_THAT(describe(Scheme::runge_kutta_4, 2223), Contains(limit + "\n") && !Contains("fail"));
}

TEST_CASE("Steps by their error are not compared", "[check]") {
    DynamicSettings settings = make_settings(Scheme::radau_5, 2);
    settings.adaptive = AdaptiveSettings{};
    CHECK(describe_steps(found, 0.0, settings).empty());
}

TEST_CASE("A step in which the model turns far is reported", "[check]") {
    Model model;
    model.nodes = {{.name = "still", .position = Vec3::Zero()},
                   {.name = "top", .position = Vec3::Zero(), .angular_velocity = Vec3(0.0, 3.0, 4.0)}};
    // A twentieth of a turn in 0.0628.
    CHECK(describe_turning(model, make_settings(Scheme::newmark_simplified, 16)).empty());
    CHECK(describe_turning(model, make_settings(Scheme::newmark_simplified, 10)) ==
          "  a step turns top by 0.5 rad, a turn in 13 steps, at t = 0: expected time_step = 0.063, or "
          "accuracy = 1e-3 in its place, which takes radau-5\n");
    CHECK(describe_turning(model, make_settings(Scheme::radau_5, 4)).empty());
    CHECK_THAT(describe_turning(model, make_settings(Scheme::radau_5, 3)), Contains("turns top by 1.7 rad"));
    CHECK(describe_turning({}, make_settings(Scheme::newmark_simplified, 1)).empty());
}
