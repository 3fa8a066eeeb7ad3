#include "analyses/shapes/onset.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gxrod {

namespace {

using Complex = std::complex<double>;
using Lambdas = std::vector<Complex>;

// Of |λ|, or of the largest where λ itself is small: a growth that is round-off.
constexpr double round_off = 1e-6;
// Of the parameter, relative.
constexpr double precise = 1e-11;
constexpr int most_values = 60;
// Of two values between which a pair is looked for.
constexpr int halvings = 5;

Complex find_growing(const Lambdas& lambdas) {
    return *std::max_element(
        lambdas.begin(), lambdas.end(), [](Complex a, Complex b) { return a.real() < b.real(); });
}

// Undamped, λ comes with −λ̄.
bool has_mirror(const Lambdas& lambdas, Complex lambda) {
    return std::any_of(lambdas.begin(), lambdas.end(), [&](Complex other) {
        return std::abs(other + std::conj(lambda)) < 1e-3 * lambda.real() + round_off * std::abs(lambda);
    });
}

// The two λ² nearest to a real number; NaN if there are not so many.
std::array<Complex, 2> find_nearest_squares(const Lambdas& lambdas, double about) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    Lambdas squares;
    for (const Complex& lambda : lambdas) squares.push_back(lambda * lambda);
    std::sort(squares.begin(), squares.end(), [&](Complex a, Complex b) {
        return std::abs(a - about) < std::abs(b - about);
    });
    squares.resize(std::max<std::size_t>(squares.size(), 2), none);
    return {squares[0], squares[1]};
}

// By the Illinois method, a regula falsi that halves the value of an end that stays.
template <class Function>
std::optional<double> find_zero(const Function& f, double from, double to) {
    double f_from = f(from), f_to = f(to);
    if (!(f_from * f_to < 0.0)) return std::nullopt;
    const double tolerance = precise * std::max(std::abs(from), std::abs(to));
    for (int i = 0; i < most_values; ++i) {
        const double next = (from * f_to - to * f_from) / (f_to - f_from);
        const double f_next = f(next);
        if (!std::isfinite(f_next)) return std::nullopt;
        if (f_next * f_to < 0.0) {
            from = to;
            f_from = f_to;
        } else {
            f_from *= 0.5;
        }
        const double change = std::abs(next - to);
        to = next;
        f_to = f_next;
        if (f_to == 0.0 || change < tolerance || std::abs(to - from) < tolerance) return to;
    }
    return std::nullopt;
}

// By halving, where nothing smooth vanishes.
double bisect(const FindLambdas& find_lambdas, double stable, double unstable) {
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (stable + unstable);
        (is_growing(find_lambdas(middle)) ? unstable : stable) = middle;
    }
    return unstable;
}

}  // namespace

double find_growth(const std::vector<Complex>& lambdas) {
    return lambdas.empty() ? 0.0 : find_growing(lambdas).real();
}

bool is_growing(const std::vector<Complex>& lambdas) {
    return std::any_of(lambdas.begin(), lambdas.end(), [&](Complex lambda) {
        return lambda.real() > round_off * std::abs(lambda) && lambda.real() > 0.0;
    });
}

std::optional<Onset> find_onset(const FindLambdas& find_lambdas, double stable, double unstable) {
    Lambdas at_stable = find_lambdas(stable), at_unstable = find_lambdas(unstable);
    if (at_stable.empty() || at_unstable.empty()) return std::nullopt;
    // Near it the motion that grows is the one that begins to.
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (stable + unstable);
        Lambdas between = find_lambdas(middle);
        if (between.empty()) return std::nullopt;
        if (is_growing(between)) {
            unstable = middle;
            at_unstable = std::move(between);
        } else {
            stable = middle;
            at_stable = std::move(between);
        }
    }
    const Complex growing = find_growing(at_unstable);
    Onset onset;
    onset.is_flutter = growing.imag() > round_off * std::abs(growing);
    onset.is_merging = has_mirror(at_unstable, growing);
    const double about = onset.is_flutter ? (growing * growing).real() : 0.0;
    const auto vanish = [&](double value) {
        const Lambdas lambdas = find_lambdas(value);
        if (lambdas.empty()) return std::numeric_limits<double>::quiet_NaN();
        if (!onset.is_merging) return find_growth(lambdas);
        const auto [first, second] = find_nearest_squares(lambdas, about);
        return onset.is_flutter ? std::pow(first - second, 2).real() : first.real();
    };
    const std::optional<double> zero = find_zero(vanish, stable, unstable);
    onset.value = zero ? *zero : bisect(find_lambdas, stable, unstable);
    if (!onset.is_flutter) return onset;
    const auto [first, second] = find_nearest_squares(find_lambdas(onset.value), about);
    onset.omega = std::abs(std::sqrt(onset.is_merging ? 0.5 * (first + second) : first).imag());
    return onset;
}

}  // namespace gxrod
