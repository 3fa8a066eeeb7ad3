#include "rotation/coefficients.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include "rotation/series.hpp"

// a, b, c are Σ (−1)^k x^k/(2k + m)! with x = Φ² and m = 1, 3, 2, and D is 2 d/dx. So every derivative is
// again an alternating power series, which loses no digit at small angles and begins to lose some between 2
// and 5. The closed forms cancel at small angles and are clean from there on, over any number of turns. Each
// switch lies where the measured errors of the two cross (docs/theory/rotations.md); each series has the
// terms that leave a truncation below 1e-17 of the value at its switch.
namespace gxrod::coefficients {
namespace {

constexpr auto b_series = make_alternating_series<3, 0, 11>();
constexpr auto a1_series = make_alternating_series<1, 1, 12>();
constexpr auto b1_series = make_alternating_series<3, 1, 14>();
constexpr auto c1_series = make_alternating_series<2, 1, 14>();
constexpr auto a2_series = make_alternating_series<1, 2, 14>();
constexpr auto b2_series = make_alternating_series<3, 2, 16>();
constexpr auto c2_series = make_alternating_series<2, 2, 15>();

// d = Σ_{k≥1} 2/((2πk)² − x), a sum of positive terms while Φ < 2π. The first term, whose pole is the near
// one, is kept as it is. The others are a power series that converges for Φ < 4π; its factor of x^j is 2
// (ζ(2j + 2) − 1)/(2π)^(2j + 2).
constexpr std::array<double, 20> far_poles = {
    0.032672741512164447611,   0.00010564110705334699024, 5.6373702828768453026e-7,
    3.3571419266574513601e-9,  2.0742872904166045537e-11, 1.3000482138698973965e-13,
    8.1960520556910085984e-16, 5.1801181961697243152e-18, 3.2775391747017918398e-20,
    2.0747401878593604517e-22, 1.3136241807166533778e-24, 8.3180031951892640914e-27,
    5.2672629968342308728e-29, 3.3354842988221443313e-31, 2.1122063323183885457e-33,
    1.3375664093215244457e-35, 8.4702273286502466427e-38, 5.3638310466556986463e-40,
    3.3966848266497806992e-42, 2.1509755511832567368e-44};

constexpr std::array<double, 13> make_d_series() {
    std::array<double, 13> factors{};
    for (std::size_t j = 0; j < factors.size(); ++j) factors[j] = far_poles[j];
    return factors;
}

constexpr std::array<double, 19> make_d1_series() {
    std::array<double, 19> factors{};
    for (std::size_t j = 0; j < factors.size(); ++j)
        factors[j] = 2.0 * static_cast<double>(j + 1) * far_poles[j + 1];
    return factors;
}

constexpr std::array<double, 13> d_series = make_d_series();
constexpr std::array<double, 19> d1_series = make_d1_series();

// 4π² − x.
double distance_to_first_pole(double x) {
    constexpr double four_pi_squared = 39.4784176043574344753;
    return four_pi_squared - x;
}

double sine_over_argument(double argument) { return argument == 0.0 ? 1.0 : std::sin(argument) / argument; }

}  // namespace

double a(double angle) { return sine_over_argument(angle); }

double b(double angle) {
    const double x = angle * angle;
    if (angle < switches.b) return evaluate_series<double>(b_series, x);
    return (angle - std::sin(angle)) / (angle * x);
}

double c(double angle) {
    const double half = sine_over_argument(0.5 * angle);
    return 0.5 * half * half;
}

double a1(double angle) {
    const double x = angle * angle;
    if (angle < switches.a1) return evaluate_series<double>(a1_series, x);
    return (std::cos(angle) - a(angle)) / x;
}

double b1(double angle) {
    const double x = angle * angle;
    if (angle < switches.b1) return evaluate_series<double>(b1_series, x);
    return (3.0 * a(angle) - (2.0 + std::cos(angle))) / (x * x);
}

double c1(double angle) {
    const double x = angle * angle;
    if (angle < switches.c1) return evaluate_series<double>(c1_series, x);
    return (a(angle) - 2.0 * c(angle)) / x;
}

double a2(double angle) {
    const double x = angle * angle;
    if (angle < switches.a2) return evaluate_series<double>(a2_series, x);
    return -(a(angle) + 3.0 * a1(angle)) / x;
}

double b2(double angle) {
    const double x = angle * angle;
    if (angle < switches.b2) return evaluate_series<double>(b2_series, x);
    return -(a2(angle) + 4.0 * b1(angle)) / x;
}

double c2(double angle) {
    const double x = angle * angle;
    if (angle < switches.c2) return evaluate_series<double>(c2_series, x);
    return (a1(angle) - 4.0 * c1(angle)) / x;
}

double d(double angle) {
    const double x = angle * angle;
    if (angle < switches.d) return 2.0 / distance_to_first_pole(x) + evaluate_series<double>(d_series, x);
    const double half = 0.5 * angle;
    return (1.0 - half / std::tan(half)) / x;
}

double d1(double angle) {
    const double x = angle * angle;
    if (angle < switches.d1) {
        const double distance = distance_to_first_pole(x);
        return 4.0 / (distance * distance) + evaluate_series<double>(d1_series, x);
    }
    const double half = 0.5 * angle;
    const double sine = std::sin(half);
    return (0.25 / (sine * sine) + (half / std::tan(half) - 2.0) / x) / x;
}

}  // namespace gxrod::coefficients
