#include "mesh/grading.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {
namespace {

// log(1 + x)/x and (eˣ − 1)/x, 1 at 0.
double log_ratio(double x) { return x == 0.0 ? 1.0 : std::log1p(x) / x; }
double exp_ratio(double x) { return x == 0.0 ? 1.0 : std::expm1(x) / x; }

// ∫ dx/h over a length on which h goes from `size` by `slope`.
double integrate(double size, double slope, double length) {
    return length / size * log_ratio(slope * length / size);
}

}  // namespace

Grading::Grading(std::vector<std::pair<double, double>> sizes) : sizes_(std::move(sizes)), sums_{0.0} {
    for (std::size_t i = 1; i < sizes_.size(); ++i) {
        const auto& [from, size] = sizes_[i - 1];
        const auto& [to, next] = sizes_[i];
        const double length = to - from;
        sums_.push_back(sums_.back() +
                        (length > 0.0 ? integrate(size, (next - size) / length, length) : 0.0));
    }
}

double Grading::measure(double fraction) const {
    if (is_even()) return fraction;
    std::size_t i = 1;
    while (i + 1 < sizes_.size() && fraction > sizes_[i].first) ++i;
    const auto& [from, size] = sizes_[i - 1];
    const auto& [to, next] = sizes_[i];
    if (fraction >= to) return sums_[i] / sums_.back();
    return (sums_[i - 1] + integrate(size, (next - size) / (to - from), fraction - from)) / sums_.back();
}

double Grading::fraction_at(double measure) const {
    if (is_even()) return measure;
    const double sum = measure * sums_.back();
    std::size_t i = 1;
    while (i + 1 < sizes_.size() && sum > sums_[i]) ++i;
    const auto& [from, size] = sizes_[i - 1];
    const auto& [to, next] = sizes_[i];
    if (!(to > from)) return to;
    const double slope = (next - size) / (to - from);
    const double steps = std::max(sum - sums_[i - 1], 0.0);
    return std::min(from + size * steps * exp_ratio(slope * steps), to);
}

}  // namespace gxrod
