#include "rotation/coefficients.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "rotation/samples.hpp"
#include "tools/catch.hpp"

using namespace gxrod;
namespace k = gxrod::coefficients;

namespace {

__extension__ typedef __float128 Quad;

// D^order of Σ (−1)^k x^k/(2k + offset)! in quadruple precision, x = Φ². Its terms grow to about exp(Φ), so
// it keeps 22 digits even after four turns.
Quad evaluate_series(int offset, int order, double angle) {
    const Quad x = Quad(angle) * Quad(angle);
    Quad power = 1;
    for (int i = 2; i <= 2 * order + offset; ++i) power /= i;
    Quad sum = 0;
    for (int index = order; index < order + 130; ++index) {
        Quad term = index % 2 == 0 ? power : -power;
        for (int i = 0; i < order; ++i) term *= 2 * (index - i);
        sum += term;
        power *= x / ((2 * index + offset + 1) * (2 * index + offset + 2));
    }
    return sum;
}

// (Φ/2) cot(Φ/2) is a/(2c), so d is −c1/(2c).
Quad evaluate_d(double angle) { return -evaluate_series(2, 1, angle) / (2 * evaluate_series(2, 0, angle)); }

Quad evaluate_d1(double angle) {
    const Quad c = evaluate_series(2, 0, angle);
    const Quad c1 = evaluate_series(2, 1, angle);
    return (c1 * c1 - c * evaluate_series(2, 2, angle)) / (2 * c * c);
}

struct Coefficient {
    std::string name;
    double (*value)(double angle);
    Quad (*reference)(double angle);
    // The size of the closed form's terms, for angles past π, where their sum passes through zero.
    double (*envelope)(double angle);
};

double cotangent_envelope(double angle) { return 1.0 + std::abs(0.5 * angle / std::tan(0.5 * angle)); }

template <int offset, int order>
Quad series(double angle) {
    return evaluate_series(offset, order, angle);
}

double d_envelope(double p) { return cotangent_envelope(p) / (p * p); }

double d1_envelope(double p) {
    const double sine = std::sin(0.5 * p);
    return (0.25 / (sine * sine) + (1.0 + cotangent_envelope(p)) / (p * p)) / (p * p);
}

const std::vector<Coefficient>& all_coefficients() {
    static const std::vector<Coefficient> all = {
        {"a", k::a, series<1, 0>, [](double p) { return 1.0 / p; }},
        {"b", k::b, series<3, 0>, [](double p) { return 1.0 / (p * p); }},
        {"c", k::c, series<2, 0>, [](double p) { return 1.0 / (p * p); }},
        {"a1", k::a1, series<1, 1>, [](double p) { return 1.0 / (p * p); }},
        {"b1", k::b1, series<3, 1>, [](double p) { return 3.0 / std::pow(p, 4); }},
        {"c1", k::c1, series<2, 1>, [](double p) { return 1.0 / std::pow(p, 3); }},
        {"a2", k::a2, series<1, 2>, [](double p) { return 1.0 / std::pow(p, 3); }},
        {"b2", k::b2, series<3, 2>, [](double p) { return (1.0 + 15.0 / p) / std::pow(p, 5); }},
        {"c2", k::c2, series<2, 2>, [](double p) { return 1.0 / std::pow(p, 4); }},
        {"d", k::d, evaluate_d, d_envelope},
        {"d1", k::d1, evaluate_d1, d1_envelope},
    };
    return all;
}

double relative_error(const Coefficient& coefficient, double angle) {
    const Quad reference = coefficient.reference(angle);
    return std::abs(static_cast<double>((Quad(coefficient.value(angle)) - reference) / reference));
}

}  // namespace

