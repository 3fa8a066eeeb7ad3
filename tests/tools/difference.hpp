#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <type_traits>

namespace gxrod::tools {

// The derivative at 0 of a function of one number, by central differences on seven points: its error falls as
// width⁶. The function must return a value, not an expression.
template <class Function>
auto differentiate(Function&& f, double width = 5e-3) {
    using Value = std::remove_cvref_t<decltype(f(width))>;
    const Value inner = f(width) - f(-width);
    const Value middle = f(2.0 * width) - f(-2.0 * width);
    const Value outer = f(3.0 * width) - f(-3.0 * width);
    const Value derivative = (45.0 * inner - 9.0 * middle + outer) / (60.0 * width);
    return derivative;
}

// |a − b| / |b|, Frobenius; |a| if b = 0.
template <class A, class B>
double relative_difference(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
    const double scale = b.norm();
    return (a - b).norm() / (scale > 0.0 ? scale : 1.0);
}
inline double relative_difference(double a, double b) {
    return std::abs(a - b) / (b != 0.0 ? std::abs(b) : 1.0);
}

}  // namespace gxrod::tools
