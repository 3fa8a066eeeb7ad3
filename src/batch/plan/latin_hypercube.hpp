#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "batch/plan/plan.hpp"

// Latin hypercube samples (McKay, Beckman, Conover 1979): of each key one in each of `count` equally likely
// parts, the parts of different keys paired at random.
namespace gxrod {

// Probabilities in (0, 1), one for each sample; the same on every machine for the same key, seed and count.
std::vector<double> draw_probabilities(std::string_view key, std::uint64_t seed, long count);

// How likely the limits `from` and `to` are kept by the distribution without them; 1 for a uniform one.
double probability_within(const Spread& spread);

// The value below which a part `probability` of the distribution lies, 0 < probability < 1.
double quantile(const Spread& spread, double probability);

}  // namespace gxrod