TEST_CASE("coefficients have a relative error below 1e-15 over [1e-12, pi]", "[rotation][coefficients]") {
    const int count = 4000;
    const double low = std::log(1e-12);
    const double high = std::log(std::numbers::pi);
    for (const Coefficient& coefficient : all_coefficients()) {
        double worst = 0.0;
        double worst_angle = 0.0;
        const auto check = [&](double angle) {
            const double error = relative_error(coefficient, angle);
            if (!(error <= worst)) worst_angle = angle, worst = error;
        };
        for (int i = 0; i < count; ++i) {
            check(std::min(std::exp(low + (high - low) * i / (count - 1)), std::numbers::pi));
            check(std::numbers::pi * (i + 1) / count);
        }
        INFO(coefficient.name << ": " << worst << " at " << worst_angle);
        CHECK(worst <= 1e-15);
    }
}

TEST_CASE("coefficients have a relative error below 1e-15 at 0 and about every switch",
          "[rotation][coefficients]") {
    for (const Coefficient& coefficient : all_coefficients()) {
        std::vector<double> angles = samples::angles_past_pi();
        for (const double at : samples::switch_angles())
            for (int i = -200; i <= 200; ++i) angles.push_back(at * (1.0 + 1e-6 * i));
        // a1 passes through zero at 4.49; there the last test speaks for it.
        if (coefficient.name == "a1") std::erase_if(angles, [](double angle) { return angle > 4.0; });
        for (const double angle : angles) {
            INFO(coefficient.name << " at " << angle);
            CHECK(relative_error(coefficient, angle) <= 1e-15);
        }
    }
}

TEST_CASE("coefficients at zero are the first terms of their series", "[rotation][coefficients]") {
    CHECK(k::a(0.0) == 1.0);
    CHECK(k::b(0.0) == 1.0 / 6.0);
    CHECK(k::c(0.0) == 0.5);
    CHECK(k::a1(0.0) == -1.0 / 3.0);
    CHECK(k::b1(0.0) == -1.0 / 60.0);
    CHECK(k::c1(0.0) == -1.0 / 12.0);
    CHECK(k::a2(0.0) == 1.0 / 15.0);
    CHECK(k::b2(0.0) == 1.0 / 630.0);
    CHECK(k::c2(0.0) == 1.0 / 90.0);
    CHECK(k::d(0.0) == Approx(1.0 / 12.0).epsilon(1e-15));
    CHECK(k::d1(0.0) == Approx(1.0 / 360.0).epsilon(1e-15));
}

TEST_CASE("suffixed coefficients are the derivatives of the plain ones", "[rotation][coefficients]") {
    struct Pair {
        double (*value)(double angle);
        double (*derivative)(double angle);
    };
    const std::vector<Pair> pairs = {{k::a, k::a1},
                                     {k::b, k::b1},
                                     {k::c, k::c1},
                                     {k::a1, k::a2},
                                     {k::b1, k::b2},
                                     {k::c1, k::c2},
                                     {k::d, k::d1}};
    using Scalar = Eigen::Matrix<double, 1, 1>;
    for (const Pair& pair : pairs) {
        std::vector<double> angles = samples::angles_past_pi();
        std::erase_if(angles, [](double angle) { return angle < 0.1; });
        for (const double angle : angles) {
            const Scalar slope =
                samples::central_difference([&](double t) { return Scalar(pair.value(angle + t)); }, 0.01);
            INFO("angle " << angle);
            CHECK(pair.derivative(angle) == Approx(slope(0) / angle).margin(1e-12).epsilon(1e-11));
        }
    }
}

TEST_CASE("closed forms hold over several turns", "[rotation][coefficients]") {
    for (const Coefficient& coefficient : all_coefficients()) {
        double worst = 0.0;
        double worst_angle = 0.0;
        for (double angle = 3.0; angle < 8.0 * std::numbers::pi; angle += 0.00717) {
            const Quad difference = Quad(coefficient.value(angle)) - coefficient.reference(angle);
            const double error = std::abs(static_cast<double>(difference)) / coefficient.envelope(angle);
            if (!(error <= worst)) worst_angle = angle, worst = error;
        }
        INFO(coefficient.name << ": " << worst << " at " << worst_angle);
        CHECK(worst <= 1e-15);
    }
}
