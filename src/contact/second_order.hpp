#pragma once

#include <array>
#include <cmath>

// Numbers with their first and second derivatives by a few variables.
namespace gxrod {

template <int Variables>
struct SecondOrder {
    static constexpr int products = Variables * (Variables + 1) / 2;

    double value = 0.0;
    std::array<double, Variables> slopes{};
    std::array<double, products> curvatures{};  // for variables i ≤ j, by rows

    SecondOrder() = default;
    SecondOrder(double constant) : value(constant) {}  // NOLINT: constants are numbers
    static SecondOrder make_variable(double value, int variable) {
        SecondOrder result(value);
        result.slopes[variable] = 1.0;
        return result;
    }

    // Returns f of this number, from f, f′ and f″.
    SecondOrder apply(double f, double f1, double f2) const {
        SecondOrder result(f);
        for (int k = 0; k < Variables; ++k) result.slopes[k] = f1 * slopes[k];
        for (int k = 0; k < products; ++k) result.curvatures[k] = f1 * curvatures[k];
        result.add_products(f2, slopes, slopes);
        return result;
    }

    SecondOrder& operator+=(const SecondOrder& b) {
        value += b.value;
        for (int k = 0; k < Variables; ++k) slopes[k] += b.slopes[k];
        for (int k = 0; k < products; ++k) curvatures[k] += b.curvatures[k];
        return *this;
    }
    SecondOrder& operator*=(double factor) {
        value *= factor;
        for (double& slope : slopes) slope *= factor;
        for (double& curvature : curvatures) curvature *= factor;
        return *this;
    }
    SecondOrder& operator-=(const SecondOrder& b) {
        value -= b.value;
        for (int k = 0; k < Variables; ++k) slopes[k] -= b.slopes[k];
        for (int k = 0; k < products; ++k) curvatures[k] -= b.curvatures[k];
        return *this;
    }

    // Adds factor · (a_i b_j + a_j b_i)/2 to the curvatures.
    void add_products(double factor,
                      const std::array<double, Variables>& a,
                      const std::array<double, Variables>& b) {
        int k = 0;
        for (int i = 0; i < Variables; ++i) {
            const double ai = 0.5 * factor * a[i], bi = 0.5 * factor * b[i];
            for (int j = i; j < Variables; ++j) curvatures[k++] += ai * b[j] + bi * a[j];
        }
    }

    friend SecondOrder operator+(SecondOrder a, const SecondOrder& b) { return a += b; }
    friend SecondOrder operator-(SecondOrder a, const SecondOrder& b) { return a -= b; }
    friend SecondOrder operator*(SecondOrder a, double factor) { return a *= factor; }
    friend SecondOrder operator*(double factor, SecondOrder a) { return a *= factor; }
    friend SecondOrder operator*(const SecondOrder& a, const SecondOrder& b) {
        SecondOrder result(a.value * b.value);
        for (int k = 0; k < Variables; ++k) result.slopes[k] = a.value * b.slopes[k] + b.value * a.slopes[k];
        for (int k = 0; k < products; ++k)
            result.curvatures[k] = a.value * b.curvatures[k] + b.value * a.curvatures[k];
        result.add_products(2.0, a.slopes, b.slopes);
        return result;
    }
    friend SecondOrder operator/(const SecondOrder& a, const SecondOrder& b) {
        const double inverse = 1.0 / b.value;
        return a * b.apply(inverse, -inverse * inverse, 2.0 * inverse * inverse * inverse);
    }
    friend SecondOrder sqrt(const SecondOrder& a) {
        const double root = std::sqrt(a.value);
        return a.apply(root, 0.5 / root, -0.25 / (root * a.value));
    }
    friend SecondOrder asinh(const SecondOrder& a) {
        const double slope = 1.0 / std::sqrt(1.0 + a.value * a.value);
        return a.apply(std::asinh(a.value), slope, -a.value * slope * slope * slope);
    }
};

}  // namespace gxrod
