#include "numerics/rainflow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "numerics/sn_curve.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// ASTM E1049-85, figure 6.
const std::vector<double> astm_series{-2, 1, -3, 5, -1, 3, -4, 4, -2};

std::vector<RangeCycle> count(const std::vector<double>& series) {
    RainflowCounter counter;
    for (const double value : series) counter.add(value);
    return counter.cycles();
}

// The number of cycles of each range.
std::map<double, double> sum_counts(const std::vector<RangeCycle>& cycles) {
    std::map<double, double> counts;
    for (const RangeCycle& cycle : cycles) counts[cycle.range] += cycle.count;
    return counts;
}

}  // namespace

TEST_CASE("Rainflow counting finds the cycles of the standard's example", "[numerics]") {
    CHECK(sum_counts(count(astm_series)) ==
          std::map<double, double>{{3, 0.5}, {4, 1.5}, {6, 0.5}, {8, 1.0}, {9, 0.5}});
}

TEST_CASE("Points between turns and repeated ones do not count", "[numerics]") {
    std::vector<double> finer;
    for (std::size_t i = 0; i + 1 < astm_series.size(); ++i) {
        for (int k = 0; k < 10; ++k) {
            const double value = astm_series[i] + (astm_series[i + 1] - astm_series[i]) * k / 10.0;
            finer.insert(finer.end(), {value, value});
        }
    }
    finer.push_back(astm_series.back());
    CHECK(sum_counts(count(finer)) == sum_counts(count(astm_series)));
    CHECK(count({}).empty());
    CHECK(count({3.0, 3.0}).empty());
    CHECK(sum_counts(count({0.0, 0.0, 1.0})) == std::map<double, double>{{1.0, 0.5}});
}

TEST_CASE("Cycles can be asked for at any time, and counting goes on", "[numerics]") {
    RainflowCounter counter;
    for (const double value : astm_series) {
        counter.add(value);
        counter.cycles();
    }
    CHECK(sum_counts(counter.cycles()) == sum_counts(count(astm_series)));
    CHECK(counter.is_finite());
    counter.add(std::numeric_limits<double>::quiet_NaN());
    CHECK(!counter.is_finite());
}

TEST_CASE("Half cycles of any series reach from its least to its largest value", "[numerics]") {
    std::mt19937 random(7);
    for (int series = 0; series < 20; ++series) {
        std::vector<double> values(300);
        for (double& value : values) value = std::normal_distribution<>()(random);
        const auto [least, largest] = std::minmax_element(values.begin(), values.end());
        const std::map<double, double> counts = sum_counts(count(values));
        CHECK(counts.rbegin()->first == *largest - *least);
        // Each turn begins half a cycle.
        double halves = 0.0, turns = 1.0;
        for (const auto& [range, number] : counts) halves += 2.0 * number;
        for (std::size_t i = 2; i < values.size(); ++i)
            turns += (values[i] > values[i - 1]) != (values[i - 1] > values[i - 2]) ? 1.0 : 0.0;
        CHECK(halves == turns);
    }
}

TEST_CASE("A detail category endures what EN 1993-1-9 says", "[numerics]") {
    const SNCurve curve = make_eurocode_curve(71e6);
    const double constant = 71e6 * std::cbrt(0.4), limit = constant * std::pow(0.05, 0.2);
    CHECK(curve.endured_cycles(71e6) == Approx(2e6).epsilon(1e-13));
    CHECK(curve.endured_cycles(142e6) == Approx(2.5e5).epsilon(1e-13));
    CHECK(curve.endured_cycles(constant) == Approx(5e6).epsilon(1e-13));
    CHECK(curve.endured_cycles(limit * 1.0001) == Approx(1e8).epsilon(1e-3));
    CHECK(std::isinf(curve.endured_cycles(limit)));
    CHECK(find_fault(curve).empty());
    CHECK(find_fault({{{3, 2e6, 50}, {5, 5e6, 40}, {5, 5e6, 60}}}) ==
          "expected lines for smaller and smaller ranges, down to the limit");
    CHECK(find_fault({{{3, 2e6, 50}, {5, 5e6, 40}}, 41.0}) ==
          "expected lines for smaller and smaller ranges, down to the limit");
    CHECK(find_fault({{{3, 2e6, 50}, {5, 0.0, 40}}}) ==
          "expected lines (slope, cycles, at) of positive numbers");
    // The first one may have any point of its line.
    CHECK(find_fault({{{3, 1e12, 1}, {5, 5e6, 40}}, 20.0}).empty());
    CHECK(find_fault(SNCurve{}) == "expected lines (slope, cycles, at) of positive numbers");
}

TEST_CASE("Damage is Miner's sum, with means by Goodman", "[numerics]") {
    std::vector<double> series;
    for (int i = 0; i < 50; ++i) series.insert(series.end(), {0.0, 100.0});
    series.push_back(0.0);
    const std::vector<RangeCycle> cycles = count(series);
    const SNCurve curve{{{4.0, 1e6, 100.0}}};
    CHECK(compute_damage(cycles, curve, 0.0) == Approx(50e-6).epsilon(1e-13));
    CHECK(compute_damage(cycles, curve, 100.0) == Approx(16.0 * 50e-6).epsilon(1e-13));
    CHECK(std::isinf(compute_damage(cycles, curve, 50.0)));
    CHECK(compute_damage(cycles, {{{4.0, 1e6, 100.0}}, 0.0, 2.0}, 0.0) ==
          Approx(16.0 * 50e-6).epsilon(1e-13));
    CHECK(compute_damage(cycles, {{{4.0, 1e6, 100.0}}, 100.0}, 0.0) == 0.0);
    CHECK(compute_equivalent_range(cycles, 4.0, 50.0) == Approx(100.0).epsilon(1e-13));
    CHECK(compute_equivalent_range(cycles, 4.0, 800.0) == Approx(50.0).epsilon(1e-13));
}

}  // namespace gxrod::test
