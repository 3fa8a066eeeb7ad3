#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "batch/plan/plan.hpp"

// Latin hypercube samples (McKay, Beckman, Conover 1979): for each key one value in each of `count` equally
// likely intervals; intervals of different keys are paired at random.
namespace gxrod {

// Draws probabilities in (0, 1), one for each sample; the same on every machine for the same key, seed and
// count.
std::vector<double> draw_probabilities(std::string_view key, std::uint64_t seed, long count);

// Computes the probability of values within the limits `from` and `to` under the distribution without them; 1
// for a uniform one.
double probability_within(const Spread& spread);

// Computes the value below which a part `probability` of the distribution lies, 0 < probability < 1.
double quantile(const Spread& spread, double probability);

}  // namespace gxrod
