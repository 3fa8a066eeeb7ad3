// Twelve modes of a cantilever of order 1, completeness counted.
#include <benchmark/benchmark.h>

#include "analyses/shapes/modes.hpp"
#include "benchmarks/problems.hpp"

namespace gxrod::speed {
namespace {

void find_cantilever_modes(benchmark::State& state) {
    const Problem problem = make_pendulum(static_cast<int>(state.range(0)), 1, 1);
    const System system(problem.model);
    const State start = system.initial_state();
    for (auto _ : state) {
        const ModesRecord record = find_modes(system, start, 0.0, {.count = 12});
        if (!record.is_complete) state.SkipWithError("modes are missing");
    }
}
BENCHMARK(find_cantilever_modes)->RangeMultiplier(10)->Range(10, 100'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gxrod::speed
