#include "model/time/breaks.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "tools/catch.hpp"

namespace gxrod {

namespace {

Switch make_switch(std::function<double(double, double)> argument, std::vector<double> knots = {0.0}) {
    return {std::move(argument), std::move(knots)};
}

void check_places(const std::vector<double>& found,
                  const std::vector<double>& expected,
                  double margin = 1e-14) {
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) CHECK(std::abs(found[i] - expected[i]) <= margin * 10.0);
}

std::vector<double> along(const Switches& switches, double time = 0.0) {
    return find_breaks_along(switches, time, {0.0, 10.0}, 64);
}

}  // namespace

TEST_CASE("Breaks are found where arguments cross their knots", "[model]") {
    check_places(along({make_switch([](double, double s) { return s - 2.0; }),
                        make_switch([](double, double s) { return s - 2.5; })}),
                 {2.0, 2.5});
    // As exact as numbers are, so that a jump on a node is on it.
    CHECK(along({make_switch([](double, double s) { return s - 5.0; })}) == std::vector{5.0});
    check_places(along({make_switch([](double t, double s) { return s - 2.0 * t; })}, 1.3), {2.6});
    CHECK(along({make_switch([](double, double s) { return s - 11.0; })}).empty());
    CHECK(along({make_switch([](double, double) { return 0.0; })}).empty());
}

TEST_CASE("Each knot between two places is crossed", "[model]") {
    check_places(along({make_switch([](double, double s) { return s * s; },
                                    {0.0, 0.01, 4.0, 4.0001, 9.0, 50.0, 200.0})}),
                 {0.1, 2.0, std::sqrt(4.0001), 3.0, std::sqrt(50.0)});
    const double half = std::numbers::pi / 3.0;
    std::vector<double> expected;
    for (int i = 1; i * half < 10.0; ++i) expected.push_back(i * half);
    check_places(along({make_switch([](double, double s) { return std::sin(3.0 * s); })}), expected);
}

TEST_CASE("Narrow excursions between two places are found", "[model]") {
    // Far narrower than the places are apart: by the break of the argument within, or by the argument's
    // turning.
    const Switches nested{make_switch([](double, double s) { return s - 2.01; }),
                          make_switch([](double, double s) { return std::abs(s - 2.01) - 1e-5; })};
    check_places(along(nested), {2.01 - 1e-5, 2.01, 2.01 + 1e-5});
    check_places(along({make_switch([](double, double s) { return (s - 2.01) * (s - 2.01) - 1e-8; })}),
                 {2.0099, 2.0101},
                 1e-11);
    // One that touches a knot and turns back.
    const auto touched = along({make_switch([](double, double s) { return std::cos(s); }, {-1.0, 1.0})});
    REQUIRE(touched.size() >= 3);
    CHECK(std::any_of(
        touched.begin(), touched.end(), [](double s) { return std::abs(s - std::numbers::pi) < 1e-6; }));
}

TEST_CASE("Switches of the other variable, and NaN arguments, have no breaks", "[model]") {
    Switch of_time = make_switch([](double t, double) { return t - 0.5; });
    of_time.has_arc_length = false;
    CHECK(along({of_time}).empty());
    CHECK(find_breaks_in_time({of_time}, {0.0, 1.0}, 10) == std::vector{0.5});
    Switch table = make_switch([](double t, double) { return t; }, {0.0, 0.3, 0.300001, 1.0, 2.0});
    table.is_variable = true;
    table.has_arc_length = false;
    CHECK(find_breaks_in_time({table}, {0.0, 1.0}, 10) == std::vector{0.3, 0.300001});
    const double nan = std::numeric_limits<double>::quiet_NaN();
    check_places(along({make_switch([nan](double, double s) { return s < 4.0 ? nan : s - 6.0; })}), {6.0});
    CHECK(along({make_switch([nan](double, double) { return nan; })}).empty());
}

}  // namespace gxrod
