#include "solvers/steps/step_grid.hpp"

#include <numbers>

#include "tools/catch.hpp"

using namespace gxrod;

TEST_CASE("times of a grid are the decimals that a user would write", "[solvers]") {
    const StepGrid tenths(0.1, 1024);
    CHECK(tenths.at(3 * 1024) == 0.3);
    CHECK(tenths.at(7 * 1024) == 0.7);
    CHECK(tenths.at(10 * 1024) == 1.0);
    CHECK(tenths.at(512) == 0.05);
    CHECK(StepGrid(0.0025, 1).at(1000) == 2.5);
    CHECK(StepGrid(1e-4, 1).at(12345) == 1.2345);
    CHECK(StepGrid(0.3, 1).at(7) == 2.1);
    CHECK(StepGrid(1.0 / 3.0, 1).at(3) == 1.0);
    CHECK(StepGrid(5.0, 1).at(3) == 15.0);
    CHECK(StepGrid(1e-9, 1).at(3) == Approx(3e-9).epsilon(1e-15));
    CHECK(StepGrid(2.5e7, 1).at(4) == Approx(1e8).epsilon(1e-15));
}

TEST_CASE("times and steps of a grid do not depend on where a run ends", "[solvers]") {
    std::size_t rounded = 0;
    for (std::int64_t steps = 1; steps <= 1000; ++steps) {
        const double end = static_cast<double>(steps) / 100.0;
        const double step = end / static_cast<double>(steps);
        rounded += step != 0.01;
        const StepGrid grid(step, 1024);
        CHECK(grid.step() == 0.01);
        CHECK(grid.at(steps * 1024) == end);
        CHECK(grid.at(7 * 1024) == 0.07);
    }
    CHECK(rounded > 10);  // or nothing was tried
}

TEST_CASE("a step that is not a fraction is counted as it is", "[solvers]") {
    const double step = 0.01 * std::numbers::pi;
    const StepGrid grid(step, 1024);
    CHECK(grid.at(100 * 1024) == 100.0 * step);
    CHECK(grid.at(1) == step / 1024.0);
}

TEST_CASE("a time is found on the grid", "[solvers]") {
    const StepGrid grid(0.01, 1024);
    for (const std::int64_t position : {0L, 1L, 1023L, 1024L, 700L * 1024L + 37L}) {
        const StepGrid::Place place = grid.find(grid.at(position));
        CHECK(place.is_exact);
        CHECK(place.position == position);
    }
    CHECK(grid.find(0.07 * (1.0 + 1e-15)).is_exact);
    CHECK_FALSE(grid.find(0.07 * (1.0 + 1e-6)).is_exact);
}
