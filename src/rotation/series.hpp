#pragma once

#include <array>
#include <cstddef>

// Power series of the coefficients of finite rotations. Real is double, or several of them that are worked on
// at once.
namespace gxrod {

// Factors of D^order Σ (−1)^k x^k/(2k + offset)! with D = 2 d/dx, rounded once: long double holds every
// factorial used here to more digits than double.
template <int offset, int order, std::size_t terms>
constexpr std::array<double, terms> make_alternating_series() {
    std::array<double, terms> factors{};
    for (std::size_t j = 0; j < terms; ++j) {
        const int k = static_cast<int>(j) + order;
        long double numerator = k % 2 == 0 ? 1.0L : -1.0L;
        for (int i = 0; i < order; ++i) numerator *= 2 * (k - i);
        long double factorial = 1.0L;
        for (int i = 2; i <= 2 * k + offset; ++i) factorial *= i;
        factors[j] = static_cast<double>(numerator / factorial);
    }
    return factors;
}

template <class Real, std::size_t terms>
Real evaluate_series(const std::array<double, terms>& factors, const Real& argument) {
    Real sum(factors[terms - 1]);
    for (std::size_t k = terms - 1; k-- > 0;) sum = sum * argument + Real(factors[k]);
    return sum;
}

}  // namespace gxrod
