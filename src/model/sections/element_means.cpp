#include "model/sections/element_means.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "model/time/breaks.hpp"
#include "numerics/gauss_legendre.hpp"

namespace gxrod {
namespace {

// Places of an element in which switches are looked at.
constexpr int break_samples = 8;
constexpr int most_force_points = 4;
// Breaks nearer than this part of an element to its ends are there.
constexpr double at_end = 1e-12;

// P_0 to P_3.
std::array<double, most_force_points> list_legendre(double xi) {
    return {1.0, xi, 0.5 * (3.0 * xi * xi - 1.0), 0.5 * xi * (5.0 * xi * xi - 3.0)};
}

class ElementMeans {
  public:
    ElementMeans(LineFunction function, const Rod& rod)
        : function_(std::move(function)), order_(static_cast<std::size_t>(rod.order)) {
        for (std::size_t first = 0; first + order_ < rod.arc_length.size(); first += order_ + 1)
            elements_.push_back({rod.arc_length[first], rod.arc_length[first + order_]});
        for (const Switch& one : *function_.switches()) {
            if (one.has_arc_length) switches_.push_back(one);
        }
    }

    double operator()(double time, double s) const {
        if (elements_.empty()) return function_(time, s);
        const Interval& element = find_element(s);
        const double size = element.to - element.from;
        std::vector<double> ends{element.from};
        for (const double at : find_breaks_along(switches_, time, element, break_samples)) {
            if (at > element.from + at_end * size && at < element.to - at_end * size) ends.push_back(at);
        }
        if (ends.size() == 1) return function_(time, s);
        ends.push_back(element.to);
        return project(time, s, element, ends);
    }

  private:
    const Interval& find_element(double s) const {
        const auto next = std::ranges::upper_bound(elements_, s, {}, &Interval::from);
        return next == elements_.begin() ? elements_.front() : *(next - 1);
    }

    double project(double time, double s, const Interval& element, const std::vector<double>& ends) const {
        const double middle = 0.5 * (element.from + element.to), half = 0.5 * (element.to - element.from);
        std::array<double, most_force_points> moments{};
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            const double own_middle = 0.5 * (ends[i] + ends[i + 1]), own_half = 0.5 * (ends[i + 1] - ends[i]);
            for (const QuadraturePoint& point : list_gauss_rule(5)) {
                const double at = own_middle + own_half * point.xi;
                const double part = own_half / half * point.weight * function_(time, at);
                const auto legendre = list_legendre((at - middle) / half);
                for (std::size_t k = 0; k < order_; ++k) moments[k] += part * legendre[k];
            }
        }
        const auto legendre = list_legendre((s - middle) / half);
        double value = 0.0;
        for (std::size_t k = 0; k < order_; ++k)
            value += 0.5 * static_cast<double>(2 * k + 1) * moments[k] * legendre[k];
        return value;
    }

    LineFunction function_;
    std::size_t order_;
    std::vector<Interval> elements_;
    Switches switches_;
};

}  // namespace

LineFunction take_element_means(const LineFunction& function, const Rod& rod) {
    const auto along = [](const Switch& one) { return one.has_arc_length; };
    if (!function.switches() || std::ranges::none_of(*function.switches(), along)) return function;
    // Elements of nets do not follow each other along one arc length.
    if (!std::ranges::is_sorted(rod.arc_length)) return function;
    const auto means = std::make_shared<const ElementMeans>(function, rod);
    return LineFunction(
        [means](double time, double s) { return (*means)(time, s); }, function.switches(), function.form());
}

}  // namespace gxrod
