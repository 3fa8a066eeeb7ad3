#include <algorithm>
#include <cmath>
#include <filesystem>

#include "check/shape_report.hpp"
#include "deck/decks.hpp"
#include "deck/text/text_file.hpp"
#include "results/export/csv_export.hpp"
#include "results/file/hdf5_reader.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"
#include "tools/problem_run.hpp"

// Eigenvalues over a number of the deck.
using namespace gxrod;
using namespace gxrod::tools;
using test::faults_of;
using test::read;
using test::replaced;

namespace {

// Beck's column. Lines 1 to 17.
const std::string column = R"(plane = "xy"
[parameters]
P = 5.0
stretch = 1.0
[section.s]
stiffness = { EA = 1e4, GAy = 4e3, GAz = 4e3, GJ = 1, EIy = 1, EIz = 1 }
inertia = { rhoA = 1, rhoJ = 2e-4, rhoIy = 1e-4, rhoIz = 1e-4 }
[rod.column]
section = "s"
line = { from = [0, 0, 0], to = ["stretch", 0, 0] }
elements = 8
order = 4
[[support]]
at = "column.start"
fix = "all"
[[load]]
at = "column.end"
force = ["-P", 0, 0]
frame = "follower"
)";

const std::string press = "[[stage]]\nname = \"press\"\nkind = \"static\"\nsteps = 2\n";

std::string sweep_of(const std::string& sweep) {
    return "[[stage]]\nname = \"sweep\"\nkind = \"eigenvalues\"\ncount = 2\nsweep = { " + sweep + " }\n";
}

const SweepRecord& sweep_in(const RunSummary& summary) {
    return std::get<SweepRecord>(summary.shapes.at(0).record);
}

}  // namespace

TEST_CASE("A sweep follows modes over a load and locates flutter", "[analyses][sweep]") {
    const RunSummary summary =
        run_problem(read(column + press + sweep_of("key = \"parameters.P\", from = 0, to = 25, count = 6")));
    REQUIRE(summary.status == RunStatus::complete);
    const SweepRecord& sweep = sweep_in(summary);
    CHECK(sweep.key == "parameters.P");
    REQUIRE(sweep.points.size() == 6);
    // P9a, rod B: two independent programs.
    const std::array<std::array<double, 2>, 4> rows{{{3.5131597338, 21.9106231789},
                                                     {4.2153199872, 20.3156816471},
                                                     {5.1769330890, 18.4666032766},
                                                     {6.6424272156, 16.1279336099}}};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        CHECK(sweep.points[i].value == 5.0 * static_cast<double>(i));
        for (std::size_t mode = 0; mode < 2; ++mode)
            CHECK(sweep.points[i].lambda[mode].imag() == Approx(rows[i][mode]).epsilon(1e-8));
    }
    REQUIRE(sweep.onsets.size() == 1);
    CHECK(sweep.onsets[0].is_flutter);
    CHECK(sweep.onsets[0].begins);
    CHECK(sweep.onsets[0].value == Approx(19.9166940433).epsilon(1e-8));
    CHECK(sweep.onsets[0].omega == Approx(10.968801873).epsilon(1e-8));
    const std::vector<std::string> lines = list_shapes(summary.shapes[0].record, 10);
    REQUIRE(lines.size() == 4);
    CHECK(lines[0] == "2 modes followed over 6 values of parameters.P, from 0 to 25");
    CHECK(lines[3].starts_with("flutter begins at parameters.P = 19.916694"));
}

TEST_CASE("A sweep may change the reference shape, and go downwards", "[analyses][sweep]") {
    const RunSummary summary =
        run_problem(read(replaced(column, "\"-P\"", "0") + press +
                         sweep_of("key = \"parameters.stretch\", values = [2.0, 1.0], onset = \"off\"")));
    REQUIRE(summary.status == RunStatus::complete);
    const SweepRecord& sweep = sweep_in(summary);
    CHECK(sweep.onsets.empty());
    CHECK(sweep.points[1].lambda[0].imag() == Approx(3.5131597338).epsilon(1e-8));
    // Twice as long: slower by 4 but for shear and rotary inertia, which are small in it.
    CHECK(sweep.points[0].lambda[0].imag() == Approx(3.516015 / 4.0).epsilon(1e-3));
}

