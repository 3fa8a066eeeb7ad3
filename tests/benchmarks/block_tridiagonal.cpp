#include "benchmarks/block_tridiagonal.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <random>

namespace gxrod::speed {

BlockTridiagonal::BlockTridiagonal(int blocks)
    : diagonal_(blocks),
      above_(blocks),
      below_(blocks),
      eliminated_(blocks),
      load_(blocks, Vector::Ones()),
      solution_(blocks),
      factors_(blocks) {
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (int i = 0; i < blocks; ++i) {
        for (Block* block : {&diagonal_[i], &above_[i], &below_[i]}) {
            for (double& entry : block->reshaped()) entry = number(generator);
        }
        diagonal_[i].diagonal().array() += 12.0;
    }
}

double BlockTridiagonal::factorize_and_solve() {
    solution_ = load_;
    const std::size_t count = diagonal_.size();
    Block pivot = diagonal_[0];
    for (std::size_t i = 0; i < count; ++i) {
        factors_[i].compute(pivot);
        solution_[i] = factors_[i].solve(solution_[i]);
        if (i + 1 == count) break;
        eliminated_[i] = factors_[i].solve(above_[i]);
        pivot = diagonal_[i + 1] - below_[i] * eliminated_[i];
        solution_[i + 1] -= below_[i] * solution_[i];
    }
    for (std::size_t i = count - 1; i-- > 0;) solution_[i] -= eliminated_[i] * solution_[i + 1];
    return solution_[0][0];
}

double BlockTridiagonal::measure(int blocks) {
    constexpr int rounds = 5;
    constexpr int least_blocks = 200'000;
    constexpr double microseconds = 1e6;
    BlockTridiagonal system(blocks);
    double least = std::numeric_limits<double>::infinity();
    for (int round = 0; round < rounds; ++round) {
        const int repeats = std::max(1, least_blocks / blocks);
        const auto begin = std::chrono::steady_clock::now();
        for (int i = 0; i < repeats; ++i) benchmark::DoNotOptimize(system.factorize_and_solve());
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
        least = std::min(least, time.count() / repeats / blocks);
    }
    return microseconds * least;
}

}  // namespace gxrod::speed
