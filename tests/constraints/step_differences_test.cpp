#include "constraints/step_differences.hpp"

#include <cmath>
#include <functional>

#include "tools/catch.hpp"

using namespace gxrod;

namespace {

struct Derivatives {
    double first = 0.0;
    double second = 0.0;
};

Derivatives differentiate(const std::function<double(double)>& f, double time, const TimeSpan& span) {
    const StepDifferences differences = compute_step_differences(time, span);
    Derivatives derivatives;
    for (int i = 0; i < difference_points; ++i) {
        derivatives.first += differences.first[i] * f(differences.times[i]);
        derivatives.second += differences.second[i] * f(differences.times[i]);
    }
    return derivatives;
}

}  // namespace

TEST_CASE("derivatives of polynomials of degree 6 are exact anywhere in the step", "[constraints]") {
    const TimeSpan span{0.4, 0.3};
    for (int power = 0; power <= 7; ++power) {
        double worst = 0.0;
        for (const double t : {0.4, 0.42, 0.475, 0.55, 0.7}) {
            const auto [first, second] = differentiate([&](double x) { return std::pow(x, power); }, t, span);
            const double exact_first = power > 0 ? power * std::pow(t, power - 1) : 0.0;
            const double exact_second = power > 1 ? power * (power - 1) * std::pow(t, power - 2) : 0.0;
            worst = std::max({worst, std::abs(first - exact_first), 1e-2 * std::abs(second - exact_second)});
        }
        INFO("power " << power << ": " << worst);
        CHECK((power <= 6 ? worst < 1e-12 : worst > 1e-7));
    }
}

TEST_CASE("derivatives of a smooth function err by the power 6 of the step, second ones by 5",
          "[constraints]") {
    const auto compute_errors = [](double at, double length) {
        const auto [first, second] =
            differentiate([](double t) { return std::sin(t); }, 0.4 + at * length, {0.4, length});
        const double t = 0.4 + at * length;
        return Derivatives{std::abs(first - std::cos(t)), std::abs(second + std::sin(t))};
    };
    for (const double at : {0.0, 0.25, 1.0}) {
        const Derivatives coarse = compute_errors(at, 0.8);
        const Derivatives fine = compute_errors(at, 0.4);
        INFO(at << ": " << coarse.first << " " << fine.first << ", " << coarse.second << " " << fine.second);
        CHECK(std::log2(coarse.first / fine.first) == Approx(6.0).margin(0.5));
        CHECK(std::log2(coarse.second / fine.second) == Approx(5.0).margin(0.5));
        CHECK(fine.first < 1e-8);
        CHECK(fine.second < 1e-6);
    }
}

TEST_CASE("a corner at an end of the step does not count", "[constraints]") {
    const auto corner = [](double t) { return std::abs(t - 0.4); };
    for (const double t : {0.4, 0.5, 0.7}) {
        CHECK(differentiate(corner, t, {0.4, 0.3}).first == Approx(1.0).epsilon(1e-13));
        CHECK(std::abs(differentiate(corner, t, {0.4, 0.3}).second) < 1e-11);
    }
    for (const double t : {0.1, 0.3, 0.4}) {
        CHECK(differentiate(corner, t, {0.1, 0.3}).first == Approx(-1.0).epsilon(1e-13));
        CHECK(std::abs(differentiate(corner, t, {0.1, 0.3}).second) < 1e-11);
    }
}
