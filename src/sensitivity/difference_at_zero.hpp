#pragma once

namespace gxrod {

// Computes the derivative of a function at zero: central differences with the steps h and 2h, extrapolated,
// with an error of order h⁴.
template <class Function>
double differentiate_at_zero(const Function& f, double h) {
    const double near = (f(h) - f(-h)) / (2.0 * h);
    const double far = (f(2.0 * h) - f(-2.0 * h)) / (4.0 * h);
    return (4.0 * near - far) / 3.0;
}

}  // namespace gxrod
