#include "laws/syrope_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "laws/law_path.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

constexpr double for_ever = std::numeric_limits<double>::infinity();

// A polyester rope of 4.4 MN.
PiecewiseLine polyester() {
    const std::vector<double> tensions{0.0,       1.71768e5, 3.30952e5, 4.78788e5, 6.16510e5, 7.45355e5,
                                       8.66556e5, 9.81351e5, 1.09097e6, 1.19666e6, 1.29964e6, 1.40116e6,
                                       1.50245e6, 1.60474e6, 1.70927e6, 1.81728e6, 1.93000e6, 2.04866e6,
                                       2.17450e6, 2.30876e6, 2.45267e6, 2.60747e6, 2.77439e6, 2.95467e6,
                                       3.14954e6, 3.36024e6, 3.58800e6, 3.83406e6, 4.09965e6, 4.38601e6};
    const std::vector<double> strains{0.0,        2.06897e-3, 4.13793e-3, 6.20690e-3, 8.27586e-3, 1.03448e-2,
                                      1.24138e-2, 1.44828e-2, 1.65517e-2, 1.86207e-2, 2.06897e-2, 2.27586e-2,
                                      2.48276e-2, 2.68966e-2, 2.89655e-2, 3.10345e-2, 3.31034e-2, 3.51724e-2,
                                      3.72414e-2, 3.93103e-2, 4.13793e-2, 4.34483e-2, 4.55172e-2, 4.75862e-2,
                                      4.96552e-2, 5.17241e-2, 5.37931e-2, 5.58621e-2, 5.79310e-2, 6.00000e-2};
    std::vector<std::pair<double, double>> rows;
    for (std::size_t i = 0; i < strains.size(); ++i) rows.emplace_back(strains[i], tensions[i]);
    return PiecewiseLine(std::move(rows));
}

SyropeRope some_fibre_rope(WorkingShape shape = WorkingShape::exponential) {
    return {.original = polyester(),
            .shape = shape,
            .k1 = 0.2,
            .k2 = 0.8,
            .stiffness = 2e8,
            .per_tension = 23.12,
            .damping = 2e9,
            .largest = 0.0};
}

double tension_after(LawPath& path, double strain, double elapsed) {
    return path.go(strain_along(0, strain), elapsed).resultants[0];
}

// Pulled from one strain to 0.03 within 40, then with a wave of 0.006 and a period of 10 about it.
double strain_at(double time, double from) {
    if (time < 40.0) return from + (0.03 - from) * time / 40.0;
    return 0.03 + 0.006 * std::sin(2.0 * std::numbers::pi * (time - 40.0) / 10.0);
}

// The largest difference to tensions at times, of the largest tension.
double compare_tensions(LawPath& path,
                        const std::vector<std::pair<double, double>>& reference,
                        double from,
                        int steps_in_unit) {
    double largest = 0.0, most = 0.0;
    auto next = reference.begin();
    for (int i = 1; next != reference.end(); ++i) {
        const double time = static_cast<double>(i) / steps_in_unit;
        const double tension = tension_after(path, strain_at(time, from), 1.0 / steps_in_unit);
        most = std::max(most, tension);
        if (time < next->first - 1e-9) continue;
        largest = std::max(largest, std::abs(tension - next->second));
        ++next;
    }
    return largest / most;
}

}  // namespace

TEST_CASE("A fibre rope that is pulled slowly follows its original curve and falls on its working curve",
          "[laws]") {
    const auto working = [](WorkingShape shape, double x) {
        if (shape == WorkingShape::linear) return x;
        if (shape == WorkingShape::quadratic) return x * (0.8 * x + 0.2);
        return (1.0 - std::exp(0.8 * x)) / (1.0 - std::exp(0.8));
    };
    for (const WorkingShape shape :
         {WorkingShape::linear, WorkingShape::quadratic, WorkingShape::exponential}) {
        const SyropeLaw law(Mat6::Identity(), some_fibre_rope(shape));
        LawPath path(law);
        const PiecewiseLine original = polyester();
        for (const double strain : {0.001, 0.01, 0.025, 0.03})
            CHECK(tension_after(path, strain, for_ever) == Approx(original.at(strain).value).epsilon(1e-14));
        const double top = original.at(0.03).value;
        for (const double strain : {0.029, 0.02, 0.01, 0.0061, 0.015, 0.028}) {
            const double x = (strain - 0.006) / 0.024;
            CHECK(tension_after(path, strain, for_ever) == Approx(top * working(shape, x)).epsilon(1e-13));
        }
        CHECK(tension_after(path, 0.035, for_ever) == Approx(original.at(0.035).value).epsilon(1e-14));
    }
    SyropeRope by_slope = some_fibre_rope(WorkingShape::linear);
    by_slope.k1 = 1.2e8;
    const SyropeLaw law(Mat6::Identity(), by_slope);
    LawPath path(law);
    const double top = tension_after(path, 0.03, for_ever);
    CHECK(tension_after(path, 0.025, for_ever) == Approx(top - 0.005 * 1.2e8).epsilon(1e-13));
}

