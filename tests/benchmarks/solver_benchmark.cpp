// Each linear solver on the tangents of a falling rod and a net: factorization and solution.
#include <benchmark/benchmark.h>

#include "assembly/system.hpp"
#include "benchmarks/block_tridiagonal.hpp"
#include "benchmarks/problems.hpp"
#include "linear/linear_solver.hpp"
#include "machine/phase_timer.hpp"

namespace gxrod::speed {
namespace {

void per_node(benchmark::State& state, double nodes) {
    state.counters["per_node"] = benchmark::Counter(
        nodes, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void solve_eigen_blocks(benchmark::State& state) {
    BlockTridiagonal system(static_cast<int>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(system.factorize_and_solve());
    per_node(state, static_cast<double>(state.range(0)));
}
BENCHMARK(solve_eigen_blocks)->RangeMultiplier(10)->Range(10, 1'000'000);

void solve(benchmark::State& state, LinearSolverKind kind, const Model& model) {
    const System system(model);
    const State start = system.initial_state();
    // As in a step of Newmark's method, Δt = 1 ms.
    constexpr double per_step = 1e-3;
    constexpr double acceleration = 4.0 / (per_step * per_step);
    std::vector<NodeLinearization> linearizations(start.trial.size(),
                                                  {1.0,
                                                   2.0 / per_step,
                                                   acceleration,
                                                   2.0 / per_step * Mat3::Identity(),
                                                   acceleration * Mat3::Identity()});
    std::vector<double> values;
    system.compute_tangent(start, 0.0, linearizations, values);
    double ordering = 0.0;
    double factorizing = 0.0;
    std::unique_ptr<LinearSolver> solver;
    {
        const PhaseTimer timer(ordering);
        solver = make_linear_solver(kind, system.pattern());
    }
    const Eigen::VectorXd load = Eigen::VectorXd::Ones(system.pattern().size());
    Eigen::VectorXd solution;
    for (auto _ : state) {
        {
            const PhaseTimer timer(factorizing);
            if (!solver->factorize(values).regular) state.SkipWithError("singular");
        }
        solution = load;
        solver->solve(solution);
    }
    state.counters["ordering_s"] = ordering;
    state.counters["factorizing_s"] = benchmark::Counter(factorizing, benchmark::Counter::kAvgIterations);
}

void solve_rod(benchmark::State& state, LinearSolverKind kind, int order) {
    const int nodes = static_cast<int>(state.range(0));
    solve(state, kind, make_pendulum(std::max(1, nodes / order), order, 1).model);
    per_node(state, nodes);
}
BENCHMARK_CAPTURE(solve_rod, chains_order_1, LinearSolverKind::chains, 1)
    ->RangeMultiplier(10)
    ->Range(10, 1'000'000);
BENCHMARK_CAPTURE(solve_rod, chains_order_2, LinearSolverKind::chains, 2)
    ->RangeMultiplier(10)
    ->Range(10, 100'000);
BENCHMARK_CAPTURE(solve_rod, chains_order_3, LinearSolverKind::chains, 3)
    ->RangeMultiplier(10)
    ->Range(10, 100'000);
BENCHMARK_CAPTURE(solve_rod, chains_order_4, LinearSolverKind::chains, 4)
    ->RangeMultiplier(10)
    ->Range(10, 100'000);
BENCHMARK_CAPTURE(solve_rod, klu_order_1, LinearSolverKind::klu, 1)->RangeMultiplier(10)->Range(10, 100'000);
BENCHMARK_CAPTURE(solve_rod, umfpack_order_1, LinearSolverKind::umfpack, 1)
    ->RangeMultiplier(10)
    ->Range(10, 100'000);

// Ten elements between two crossings. KLU and UMFPACK take the whole matrix, that is how long they
// take by themselves.
void solve_net(benchmark::State& state, LinearSolverKind kind) {
    constexpr int elements = 10;
    const Problem problem = make_net(static_cast<int>(state.range(0)), elements, 1);
    solve(state, kind, problem.model);
    per_node(state, static_cast<double>(problem.model.nodes.size()));
}
BENCHMARK_CAPTURE(solve_net, chains, LinearSolverKind::chains)->ArgName("rods")->Arg(20)->Arg(100);
BENCHMARK_CAPTURE(solve_net, klu, LinearSolverKind::klu)->ArgName("rods")->Arg(20)->Arg(100);
BENCHMARK_CAPTURE(solve_net, umfpack, LinearSolverKind::umfpack)->ArgName("rods")->Arg(20)->Arg(100);

}  // namespace
}  // namespace gxrod::speed
