// Forces and tangents of rod elements, assembled, by order.
#include <benchmark/benchmark.h>

#include "assembly/system.hpp"
#include "benchmarks/pendulum.hpp"

namespace gxrod::speed {
namespace {

constexpr int elements = 1000;

void per_element(benchmark::State& state) {
    state.counters["per_element"] = benchmark::Counter(
        elements, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void assemble_forces(benchmark::State& state) {
    const Problem problem = make_pendulum(elements, static_cast<int>(state.range(0)), 1);
    const System system(problem.model);
    const State start = system.initial_state();
    Residual residual;
    for (auto _ : state) {
        system.compute_residual(start, 0.0, residual);
        benchmark::DoNotOptimize(residual.nodal.data());
    }
    per_element(state);
}
BENCHMARK(assemble_forces)->DenseRange(1, 4);

void assemble_tangent(benchmark::State& state) {
    const Problem problem = make_pendulum(elements, static_cast<int>(state.range(0)), 1);
    const System system(problem.model);
    const State start = system.initial_state();
    const std::vector<NodeLinearization> linearizations(
        start.trial.size(), {1.0, 2e3, 4e6, 2e3 * Mat3::Identity(), 4e6 * Mat3::Identity()});
    std::vector<double> values;
    for (auto _ : state) {
        system.compute_tangent(start, 0.0, linearizations, values);
        benchmark::DoNotOptimize(values.data());
    }
    per_element(state);
}
BENCHMARK(assemble_tangent)->DenseRange(1, 4);

}  // namespace
}  // namespace gxrod::speed
