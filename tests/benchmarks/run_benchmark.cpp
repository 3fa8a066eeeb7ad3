// Whole runs without a file: microseconds per element and Newton iteration, and how many times that is what
// factorizing and solving 6 × 6 blocks takes of a node (block_tridiagonal.hpp).
#include <benchmark/benchmark.h>

#include <algorithm>

#include "analyses/run.hpp"
#include "benchmarks/block_tridiagonal.hpp"
#include "benchmarks/pendulum.hpp"

namespace gxrod::speed {
namespace {

constexpr double microseconds = 1e6;

// More elements make fewer steps.
void run_pendulum(benchmark::State& state) {
    const int order = static_cast<int>(state.range(0));
    const int elements = static_cast<int>(state.range(1));
    constexpr int most_steps = 1000;
    constexpr int most_element_steps = 1'000'000;
    constexpr int least_steps = 3;
    const long steps = std::clamp(most_element_steps / elements, least_steps, most_steps);
    const Problem problem = make_pendulum(elements, order, steps);
    double iterations = 0.0;
    PhaseSeconds phases{};
    double seconds = 0.0;
    for (auto _ : state) {
        const RunSummary summary = run_analysis({.model = problem.model,
                                                 .analysis = problem.analysis,
                                                 .output = problem.output,
                                                 .deck = problem.record,
                                                 .results = {}});
        if (summary.status != RunStatus::complete) state.SkipWithError("did not complete");
        iterations += static_cast<double>(summary.totals.newton_iterations);
        seconds += summary.wall_seconds - summary.phases.output;
        phases.assembly += summary.phases.assembly;
        phases.solve += summary.phases.solve;
        phases.update += summary.phases.update;
    }
    const double nodes = static_cast<double>(elements) * order;
    const double unit = microseconds / (elements * iterations);
    state.counters["us_per_el_it"] = seconds * unit;
    state.counters["assembly"] = phases.assembly * unit;
    state.counters["solve"] = phases.solve * unit;
    state.counters["update"] = phases.update * unit;
    state.counters["it_per_step"] =
        iterations / static_cast<double>(steps) / static_cast<double>(state.iterations());
    state.counters["us_per_node_it"] = seconds * unit * elements / nodes;
    state.counters["times_blocks"] =
        seconds * unit * elements / nodes / BlockTridiagonal::measure(std::min(elements * order, 100'000));
}
BENCHMARK(run_pendulum)
    ->ArgNames({"order", "elements"})
    ->ArgsProduct({{1}, {10, 100, 1000, 10'000, 100'000}})
    ->ArgsProduct({{2, 3, 4}, {10, 100, 1000}})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

}  // namespace
}  // namespace gxrod::speed
