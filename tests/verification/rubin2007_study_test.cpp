#include "verification/rubin2007_study.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "machine/file_error.hpp"
#include "tools/catch.hpp"
#include "tools/run.hpp"

using namespace gxrod;
using namespace gxrod::rubin2007;

namespace {

// The errors of a scheme at N steps, N given by its references.
Errors errors_of(StudyScheme scheme, long steps) {
    const Row row = run_scheme(scheme, steps).row;
    REQUIRE(row.errors);
    return *row.errors;
}

std::size_t count_lines(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::size_t lines = 0;
    for (std::string line; std::getline(file, line);) ++lines;
    return lines;
}

}  // namespace

TEST_CASE("the study of the paper's problem agrees with every reference", "[verification]") {
    REQUIRE(references().size() == 33);
    for (const Reference& reference : references()) {
        INFO(name_of(reference.scheme) << " at " << reference.steps);
        const Row row = run_scheme(reference.scheme, reference.steps).row;
        const Comparison comparison = compare(row);
        CHECK(comparison.reference == &reference);
        CHECK(comparison.matches);
        CHECK(row.diverged == reference.diverges);
        CHECK(row.errors.has_value() != row.diverged);
        const bool implicit =
            reference.scheme != StudyScheme::matrix_rk4 && reference.scheme != StudyScheme::quaternion_rk4;
        CHECK(row.iterations_per_step.has_value() == implicit);
    }
}

TEST_CASE("a value that is off by one in the fifth digit does not agree", "[verification]") {
    Row row = run_scheme(StudyScheme::newmark_ibrahimbegovic, 100).row;
    REQUIRE(compare(row).matches);
    const Row good = row;
    row.errors->orientation = 0.144904 + 1.1e-6 * 5.0;
    CHECK_FALSE(compare(row).matches);
    row = good;
    row.errors->momentum *= 1.0001;
    CHECK_FALSE(compare(row).matches);
    row = good;
    row.errors->energy *= 0.9999;
    CHECK_FALSE(compare(row).matches);
    row = good;
    *row.max_theta_deg += 0.001;
    CHECK_FALSE(compare(row).matches);
    row = good;
    row.diverged = true;
    CHECK_FALSE(compare(row).matches);
    row = good;
    row.steps = 101;
    CHECK(compare(row).reference == nullptr);
    CHECK(compare(row).matches);
}

TEST_CASE("orders of the study: 2 for (S) and (I), 4 and more for the Runge-Kutta schemes",
          "[verification]") {
    for (const auto& [scheme, steps, order] : {std::tuple(StudyScheme::newmark_simplified, 800L, 2.0),
                                               {StudyScheme::newmark_ibrahimbegovic, 800L, 2.0},
                                               {StudyScheme::sdirk_4, 320L, 4.0},
                                               {StudyScheme::radau_5, 200L, 5.0},
                                               {StudyScheme::gauss_4, 320L, 4.0},
                                               {StudyScheme::quaternion_rk4, 800L, 4.0}}) {
        INFO(name_of(scheme));
        const Errors coarse = errors_of(scheme, steps);
        const Errors fine = errors_of(scheme, 2 * steps);
        CHECK(std::log2(coarse.orientation / fine.orientation) == Approx(order).margin(0.05));
        CHECK(std::log2(coarse.momentum / fine.momentum) == Approx(order).margin(0.15));  // RK4Q: 3.87
    }
    // The matrix scheme falls faster here: the leading error happens to be small.
    const double ratio = errors_of(StudyScheme::matrix_rk4, 800).orientation /
                         errors_of(StudyScheme::matrix_rk4, 1600).orientation;
    CHECK(std::log2(ratio) > 3.8);
}

TEST_CASE("a trace holds the errors at t = 0 and after each step", "[verification]") {
    for (const StudyScheme scheme : {StudyScheme::newmark_simplified, StudyScheme::matrix_rk4}) {
        const Trace trace = run_scheme(scheme, 200);
        REQUIRE(trace.samples.size() == 201);
        CHECK(trace.samples.front().time == 0.0);
        CHECK(trace.samples.front().errors.orientation < 1e-15);
        CHECK(trace.samples.back().time == Approx(period).epsilon(1e-15));
        double worst = 0.0;
        for (const Sample& sample : trace.samples) worst = std::max(worst, sample.errors.orientation);
        CHECK(worst == trace.row.errors->orientation);
    }
}

TEST_CASE("the data of the figures are written", "[verification]") {
    const auto folder =
        std::filesystem::temp_directory_path() / ("gxrod_rubin2007_figures_test_" + std::to_string(getpid()));
    std::filesystem::remove_all(folder);
    write_figure_data(folder / "data", run_study({100}));
    CHECK(count_lines(folder / "data" / "fig2.csv") == 2002);
    CHECK(count_lines(folder / "data" / "fig3.csv") == 1 + 6 * (figure_steps + 1));
    CHECK(count_lines(folder / "data" / "fig4.csv") == 1 + 6);
    // A file is where the folder should be.
    CHECK_THROWS_AS(write_figure_data(folder / "data" / "fig2.csv", {}), FileError);
    std::filesystem::remove_all(folder);
}
