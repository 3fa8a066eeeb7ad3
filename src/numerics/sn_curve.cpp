#include "numerics/sn_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gxrod {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

double SNCurve::endured_cycles(double range) const {
    const double wanted = factor * range;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const double end = i + 1 < lines.size() ? lines[i + 1].at : limit;
        if (wanted > end) return lines[i].cycles * std::pow(lines[i].at / wanted, lines[i].slope);
    }
    return infinity;
}

SNCurve make_eurocode_curve(double category) {
    const double constant = category * std::cbrt(2.0 / 5.0);
    return {{{3.0, 2e6, category}, {5.0, 5e6, constant}}, constant * std::pow(5.0 / 100.0, 0.2)};
}

std::string find_fault(const SNCurve& curve) {
    double above = infinity;
    for (std::size_t i = 0; i < curve.lines.size(); ++i) {
        const auto& [slope, cycles, at] = curve.lines[i];
        if (!(slope > 0.0 && cycles > 0.0 && at > 0.0)) above = -infinity;
        const double end = i + 1 < curve.lines.size() ? curve.lines[i + 1].at : curve.limit;
        if (above > -infinity && end > above)
            return "expected lines for smaller and smaller ranges, down to the limit";
        above = std::min(above, end);
    }
    const bool has_lines = !curve.lines.empty() && above > -infinity;
    return has_lines ? "" : "expected lines (slope, cycles, at) of positive numbers";
}

double compute_damage(std::span<const RangeCycle> cycles, const SNCurve& curve, double ultimate) {
    double damage = 0.0;
    for (const RangeCycle& cycle : cycles) {
        const double tension = ultimate > 0.0 ? std::max(cycle.mean, 0.0) / ultimate : 0.0;
        if (tension >= 1.0) return infinity;
        damage += cycle.count / curve.endured_cycles(cycle.range / (1.0 - tension));
    }
    return damage;
}

double compute_equivalent_range(std::span<const RangeCycle> cycles, double slope, double number) {
    double sum = 0.0;
    for (const RangeCycle& cycle : cycles) sum += cycle.count * std::pow(cycle.range, slope);
    return std::pow(sum / number, 1.0 / slope);
}

}  // namespace gxrod
