#include "study/series_reports.hpp"

#include <cmath>

#include "tools/catch.hpp"
#include "watch/quantities.hpp"

using namespace gxrod;

namespace {

const std::vector<Series> tip{{"tip", "position", 0, find_quantity("position"), Turning::vector}};

// At times 0, 1, 2: the way 0, 1, 2 and what is added to it, times the time.
StudyRows::Rows make_rows(double more) {
    std::vector<HistoryRow> rows;
    for (const double t : {0.0, 1.0, 2.0}) rows.push_back({t + more * t, 0, 0, 0});
    return {rows};
}

DeckStudy make_study() {
    DeckStudy study;
    study.expected_order = 2.0;
    study.tolerance = 0.02;
    study.times = {0.0, 1.0, 2.0};
    study.runs.emplace_back();
    return study;
}

StudyRows make_found() {
    StudyRows found;
    found.base = make_rows(0.016);
    found.steps = {make_rows(0.004), make_rows(0.001)};
    found.meshes = {make_rows(0.014)};
    found.natural.length = 4.0;
    found.round_off = {{0.0, 0.0, 3e-5}};
    found.turned_differences = {0.125};
    return found;
}

}  // namespace

TEST_CASE("the error of a series is that of step, mesh and round-off together", "[study]") {
    const SeriesReport report = make_reports(tip, make_found(), make_study()).front();
    CHECK(report.scale == Approx(2.032));
    // 16 h² of the step; of the mesh the difference times 4/3; all grow with time.
    CHECK(*report.steps.order == Approx(2.0));
    CHECK(report.steps.largest() == Approx(2.0 * 0.016));
    CHECK(report.mesh.largest() == Approx(2.0 * 0.002 * 4.0 / 3.0));
    CHECK(report.error == Approx(2.0 * (0.016 + 0.008 / 3.0) + 3e-5));
    CHECK(report.trusted_until == 2.0);
    CHECK(report.turned_difference == 0.125);
    CHECK(report.order_difference == 0.0);
    DeckStudy strict = make_study();
    strict.tolerance = 0.01;
    CHECK(make_reports(tip, make_found(), strict).front().trusted_until == 1.0);
}

TEST_CASE("differences within ten times the round-off show no order", "[study]") {
    StudyRows found = make_found();
    found.round_off = {{0.0, 0.0, 0.5e-3}};
    // The second difference is 6e-3.
    CHECK(make_reports(tip, found, make_study()).front().steps.order);
    found.round_off = {{0.0, 0.0, 0.7e-3}};
    CHECK_FALSE(make_reports(tip, found, make_study()).front().steps.order);
    CHECK(make_reports(tip, found, make_study()).front().round_off == 0.7e-3);
    // What is not measured is at least that of numbers of the model's length.
    found.round_off.clear();
    CHECK(make_reports(tip, found, make_study()).front().round_off == Approx(3.6e-15).epsilon(0.02));
}

TEST_CASE("the error is infinite where runs that show it are missing", "[study]") {
    DeckStudy study = make_study();
    study.variants = {{VariantKind::finer_mesh, 1, "twice the elements"}};
    const SeriesReport report = make_reports(tip, make_found(), study).front();
    CHECK(std::isinf(report.error));
    CHECK(report.trusted_until == 0.0);
    CHECK(report.steps.is_known());
}
