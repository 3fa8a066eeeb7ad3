#include "batch/plan/latin_hypercube.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <unsupported/Eigen/SpecialFunctions>

namespace gxrod {
namespace {

// The library's distributions differ between its makers; the engine and seed_seq do not.
class Generator {
  public:
    Generator(std::string_view key, std::uint64_t seed) {
        std::vector<std::uint32_t> words{static_cast<std::uint32_t>(seed),
                                         static_cast<std::uint32_t>(seed >> 32)};
        for (const char letter : key) words.push_back(static_cast<unsigned char>(letter));
        std::seed_seq sequence(words.begin(), words.end());
        engine_.seed(sequence);
    }

    // In (0, 1).
    double uniform() {
        constexpr double spacing = 0x1p-52;
        return (static_cast<double>(engine_() >> 12) + 0.5) * spacing;
    }

    // 0 … count − 1.
    std::size_t below(std::size_t count) {
        return std::min(static_cast<std::size_t>(uniform() * static_cast<double>(count)), count - 1);
    }

  private:
    std::mt19937_64 engine_;
};

double normal_probability(double value) { return 0.5 * std::erfc(-value / std::numbers::sqrt2); }

// A normal distribution, cut off, or that of the logarithms of a lognormal one.
struct CutNormal {
    double mean;
    double deviation;
    // In deviations from the mean.
    double lowest;
    double highest;
};

CutNormal normal_behind(const Spread& spread) {
    const bool is_log = spread.kind == Spread::Kind::lognormal;
    const double ratio = spread.deviation / spread.mean;
    const double variance = std::log1p(ratio * ratio);
    const double mean = is_log ? std::log(spread.mean) - 0.5 * variance : spread.mean;
    const double deviation = is_log ? std::sqrt(variance) : spread.deviation;
    const auto reduce = [&](double limit) {
        if (is_log) limit = limit > 0.0 ? std::log(limit) : -std::numeric_limits<double>::infinity();
        return (limit - mean) / deviation;
    };
    return {mean, deviation, reduce(spread.from), reduce(spread.to)};
}

}  // namespace

std::vector<double> draw_probabilities(std::string_view key, std::uint64_t seed, long count) {
    Generator generator(key, seed);
    const auto size = static_cast<std::size_t>(count);
    std::vector<double> probabilities(size);
    for (std::size_t i = 0; i < size; ++i)
        probabilities[i] = (static_cast<double>(i) + generator.uniform()) / static_cast<double>(size);
    for (std::size_t i = size; i > 1; --i) std::swap(probabilities[i - 1], probabilities[generator.below(i)]);
    return probabilities;
}

double probability_within(const Spread& spread) {
    if (spread.kind == Spread::Kind::uniform) return 1.0;
    const CutNormal normal = normal_behind(spread);
    // Small probabilities are exact in the lower tail only.
    return normal.lowest > 0.0 ? normal_probability(-normal.lowest) - normal_probability(-normal.highest)
                               : normal_probability(normal.highest) - normal_probability(normal.lowest);
}

double quantile(const Spread& spread, double probability) {
    if (spread.kind == Spread::Kind::uniform) return spread.from + probability * (spread.to - spread.from);
    const CutNormal normal = normal_behind(spread);
    const double within = probability_within(spread);
    const double reduced =
        normal.lowest > 0.0
            ? -Eigen::numext::ndtri(normal_probability(-normal.highest) + (1.0 - probability) * within)
            : Eigen::numext::ndtri(normal_probability(normal.lowest) + probability * within);
    const double number = normal.mean + normal.deviation * reduced;
    return std::clamp(
        spread.kind == Spread::Kind::lognormal ? std::exp(number) : number, spread.from, spread.to);
}

}  // namespace gxrod
