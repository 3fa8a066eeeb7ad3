#include "rotation/coefficients.hpp"

#include <array>
#include <cmath>
#include <cstddef>

// a, b, c are Σ (−1)^k x^k/(2k + m)! with x = Φ² and m = 1, 3, 2, and D is 2 d/dx. So every derivative is
// again an alternating power series that loses no digit at small angles and few up to about 4. The closed
// forms lose digits the other way: at small angles they cancel, from about 3 to 5 upward they do not. Each
// switch lies where the measured errors of the two cross (docs/theory/rotations.md), which for the
// derivatives is beyond π; the closed forms then serve any angle, over several turns.
namespace gxrod::coefficients {
namespace {

template <std::size_t terms>
double evaluate_polynomial(const std::array<double, terms>& factors, double x) {
    double sum = factors[terms - 1];
    for (std::size_t k = terms - 1; k-- > 0;) sum = sum * x + factors[k];
    return sum;
}

// Factors of D^order Σ (−1)^k x^k/(2k + offset)!, rounded once: long double holds every factorial used here
// to more digits than double.
template <int offset, int order, std::size_t terms>
constexpr std::array<double, terms> make_series() {
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

// Where each series hands over to its closed form, and how many terms it needs for a truncation below 1e-17
// relative there. `a` and `c` need none: sinΦ/Φ and its half-angle form do not cancel.
struct {
    double b = 2.0, a1 = 3.5, b1 = 5.0, c1 = 3.5, a2 = 4.0, b2 = 5.5, c2 = 4.75, d = 3.5, d1 = 5.5;
} constexpr switch_angle;

constexpr auto b_series = make_series<3, 0, 11>();
constexpr auto a1_series = make_series<1, 1, 16>();
constexpr auto b1_series = make_series<3, 1, 18>();
constexpr auto c1_series = make_series<2, 1, 15>();
constexpr auto a2_series = make_series<1, 2, 16>();
constexpr auto b2_series = make_series<3, 2, 18>();
constexpr auto c2_series = make_series<2, 2, 17>();

// d = Σ_{k≥1} 2/((2πk)² − x), a sum of positive terms while Φ < 2π. Its first term is kept as it stands; the
// others are the power series with factors 2(ζ(2j+2) − 1)/(2π)^(2j+2), which converges for Φ < 4π and cannot
// cancel.
constexpr std::array<double, 24> d_series = {
    0.032672741512164447611,   0.00010564110705334699024, 5.6373702828768453026e-7,
    3.3571419266574513601e-9,  2.0742872904166045537e-11, 1.3000482138698973965e-13,
    8.1960520556910085984e-16, 5.1801181961697243152e-18, 3.2775391747017918398e-20,
    2.0747401878593604517e-22, 1.3136241807166533778e-24, 8.3180031951892640914e-27,
    5.2672629968342308728e-29, 3.3354842988221443313e-31, 2.1122063323183885457e-33,
    1.3375664093215244457e-35, 8.4702273286502466427e-38, 5.3638310466556986463e-40,
    3.3966848266497806992e-42, 2.1509755511832567368e-44, 1.3621211117593842855e-46,
    8.6257325141131790368e-49, 5.462308871489559307e-51,  3.4590474864883951706e-53};

constexpr std::array<double, 23> make_d1_series() {
    std::array<double, 23> factors{};
    for (std::size_t j = 0; j < factors.size(); ++j)
        factors[j] = 2.0 * static_cast<double>(j + 1) * d_series[j + 1];
    return factors;
}
constexpr auto d1_series = make_d1_series();

// 4π² − Φ².
double distance_to_first_pole(double angle) {
    constexpr double two_pi = 6.283185307179586477;
    return (two_pi - angle) * (two_pi + angle);
}

double sine_over_argument(double argument) { return argument == 0.0 ? 1.0 : std::sin(argument) / argument; }

}  // namespace

double a(double angle) { return sine_over_argument(angle); }

double b(double angle) {
    if (angle < switch_angle.b) return evaluate_polynomial(b_series, angle * angle);
    return (angle - std::sin(angle)) / (angle * angle * angle);
}

double c(double angle) {
    const double half = sine_over_argument(0.5 * angle);
    return 0.5 * half * half;
}

double a1(double angle) {
    if (angle < switch_angle.a1) return evaluate_polynomial(a1_series, angle * angle);
    return b(angle) - c(angle);
}

double b1(double angle) {
    if (angle < switch_angle.b1) return evaluate_polynomial(b1_series, angle * angle);
    return (c(angle) - 3.0 * b(angle)) / (angle * angle);
}

double c1(double angle) {
    if (angle < switch_angle.c1) return evaluate_polynomial(c1_series, angle * angle);
    return (a(angle) - 2.0 * c(angle)) / (angle * angle);
}

double a2(double angle) {
    if (angle < switch_angle.a2) return evaluate_polynomial(a2_series, angle * angle);
    return b1(angle) - c1(angle);
}

double b2(double angle) {
    if (angle < switch_angle.b2) return evaluate_polynomial(b2_series, angle * angle);
    return (c1(angle) - 5.0 * b1(angle)) / (angle * angle);
}

double c2(double angle) {
    if (angle < switch_angle.c2) return evaluate_polynomial(c2_series, angle * angle);
    return (a1(angle) - 4.0 * c1(angle)) / (angle * angle);
}

double d(double angle) {
    if (angle < switch_angle.d)
        return 2.0 / distance_to_first_pole(angle) + evaluate_polynomial(d_series, angle * angle);
    const double half = 0.5 * angle;
    return (1.0 - half / std::tan(half)) / (angle * angle);
}

double d1(double angle) {
    if (angle < switch_angle.d1) {
        const double distance = distance_to_first_pole(angle);
        return 4.0 / (distance * distance) + evaluate_polynomial(d1_series, angle * angle);
    }
    const double sine = std::sin(0.5 * angle);
    const double cotangent = std::cos(0.5 * angle) / sine;
    return (0.25 / (sine * sine) - 0.5 * cotangent / angle - 2.0 * d(angle)) / (angle * angle);
}

}  // namespace gxrod::coefficients
