#include "verification/benchmark.hpp"

#include "tools/catch.hpp"

using namespace gxrod;

namespace {

// A bar pulled by a force that grows with t: its end moves by exactly t/100 in theory of small strains and
// finite ones alike.
const std::string bar = R"([section.s]
stiffness = { EA = 100, GAy = 50, GAz = 50, GJ = 1, EIy = 1, EIz = 1 }
[rod.bar]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 2
[[support]]
at = "bar.start"
fix = "all"
[[load]]
at = "bar.end"
force = [1, 0, 0]
[analysis]
kind = "static"
steps = 2
[[history]]
name = "end"
at = "bar.end"
quantities = ["displacement"]
)";

Benchmark make_benchmark(const BenchmarkValue& value) {
    Benchmark benchmark;
    benchmark.name = "bar";
    benchmark.deck = bar;
    benchmark.values = {value};
    return benchmark;
}

const BenchmarkValue half_way{"end", "displacement", 0.5, false, {0.005, 0.0, 0.0}};

}  // namespace

TEST_CASE("a run is compared at the times at which values are known", "[verification]") {
    const BenchmarkRun run = run_benchmark(make_benchmark(half_way), {"rod.bar.elements=3"});
    CHECK(run.error < 1e-15);
    CHECK(run.unknowns == 18);
    CHECK(run.steps == 2);
    CHECK(run.newton_iterations >= 2);
    CHECK(run.energy_error < 1e-15);
}

TEST_CASE("errors are distances over a scale; NaN is not compared", "[verification]") {
    BenchmarkValue value = half_way;
    value.reference = {0.005 + 0.003, 0.004, 0.0};
    CHECK(run_benchmark(make_benchmark(value), {}).error == Approx(0.005));
    value.scale = 10.0;
    CHECK(run_benchmark(make_benchmark(value), {}).error == Approx(0.0005));
    value.reference[1] = std::nan("");
    CHECK(run_benchmark(make_benchmark(value), {}).error == Approx(0.0003));
}

TEST_CASE("values of the ledger are compared", "[verification]") {
    // Half of the force times the displacement.
    for (const char* quantity : {"energy", "strain_energy", "external_work"}) {
        CHECK(run_benchmark(make_benchmark({"ledger", quantity, 1.0, false, {0.005}}), {}).error < 1e-15);
    }
    CHECK(run_benchmark(make_benchmark({"ledger", "energy_less_work", 1.0, false, {0.0}}), {}).error < 1e-15);
    for (const char* quantity : {"linear_momentum", "angular_momentum"}) {
        CHECK(run_benchmark(make_benchmark({"ledger", quantity, 1.0, false, {0.0, 0.0, 2.0}}), {}).error ==
              2.0);
    }
}

TEST_CASE("for a value at all times the worst error is compared", "[verification]") {
    BenchmarkValue value = half_way;
    value.is_constant = true;
    const BenchmarkRun run = run_benchmark(make_benchmark(value), {});
    // It is 0 at the start and 0.01 at the end.
    CHECK(run.values[0].error == Approx(0.005));
    CHECK(run.error == run.values[0].error);
}

TEST_CASE("quaternions are compared with the nearer sign", "[verification]") {
    const BenchmarkValue turned{"end", "quaternion", 1.0, false, {-1.0, 0.0, 0.0, 0.0}};
    Benchmark benchmark = make_benchmark(turned);
    benchmark.deck.replace(benchmark.deck.find("\"displacement\""), 14, "\"quaternion\"");
    const BenchmarkRun run = run_benchmark(benchmark, {});
    CHECK(run.error < 1e-15);
    CHECK(run.values[0].value[0] == Approx(-1.0));
}

TEST_CASE("a wrong reference, order or tolerance is missed", "[verification]") {
    Benchmark benchmark = make_benchmark(half_way);
    Refinement refinement{"mesh", {{"rod.bar.elements=1"}, {"rod.bar.elements=2"}}, 0.0, 1e-12, 1e-12};
    benchmark.refinements = {refinement};
    CHECK(report_benchmark(benchmark).matches());
    CHECK_THAT(report_benchmark(benchmark).table, !Catch::Contains("MISSED"));
    benchmark.values[0].reference[0] = 0.0051;
    const StudyResult missed = report_benchmark(benchmark);
    CHECK_FALSE(missed.matches());
    CHECK_THAT(missed.table, Catch::Contains("mesh MISSED"));
    REQUIRE(missed.json.size() == 2);
    CHECK(missed.json[1]["error"] == Approx(1e-4));
    CHECK(missed.json[0]["order"].is_null());
    REQUIRE(missed.checks.size() == 1);
    CHECK(missed.checks[0].what == "end displacement, t = 0.5; mesh");
    CHECK(missed.checks[0].error == Approx(1e-4));
    CHECK(missed.checks[0].tolerance == 1e-12);
    CHECK(missed.checks[0].value[0] == Approx(0.005));
    // An error that does not fall.
    benchmark.refinements[0].tolerance = 0.0;
    CHECK(report_benchmark(benchmark).matches());
    benchmark.refinements[0].order = 2.0;
    const StudyResult level = report_benchmark(benchmark);
    REQUIRE(level.checks.size() == 1);
    CHECK(level.checks[0].what == "order of the error; mesh");
    CHECK(level.checks[0].error == Approx(2.0));
    CHECK_FALSE(level.matches());
}

TEST_CASE("missing values of a run are reported", "[verification]") {
    const auto run = [](const BenchmarkValue& value) { run_benchmark(make_benchmark(value), {}); };
    CHECK_THROWS_WITH(run({"end", "displacement", 0.3, false, {0.0}}),
                      "bar: no step ends at t = 0.3, where a value is known");
    CHECK_THROWS_WITH(run({"tip", "displacement", 0.5, false, {0.0}}),
                      "bar: no displacement of a history tip");
    CHECK_THROWS_WITH(run({"end", "length", 0.5, false, {0.0}}), "bar: no length of a history end");
    CHECK_THROWS_WITH(run({"ledger", "heat", 0.5, false, {0.0}}), "the ledger has no heat");
    CHECK_THROWS_WITH(run_benchmark(make_benchmark(half_way),
                                    {"load[0].force=[0, 1e3, 0]", "analysis.newton.max_iterations=1"}),
                      Catch::StartsWith("bar: the step from load factor 0 failed"));
}

TEST_CASE("every built-in benchmark can be missed", "[verification]") {
    // That each holds its values to a tolerance is asked when it is read.
    CHECK(benchmarks().size() >= 30);
    for (const Benchmark& benchmark : benchmarks()) {
        INFO(benchmark.name);
        CHECK_FALSE(benchmark.sentence.empty());
        CHECK_FALSE(benchmark.values.empty());
        CHECK_FALSE(benchmark.kind.empty());
        CHECK_FALSE(benchmark.source.empty());
    }
}
