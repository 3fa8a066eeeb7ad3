#include "check/step_impulse.hpp"

#include <cmath>
#include <numbers>

#include "tools/catch.hpp"

namespace gxrod {

namespace {

constexpr StepTimes times{1.0, 0.01};

// A pulse of height 1.
TimedLoad make_pulse(double from, double to) {
    return {[=](double t) { return t > from && t < to ? 1.0 : 0.0; }, {from, to}};
}

std::optional<LostImpulse> find(const TimedLoad& load, Scheme scheme) {
    DynamicSettings settings;
    settings.scheme = scheme;
    const auto integrator = make_integrator(settings);
    return find_lost_impulse(load, times, *integrator);
}

constexpr std::array schemes{Scheme::newmark_simplified,
                             Scheme::newmark_ibrahimbegovic,
                             Scheme::generalized_alpha,
                             Scheme::sdirk_4,
                             Scheme::runge_kutta_4};

}  // namespace

TEST_CASE("Every scheme misses a pulse between the times where it asks for loads", "[check]") {
    for (const Scheme scheme : schemes) {
        const auto lost = find(make_pulse(0.5031, 0.5039), scheme);
        INFO(static_cast<int>(scheme));
        REQUIRE(lost);
        CHECK(lost->from <= 0.5031);
        CHECK(lost->to >= 0.5039);
        CHECK(lost->exact == Approx(0.0008));
        CHECK(lost->step_needed < 0.01);
        // With the step needed, most of it is there.
        DynamicSettings settings;
        settings.scheme = scheme;
        CHECK_FALSE(find_lost_impulse(
            make_pulse(0.5031, 0.5039), {1.0, lost->step_needed}, *make_integrator(settings)));
    }
}

TEST_CASE("What is given is what the scheme makes of a load", "[check]") {
    // A peak of height 1 on a step, 0.002 wide: Newmark's trapezoids take it for one of two steps.
    const TimedLoad peak{[](double t) { return std::max(0.0, 1.0 - std::abs(t - 0.5) / 0.001); },
                         {0.499, 0.5, 0.501}};
    const auto newmark = find(peak, Scheme::newmark_simplified);
    REQUIRE(newmark);
    CHECK(newmark->given == Approx(0.01));
    CHECK(newmark->exact == Approx(0.001));
}

TEST_CASE("Loads that are switched once, or resolved, lose nothing", "[check]") {
    for (const Scheme scheme : schemes) {
        INFO(static_cast<int>(scheme));
        for (const double at : {0.0, 0.5, 0.5001, 0.5049, 0.5099, 0.985, 0.9999}) {
            const bool is_on_step = at == 0.0 || at == 0.5;
            if (scheme == Scheme::sdirk_4 && !is_on_step) continue;
            INFO(at);
            CHECK_FALSE(find({[=](double t) { return t > at ? 3.0 : 0.0; }, {at}}, scheme));
            CHECK_FALSE(find({[=](double t) { return t >= at ? -3.0 : 1.0; }, {at}}, scheme));
        }
        CHECK_FALSE(find({[](double t) { return std::sin(2.0 * std::numbers::pi * t / 0.1); }, {}}, scheme));
        CHECK_FALSE(find({[](double t) { return 5.0 + t * t; }, {}}, scheme));
        CHECK_FALSE(
            find({[](double t) { return std::sin(2.0 * std::numbers::pi * t / 0.1); }, {0.05, 0.1}}, scheme));
    }
    CHECK(find({[](double t) { return std::sin(2.0 * std::numbers::pi * t / 0.015); }, {}},
               Scheme::newmark_simplified));
}

TEST_CASE("sdirk-4 makes far too much of a jump between its stages at 1/2 and 11/20 of a step", "[check]") {
    // Its weights there are −85/12 and 125/16: after both, 1/4 and −49/48 are left.
    const auto lost = find({[](double t) { return t > 0.5053 ? 1.0 : 0.0; }, {0.5053}}, Scheme::sdirk_4);
    REQUIRE(lost);
    CHECK(lost->given - lost->exact == Approx(0.01 * (125.0 / 16.0 - 49.0 / 48.0 + 0.25 - 0.47)));
}

}  // namespace gxrod
