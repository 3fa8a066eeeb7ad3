#include "model/time/transitions.hpp"

#include <cmath>
#include <memory>

#include "tools/catch.hpp"

namespace gxrod {

namespace {

// A function whose form changes where `argument` crosses 0.
TimeFunction make_function(std::function<double(double)> value, std::function<double(double)> argument) {
    return TimeFunction(
        std::move(value),
        std::make_shared<Switches>(Switches{{[argument](double t, double) { return argument(t); }, {0.0}}}));
}

std::vector<Transition> find(const TimeFunction& function) {
    return find_transitions(function, {0.0, 1.0}, 100);
}

}  // namespace

TEST_CASE("A jump is found with its time and both values", "[model]") {
    const auto found =
        find(make_function([](double t) { return t < 0.5 ? 0.0 : 0.1; }, [](double t) { return t - 0.5; }));
    REQUIRE(found.size() == 1);
    CHECK(found[0].time == 0.5);
    CHECK(found[0].is_jump);
    CHECK_FALSE(found[0].is_kink);
    CHECK(found[0].value_before == 0.0);
    CHECK(found[0].value_after == 0.1);
    // Right at the start, and right at the end.
    CHECK(find(make_function([](double t) { return t > 0.0 ? 0.1 : 0.0; }, [](double t) { return t; }))
              .at(0)
              .is_jump);
    CHECK(find(make_function([](double t) { return t < 1.0 ? t : 0.0; }, [](double t) { return t - 1.0; }))
              .at(0)
              .is_jump);
}

TEST_CASE("A kink is found with its slopes; smooth transitions are not kinks", "[model]") {
    const auto found = find(
        make_function([](double t) { return t < 0.25 ? 4.0 * t : 1.0; }, [](double t) { return t - 0.25; }));
    REQUIRE(found.size() == 1);
    CHECK(found[0].is_kink);
    CHECK_FALSE(found[0].is_jump);
    CHECK(found[0].slope_before == Approx(4.0));
    CHECK(std::abs(found[0].slope_after) < 1e-9);
    CHECK(find(make_function([](double t) { return t < 0.5 ? 12.0 * t * t - 16.0 * t * t * t : 1.0; },
                             [](double t) { return t - 0.5; }))
              .empty());
    CHECK(find(make_function([](double t) { return std::sin(9.0 * t); }, [](double t) { return t - 0.4; }))
              .empty());
    CHECK(find(TimeFunction([](double t) { return t; })).empty());
}

}  // namespace gxrod
