#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "numerics/gauss_legendre.hpp"

namespace gxrod {

// The integral of a function from the first of some edges to any place, 0 before it and constant beyond the
// last: by Gauss' rule of ten points in each piece between edges.
class RunningIntegral {
  public:
    RunningIntegral(std::function<double(double)> function, std::vector<double> edges)
        : function_(std::move(function)), edges_(std::move(edges)), sums_{0.0} {
        for (std::size_t i = 1; i < edges_.size(); ++i) {
            sums_.push_back(sums_.back() + integrate(edges_[i - 1], edges_[i]));
        }
    }

    double up_to(double x) const {
        if (x <= edges_.front()) return 0.0;
        if (x >= edges_.back()) return sums_.back();
        const auto next = std::upper_bound(edges_.begin(), edges_.end(), x);
        const auto i = static_cast<std::size_t>(next - edges_.begin()) - 1;
        return sums_[i] + integrate(edges_[i], x);
    }
    double whole() const { return sums_.back(); }

  private:
    double integrate(double from, double to) const {
        static const auto rule = compute_gauss_rule<10>();
        double sum = 0.0;
        for (const QuadraturePoint& point : rule) {
            sum += point.weight * function_(0.5 * (from + to) + 0.5 * (to - from) * point.xi);
        }
        return 0.5 * (to - from) * sum;
    }

    std::function<double(double)> function_;
    std::vector<double> edges_, sums_;
};

// Finds the place where a function that does not fall has a value, between two places: by Newton's method,
// and by bisection if it leaves them.
template <class Function, class Slope>
double find_value(const Function& function,
                  const Slope& slope,
                  double value,
                  std::pair<double, double> within) {
    auto [low, high] = within;
    double x = 0.5 * (low + high);
    for (int i = 0; i < 200; ++i) {
        const double excess = function(x) - value;
        (excess > 0.0 ? high : low) = x;
        double next = x - excess / slope(x);
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        if (std::abs(next - x) <= 4e-16 * std::abs(x)) return next;
        x = next;
    }
    return x;
}

}  // namespace gxrod
