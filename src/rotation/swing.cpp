#include "rotation/swing.hpp"

#include <cmath>

#include "rotation/rotation_map.hpp"
#include "rotation/series.hpp"

namespace gxrod {

namespace {

// f = Σ a_k (1 − c)^k: (1 − c²) df/dc = c f − 1 asks for a_k (2k + 1) = a_(k−1) k.
constexpr std::size_t term_count = 18;
constexpr std::array<double, term_count> make_series(int derivatives) {
    std::array<double, term_count> factors{};
    long double a = 1.0L;
    for (std::size_t k = 0; k < term_count + static_cast<std::size_t>(derivatives); ++k) {
        if (k > 0) a *= static_cast<long double>(k) / static_cast<long double>(2 * k + 1);
        long double factor = a;
        for (int i = 0; i < derivatives; ++i) factor *= -(static_cast<long double>(k) - i);  // d/dc
        if (k >= static_cast<std::size_t>(derivatives))
            factors[k - static_cast<std::size_t>(derivatives)] = static_cast<double>(factor);
    }
    return factors;
}
constexpr auto f_series = make_series(0);
constexpr auto f1_series = make_series(1);
constexpr auto f2_series = make_series(2);

// The series, whose terms fall by 8 and more each, are used up to this 1 − c.
constexpr double largest_in_series = 0.25;

// f and its derivatives by c.
struct Factors {
    double f, f1, f2;
};

Factors compute_factors(const Vec3& x, const Vec3& y) {
    const double less = 0.5 * (x - y).squaredNorm();  // 1 − c
    if (less < largest_in_series) {
        return {evaluate_series<double>(f_series, less),
                evaluate_series<double>(f1_series, less),
                evaluate_series<double>(f2_series, less)};
    }
    const double c = 1.0 - less;
    const double sine = x.cross(y).norm();
    const double square = sine * sine;
    Factors factors{};
    factors.f = std::atan2(sine, c) / sine;
    factors.f1 = (c * factors.f - 1.0) / square;
    factors.f2 = (factors.f + 3.0 * c * factors.f1) / square;
    return factors;
}

}  // namespace

PairedVector compute_swing(const Vec3& x, const Vec3& y) {
    const Factors factors = compute_factors(x, y);
    const Vec3 p = x.cross(y);
    const Mat3 along = factors.f1 * p * p.transpose();
    return {factors.f * p, {factors.f * spin(y) * spin(x) + along, -factors.f * spin(x) * spin(y) - along}};
}

// ṡ = f ṗ + f₁ ċ p with ẋ = ω_x × x, ẏ = ω_y × y, ṗ = ẋ × y + x × ẏ, ċ = p · (ω_x − ω_y).
PairedVector compute_swing_rate(const Vec3& x, const Vec3& y, const Vec3& omega_x, const Vec3& omega_y) {
    const auto [f, f1, f2] = compute_factors(x, y);
    const Vec3 p = x.cross(y);
    const Vec3 x_rate = omega_x.cross(x);
    const Vec3 y_rate = omega_y.cross(y);
    const Vec3 p_rate = x_rate.cross(y) + x.cross(y_rate);
    const Vec3 less = omega_x - omega_y;
    const double c_rate = p.dot(less);
    const std::array<Mat3, 2> p_by{spin(y) * spin(x), -spin(x) * spin(y)};
    const std::array<Vec3, 2> c_by{p, -p};
    // δẋ = ω_x × δx, δx = −x × δφ_x; likewise of y.
    const std::array<Mat3, 2> p_rate_by{spin(y) * spin(omega_x) * spin(x) + spin(y_rate) * spin(x),
                                        -spin(x_rate) * spin(y) - spin(x) * spin(omega_y) * spin(y)};
    PairedVector rate{f * p_rate + f1 * c_rate * p, {}};
    for (std::size_t j = 0; j < 2; ++j) {
        rate.by[j] = (f1 * p_rate + f2 * c_rate * p) * c_by[j].transpose() + f * p_rate_by[j] +
                     f1 * (p * less.transpose() + c_rate * Mat3::Identity()) * p_by[j];
    }
    return rate;
}

PairedVector compute_twist_direction(const Vec3& x, const Vec3& y) {
    const double scale = 1.0 / (1.0 + x.dot(y));
    const Vec3 p = x.cross(y);
    const Vec3 b = scale * (x + y);
    return {b, {-scale * (spin(x) + b * p.transpose()), -scale * (spin(y) - b * p.transpose())}};
}

std::array<std::array<Mat3, 2>, 2> differentiate_swing_moments(const Vec3& x, const Vec3& y, const Vec3& m) {
    const auto [f, f1, f2] = compute_factors(x, y);
    const Vec3 p = x.cross(y);
    const double along = p.dot(m);
    const std::array<Mat3, 2> p_by{spin(y) * spin(x), -spin(x) * spin(y)};
    const std::array<Vec3, 2> c_by{p, -p};
    const Vec3 first = x.cross(y.cross(m));
    const Vec3 second = -y.cross(x.cross(m));
    std::array<std::array<Mat3, 2>, 2> by;
    for (std::size_t j = 0; j < 2; ++j) {
        const Mat3 common = f2 * along * p * c_by[j].transpose() +
                            f1 * (p * m.transpose() + along * Mat3::Identity()) * p_by[j];
        by[0][j] = common + f1 * first * c_by[j].transpose();
        by[1][j] = -common + f1 * second * c_by[j].transpose();
    }
    // δx = −x × δφ_x, δy = −y × δφ_y.
    by[0][0] += f * spin(y.cross(m)) * spin(x);
    by[0][1] += f * spin(x) * spin(m) * spin(y);
    by[1][0] -= f * spin(y) * spin(m) * spin(x);
    by[1][1] -= f * spin(x.cross(m)) * spin(y);
    return by;
}

}  // namespace gxrod