TEST_CASE("Quick changes of a fibre rope meet a stiffness that grows with its mean tension", "[laws]") {
    const SyropeLaw law(Mat6::Identity(), some_fibre_rope());
    for (const double strain : {0.005, 0.02, 0.05}) {
        LawPath path(law);
        const double mean = tension_after(path, strain, for_ever);
        const double quick = path.look(strain_along(0, strain + 1e-4), 1e-9).resultants[0];
        CHECK((quick - mean) / 1e-4 == Approx(2e8 + 23.12 * mean).epsilon(1e-9));
    }
}

// By SciPy's DOP853 with tolerances of 1e-11, from one meeting of both curves to the next.
TEST_CASE("A fibre rope follows its differential equation", "[laws]") {
    const std::vector<std::pair<double, double>> reference{{10.0, 1064411.2121254005},
                                                           {25.0, 2023780.59746037},
                                                           {40.0, 2698389.5076095536},
                                                           {42.5, 3609136.7947463077},
                                                           {45.0, 1834921.082735068},
                                                           {47.0, 621384.700889937},
                                                           {50.0, 2121241.169184585},
                                                           {53.0, 3054921.627648076},
                                                           {56.0, 773871.6321714298},
                                                           {60.0, 1972025.4002356569},
                                                           {66.0, 700786.5591488725},
                                                           {72.5, 3046505.696953217},
                                                           {77.0, 320629.04041636316},
                                                           {80.0, 1916720.321487655}};
    const SyropeLaw law(Mat6::Identity(), some_fibre_rope());
    const auto error = [&](int steps_in_unit) {
        LawPath path(law);
        return compare_tensions(path, reference, 0.0, steps_in_unit);
    };
    const double coarse = error(50), fine = error(1600);
    CHECK(coarse < 2e-6);
    CHECK(fine < 1e-8);
    CHECK(fine < coarse / 100.0);
}

// MoorDyn 2.7.2, one element of 20 m without mass, tScheme rk4, dtM 0.001: FairTen1 as the end moves. Its
// curves are of 30 points, linear in between.
TEST_CASE("A fibre rope has the tensions of MoorDyn", "[laws]") {
    const std::vector<std::pair<double, double>> reference{{1.0, 846612.0},
                                                           {10.0, 1445699.0},
                                                           {25.0, 1980087.0},
                                                           {40.0, 2378404.0},
                                                           {42.5, 3388839.0},
                                                           {45.0, 1674446.0},
                                                           {47.0, 501375.8},
                                                           {50.0, 2039523.0},
                                                           {53.0, 2995966.0},
                                                           {56.0, 734677.1},
                                                           {60.0, 1949393.0},
                                                           {66.0, 689102.0},
                                                           {72.5, 3040983.0},
                                                           {77.0, 317605.0},
                                                           {80.0, 1914765.0}};
    const SyropeLaw law(Mat6::Identity(), some_fibre_rope());
    LawPath path(law);
    tension_after(path, 1.03448e-2, for_ever);
    CHECK(compare_tensions(path, reference, 1.03448e-2, 100) < 1.2e-4);
}

TEST_CASE("A fibre rope that was stretched before goes on as one that is stretched now", "[laws]") {
    SyropeRope stretched = some_fibre_rope();
    const SyropeLaw fresh(Mat6::Identity(), stretched);
    stretched.largest = 0.03;
    const SyropeLaw before(Mat6::Identity(), stretched);
    LawPath path(fresh), other(before);
    tension_after(path, 0.03, for_ever);
    tension_after(path, 0.006, for_ever);
    // Of lengths that are longer by 0.006.
    for (const double strain : {0.01, 0.02, 0.015, 0.04, 0.02, 0.006}) {
        const double tension = tension_after(path, strain, 1.5);
        CHECK(tension_after(other, (strain - 0.006) / 1.006, 1.5) ==
              Approx(tension).epsilon(1e-11).margin(1e-5));
    }
    CHECK(other.dissipated() * 1.006 < path.dissipated());
}

TEST_CASE("Curves of a fibre rope that are steeper than its fast spring are found", "[laws]") {
    CHECK_FALSE(find_steep_curve(some_fibre_rope()));
    SyropeRope soft = some_fibre_rope();
    soft.stiffness = 1.53e8;
    soft.k2 = 1.5;
    const std::optional<SteepCurve> steep = find_steep_curve(soft);
    REQUIRE(steep);
    CHECK(steep->slope >= steep->stiffness);
    CHECK(steep->stiffness == Approx(1.53e8).epsilon(1e-3));
    soft.largest = 0.012;
    CHECK_FALSE(find_steep_curve(soft));
    SyropeRope softer = some_fibre_rope();
    softer.stiffness = 5e7;
    CHECK(find_steep_curve(softer)->slope == Approx(1.71768e5 / 2.06897e-3).epsilon(1e-12));
    SyropeRope slack = some_fibre_rope(WorkingShape::linear);
    slack.k1 = 5e7;  // less than the tension per strain, so that it would be longer than it ever was
    CHECK(find_steep_curve(slack));
}

}  // namespace gxrod::test
