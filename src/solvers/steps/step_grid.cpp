#include "solvers/steps/step_grid.hpp"

#include <cmath>
#include <limits>

namespace gxrod {

namespace {

struct Fraction {
    double numerator, denominator;
};

// The first continued fraction that is the number but for rounding, or the number itself over 1.
Fraction find_fraction(double number) {
    constexpr double largest = 1e6;
    constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
    Fraction before{1.0, 0.0};
    Fraction now{std::floor(number), 1.0};
    double rest = number - now.numerator;
    while (now.denominator <= largest && now.numerator <= largest) {
        if (std::abs(now.numerator - number * now.denominator) <= rounding * number * now.denominator)
            return now;
        if (rest <= 0.0) break;
        const double inverse = 1.0 / rest;
        const double whole = std::floor(inverse);
        rest = inverse - whole;
        const Fraction next{whole * now.numerator + before.numerator,
                            whole * now.denominator + before.denominator};
        before = now;
        now = next;
    }
    return {number, 1.0};
}

}  // namespace

StepGrid::StepGrid(double step, std::int64_t ticks) : ticks_(ticks) {
    const Fraction fraction = find_fraction(step);
    numerator_ = fraction.numerator;
    denominator_ = fraction.denominator;
    step_ = numerator_ / denominator_;
}

double StepGrid::at(std::int64_t position) const {
    return static_cast<double>(position) * numerator_ / (denominator_ * static_cast<double>(ticks_));
}

StepGrid::Place StepGrid::find(double time) const {
    constexpr double rounding = 1e-12;
    const double position = std::round(time / step_ * static_cast<double>(ticks_));
    const auto nearest = static_cast<std::int64_t>(position);
    return {nearest, std::abs(at(nearest) - time) <= rounding * std::abs(time)};
}

}  // namespace gxrod