TEST_CASE("A sweep without stages before is about the reference shape", "[analyses][sweep]") {
    const RunSummary summary =
        run_problem(read(column + "[analysis]\nkind = \"eigenvalues\"\ncount = 1\n"
                                  "sweep = { key = \"section.s.stiffness.EIz\", values = [1, 4] }\n"));
    REQUIRE(summary.status == RunStatus::complete);
    const SweepRecord& sweep = sweep_in(summary);
    CHECK(sweep.points[0].lambda[0].imag() == Approx(3.5131597338).epsilon(1e-8));
    CHECK(sweep.points[1].lambda[0].imag() == Approx(2.0 * 3.5131597338).epsilon(5e-3));
}

TEST_CASE("Results and tables hold a sweep", "[analyses][sweep]") {
    const sample::ScratchFolder folder;
    const auto file = folder / "column.vtkhdf";
    REQUIRE(run_problem(
                read(column + press + sweep_of("key = \"parameters.P\", from = 0, to = 25, count = 6")), file)
                .status == RunStatus::complete);
    {
        const Hdf5Reader results(file);
        CHECK(results.numbers("/stages/sweep/value") == std::vector<double>{0, 5, 10, 15, 20, 25});
        CHECK(results.size("/stages/sweep/omega") == std::vector<hsize_t>{6, 2});
        CHECK(results.numbers("/stages/sweep/omega")[3] == Approx(20.3156816471).epsilon(1e-8));
        CHECK(results.numbers("/stages/sweep/growth")[6] == Approx(0.0).margin(1e-6));
        CHECK(std::abs(results.numbers("/stages/sweep/growth")[8]) > 0.1);
        CHECK(results.numbers("/stages/sweep/largest_growth")[4] > 0.1);
        CHECK(results.numbers("/stages/sweep/onset/value").at(0) == Approx(19.9166940433).epsilon(1e-8));
        CHECK(results.texts("/stages/sweep/onset/kind").at(0) == "flutter");
        CHECK(results.text_attribute("/stages/sweep", "key") == "parameters.P");
    }
    export_csv(file, folder / "csv", Existing::replace);
    const std::string table = read_text_file(folder / "csv/stage_sweep.csv", "a table", 100'000);
    CHECK(table.starts_with(
        "value,speed,largest_growth,omega_1,omega_2,growth_1,growth_2,corruption_1,corruption_2\n0,0,"));
    CHECK(read_text_file(folder / "csv/stage_sweep_onset.csv", "a table", 100'000)
              .starts_with("begins,kind,omega,value\n1,flutter,10.9688"));
}

TEST_CASE("A sweep keeps shapes and words at each value", "[analyses][sweep]") {
    const sample::ScratchFolder folder;
    const auto file = folder / "column.vtkhdf";
    const RunSummary summary = run_problem(
        read(column + press + sweep_of("key = \"parameters.P\", values = [0, 5, 25], shapes = true")), file);
    REQUIRE(summary.status == RunStatus::complete);
    const SweepRecord& sweep = sweep_in(summary);
    // Each is the mode that a stage of its own finds at the same load.
    for (std::size_t i = 0; i < sweep.points.size(); ++i) {
        const std::string load = "P = " + std::to_string(sweep.points[i].value);
        const RunSummary alone =
            run_problem(read(replaced(column, "P = 5.0", load) + press +
                             "[[stage]]\nname = \"alone\"\nkind = \"eigenvalues\"\ncount = 2\n"));
        const auto& modes = std::get<EigenvaluesRecord>(alone.shapes.at(0).record).modes;
        REQUIRE(sweep.points[i].modes.size() == 2);
        for (std::size_t mode = 0; mode < 2; ++mode) {
            const Eigenmode& kept = sweep.points[i].modes[mode];
            const auto same = std::ranges::find_if(
                modes, [&](const Eigenmode& one) { return std::abs(one.lambda() - kept.lambda()) < 1e-6; });
            REQUIRE(same != modes.end());
            CHECK(sweep.points[i].words[mode] == same->shape.words);
            double largest = 0.0;
            for (std::size_t node = 0; node < kept.shape.nodes.size(); ++node)
                largest = std::max(largest, (kept.shape.nodes[node] - same->shape.nodes[node]).norm());
            CHECK(largest < 1e-5);
        }
    }
    CHECK(sweep.points[0].modes[0].shape.nodes != sweep.points[1].modes[0].shape.nodes);
    const std::size_t nodes = sweep.points[0].nodes.size();
    const Hdf5Reader results(file);
    CHECK(results.texts("/stages/sweep/words_at_values").size() == 6);
    CHECK(results.texts("/stages/sweep/words_at_values").at(3) == sweep.points[1].words[1]);
    const std::vector<double> scales = results.numbers("/stages/sweep/scale");
    REQUIRE(scales.size() == 6);
    const Hdf5Reader shapes(folder / "column.sweep.vtkhdf");
    CHECK(shapes.size("/VTKHDF/Points") == std::vector<hsize_t>{6 * nodes, 3});
    const std::vector<double> moves = shapes.rows("/VTKHDF/PointData/displacement", 3 * nodes, nodes, 3);
    for (std::size_t node = 0; node < nodes; ++node) {
        for (int k = 0; k < 3; ++k)
            CHECK(moves[3 * node + static_cast<std::size_t>(k)] ==
                  Approx(scales[3] * sweep.points[1].modes[1].shape.nodes[node][k]).margin(1e-15));
    }
    // The column is shorter under 5 than under 0.
    const std::vector<double> tops = shapes.rows("/VTKHDF/Points", 0, 6 * nodes, 3);
    CHECK(tops[3 * (nodes - 1)] == Approx(1.0).epsilon(1e-12));
    CHECK(tops[3 * (3 * nodes - 1)] == Approx(1.0 - 5e-4).epsilon(1e-6));
}

TEST_CASE("A sweep without shapes writes words alone", "[analyses][sweep]") {
    const sample::ScratchFolder folder;
    const auto file = folder / "column.vtkhdf";
    REQUIRE(run_problem(read(column + press + sweep_of("key = \"parameters.P\", values = [0, 5]")), file)
                .status == RunStatus::complete);
    const Hdf5Reader results(file);
    CHECK(results.texts("/stages/sweep/words_at_values").size() == 4);
    CHECK_FALSE(results.has("/stages/sweep/scale"));
    CHECK_FALSE(std::filesystem::exists(folder / "column.sweep.vtkhdf"));
}

TEST_CASE("Sweeps that cannot be are refused", "[analyses][sweep]") {
    const auto faults = [](const std::string& sweep) { return faults_of(column + press + sweep_of(sweep)); };
    CHECK(faults("key = \"parameters.Q\", values = [1]") ==
          "x.toml:28:17: stage[1].sweep.key: the deck has no parameter \"Q\"; it has P, stretch");
    CHECK(faults("key = \"rod.column.elements\", values = [0.5]") ==
          "x.toml:28:17: stage[1].sweep.key: with rod.column.elements=0.5: expected an integer from 1 to "
          "10000000, found 0.5");
    CHECK(faults("key = \"parameters.P\", from = 1, to = 1") ==
          "x.toml:28:48: stage[1].sweep.to: expected another number than that of from");
    CHECK(faults("key = \"parameters.P\", from = -1, to = 1, spacing = \"log\"") ==
          "x.toml:28:49: stage[1].sweep.to: equal ratios need two numbers of one sign that are not 0");
    const std::string shake = "[[stage]]\nname = \"shake\"\nkind = \"dynamic\"\nend_time = 1\nsteps = 10\n";
    CHECK(faults_of(column + press + shake + sweep_of("key = \"parameters.P\", values = [1]")) ==
          "x.toml:33:9: stage[2].sweep: only static and steady stages may come before, and one of kind "
          "dynamic does");
}

TEST_CASE("A value without an equilibrium is reported, and the others are found", "[analyses][sweep]") {
    SweepRecord record;
    record.key = "parameters.P";
    record.words = {"bending about z of column"};
    record.points.resize(3);
    for (std::size_t i = 0; i < 3; ++i) record.points[i].value = static_cast<double>(i) + 1.0;
    record.points[0].lambda = {{0.0, 2.0}};
    record.points[1].failure = "Newton's method failed";
    record.points[2].lambda = {{std::nan(""), std::nan("")}};
    const std::vector<std::string> warnings = warn_of_shapes(record);
    REQUIRE(warnings.size() == 2);
    CHECK(warnings[0] == "nothing was found at 1 of 3 values of parameters.P; at 2: Newton's method failed");
    CHECK(warnings[1].starts_with("mode 1 is lost at parameters.P = 3: "));
}
