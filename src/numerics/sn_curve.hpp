#pragma once

#include <span>
#include <string>
#include <vector>

#include "numerics/rainflow.hpp"

// How many cycles a detail endures, and what part of its life a series of cycles takes.
namespace gxrod {

// Straight lines in logarithms, the first for the largest ranges, each N = cycles (at/range)^slope down to
// the `at` of the next one, the last one down to `limit`: cycles of that range and smaller ones do no damage.
struct SNCurve {
    struct Line {
        double slope, cycles, at;
    };

    std::vector<Line> lines;
    double limit = 0.0;
    double factor = 1.0;  // on ranges, as a partial factor

    // Computes the cycles of a range that are endured; infinite at and below the limit.
    double endured_cycles(double range) const;
};

// Makes the curve of a detail category for normal stresses (EN 1993-1-9, 7.1): the range at 2·10⁶ cycles,
// slope 3 to 5·10⁶ cycles, 5 to 10⁸, then no damage.
SNCurve make_eurocode_curve(double category);

// Says what is wrong with a curve, and what was expected; "" if nothing is.
std::string find_fault(const SNCurve& curve);

// Computes the damage by Miner's rule, Σ count/N. With an ultimate stress above 0, ranges count as those
// without a mean that do the same damage (Goodman): range/(1 − mean/ultimate) where the mean is tension;
// infinite if a mean reaches it.
double compute_damage(std::span<const RangeCycle> cycles, const SNCurve& curve, double ultimate);

// Computes the range that does the same damage if it is repeated `number` times, (Σ count range^slope /
// number)^(1/slope).
double compute_equivalent_range(std::span<const RangeCycle> cycles, double slope, double number);

}  // namespace gxrod
