#include "model/sections/element_means.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "numerics/gauss_legendre.hpp"
#include "tools/catch.hpp"
#include "tools/rod_models.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// f(t, s) = 2 s up to a front that moves with t, and 1 − s behind it.
double jump(double time, double s) { return s < 0.37 * time ? 2.0 * s : 1.0 - s; }

LineFunction switching() {
    auto switches = std::make_shared<Switches>();
    switches->push_back({.argument = [](double time, double s) { return s - 0.37 * time; }});
    return LineFunction(jump, switches);
}

// ∫ jump (s − from)^power ds.
double integrate(double time, double from, double to, int power) {
    double sum = 0.0;
    const double front = std::clamp(0.37 * time, from, to);
    for (const auto& [a, b] : {std::pair(from, front), std::pair(front, to)}) {
        for (const QuadraturePoint& point : list_gauss_rule(5)) {
            const double s = 0.5 * (a + b) + 0.5 * (b - a) * point.xi;

            sum += 0.5 * (b - a) * point.weight * jump(time, s) * std::pow(s - from, power);
        }
    }
    return sum;
}

}  // namespace

TEST_CASE("Values at force points have the integrals of a function that jumps in the element", "[model]") {
    for (int order = 1; order <= 4; ++order) {
        const Model model = make_rod_model(along_x, 1.0, {5, order}, make_section({1, 1, 1, 1, 1, 1}));
        const Rod& rod = model.rods[0];
        const LineFunction means = take_element_means(switching(), rod);
        const std::vector<double> points = list_force_points(rod);
        const std::vector<QuadraturePoint> rule = list_gauss_rule(order);
        for (const double time : {0.3, 1.0, 2.2}) {
            for (int e = 0; e < 5; ++e) {
                const double from = 0.2 * e;
                for (int power = 0; power < order; ++power) {
                    double sum = 0.0;
                    for (int p = 0; p < order; ++p) {
                        const double s = points[static_cast<std::size_t>(e * order + p)];
                        sum += 0.1 * rule[static_cast<std::size_t>(p)].weight * means(time, s) *
                               std::pow(s - from, power);
                    }
                    CHECK(sum == Approx(integrate(time, from, from + 0.2, power)).margin(1e-13));
                }
            }
        }
    }
}

TEST_CASE("Where a function does not switch within an element its values are its own", "[model]") {
    const Model model = make_rod_model(along_x, 1.0, {5, 2}, make_section({1, 1, 1, 1, 1, 1}));
    const LineFunction means = take_element_means(switching(), model.rods[0]);
    for (const double s : {0.05, 0.15, 0.45, 0.99}) CHECK(means(1.0, s) == jump(1.0, s));
    CHECK(means(1.0, 0.21) != jump(1.0, 0.21));
    // With the front at an end of an element it does so nowhere.
    CHECK(means(0.4 / 0.37, 0.35) == jump(0.4 / 0.37, 0.35));
    const LineFunction smooth([](double, double s) { return s; });
    CHECK(take_element_means(smooth, model.rods[0])(0.0, 0.3) == 0.3);
}
