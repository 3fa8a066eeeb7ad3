// Whole runs without a file: microseconds per element and Newton iteration, and how many times that is what
// factorizing and solving 6 × 6 blocks takes of a node (block_tridiagonal.hpp); bytes per node at the peak,
// the model's included.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "benchmarks/block_tridiagonal.hpp"
#include "benchmarks/memory_peak.hpp"
#include "benchmarks/problems.hpp"
#include "run/run.hpp"

namespace gxrod::speed {
namespace {

constexpr double microseconds = 1e6;
constexpr int most_blocks = 100'000;
// Below this the peak is that of the program itself.
constexpr long least_nodes = 10'000;

void count_run(benchmark::State& state, const RunSummary& summary) {
    const RunTotals& totals = summary.totals;
    const double elements = static_cast<double>(summary.elements);
    const double nodes = static_cast<double>(summary.nodes);
    const PhaseSeconds& phases = summary.phases;
    const double seconds = phases.assembly + phases.solve + phases.update;
    const double iterations = static_cast<double>(totals.newton_iterations);
    const double unit = microseconds / (elements * iterations);
    state.counters["us_per_el_it"] = seconds * unit;
    state.counters["assembly"] = phases.assembly * unit;
    state.counters["solve"] = phases.solve * unit;
    state.counters["update"] = phases.update * unit;
    state.counters["setup_us_per_el"] = microseconds * phases.setup / elements;
    state.counters["newton_iterations"] = iterations;
    state.counters["it_per_step"] = iterations / static_cast<double>(totals.steps);
    const double per_node = seconds * microseconds / (nodes * iterations);
    state.counters["us_per_node_it"] = per_node;
    const int blocks = static_cast<int>(std::min<long>(summary.nodes, most_blocks));
    state.counters["times_blocks"] = per_node / BlockTridiagonal::measure(blocks);
}

template <class Make>
void run(benchmark::State& state, Make&& make) {
    const MemoryPeak memory;
    const Problem problem = make();
    for (auto _ : state) {
        const RunSummary summary = run_analysis({problem});
        const double bytes = memory.bytes();
        state.PauseTiming();
        if (summary.status != RunStatus::complete) state.SkipWithError("did not complete");
        count_run(state, summary);
        if (summary.nodes >= least_nodes) {
            state.counters["bytes_per_node"] = bytes / static_cast<double>(summary.nodes);
        }
        state.ResumeTiming();
    }
}

// More elements make fewer steps.
void run_pendulum(benchmark::State& state, ElementKind kind) {
    const int order = static_cast<int>(state.range(0));
    const int elements = static_cast<int>(state.range(1));
    constexpr int most_steps = 1000;
    constexpr int most_node_steps = 300'000;
    constexpr int least_steps = 3;
    const long steps = std::clamp(most_node_steps / (order * elements), least_steps, most_steps);
    run(state, [&] { return make_pendulum(elements, order, steps, kind); });
}
BENCHMARK_CAPTURE(run_pendulum, objective, ElementKind::objective)
    ->ArgNames({"order", "elements"})
    ->ArgsProduct({{1}, {10, 100, 1000, 10'000, 100'000, 1'000'000}})
    ->ArgsProduct({{2, 3, 4}, {10, 100, 1000}})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
BENCHMARK_CAPTURE(run_pendulum, simo, ElementKind::simo)
    ->ArgNames({"order", "elements"})
    ->ArgsProduct({{1, 2, 3, 4}, {10, 1000}})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

void run_roll_up(benchmark::State& state) {
    const auto argument = [&](int index) { return static_cast<int>(state.range(index)); };
    run(state, [&] { return make_roll_up(argument(1), argument(0), argument(2)); });
}
BENCHMARK(run_roll_up)
    ->ArgNames({"order", "elements", "steps"})
    ->ArgsProduct({{1}, {10, 100, 1000}, {20}})
    ->ArgsProduct({{3}, {10, 100}, {20}})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

void run_net(benchmark::State& state) {
    constexpr int elements = 10;
    constexpr long steps = 3;
    run(state, [&] { return make_net(static_cast<int>(state.range(0)), elements, steps); });
}
BENCHMARK(run_net)->ArgName("rods")->Arg(20)->Arg(100)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
}  // namespace gxrod::speed
