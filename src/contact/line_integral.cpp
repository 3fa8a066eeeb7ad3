#include "contact/line_integral.hpp"

#include <algorithm>
#include <cmath>

// Legend: lo and hi the ends of the part in range, |z| ≤ √(w − G). J_k = ∫ dz/u^k from lo to hi.
namespace gxrod {
namespace {

// ∫ dζ/(y + ζ²)^k from 1 to ∞, k = 1 … 4; y > −1.
struct TailIntegrals {
    double first, second, third, fourth;
};

TailIntegrals integrate_tails(double y) {
    if (std::abs(y) < 0.1) {
        // Σ binomial(−k, j) y^j/(2k − 1 + 2j)
        TailIntegrals tails{0.0, 0.0, 0.0, 0.0};
        double power = 1.0;
        for (int j = 0; j < 18; ++j, power *= -y) {
            tails.first += power / (1 + 2 * j);
            tails.second += power * (j + 1) / (3 + 2 * j);
            tails.third += power * (j + 1) * (j + 2) / (2 * (5 + 2 * j));
            tails.fourth += power * (j + 1) * (j + 2) * (j + 3) / (6 * (7 + 2 * j));
        }
        return tails;
    }
    const double root = std::sqrt(std::abs(y)), inverse = 1.0 / (1.0 + y);
    const double first = (y > 0.0 ? std::atan(root) : std::atanh(root)) / root;
    const double second = (first - inverse) / (2.0 * y);
    const double third = (3.0 * second - inverse * inverse) / (4.0 * y);
    return {first, second, third, (5.0 * third - inverse * inverse * inverse) / (6.0 * y)};
}

// Antiderivatives of u^−k at z, for k = 1 … 4: from 0, or, where lo and hi lie on one side of the foot,
// from the infinite end of that side, which keeps their digits for all G.
TailIntegrals integrate_inverses(double G, double z, double u, bool from_foot) {
    if (from_foot) {
        const double root = std::sqrt(G), first = std::atan(z / root) / root;
        const double second = (z / u + first) / (2.0 * G);
        const double third = (z / (u * u) + 3.0 * second) / (4.0 * G);
        return {first, second, third, (z / (u * u * u) + 5.0 * third) / (6.0 * G)};
    }
    const TailIntegrals tails = integrate_tails(G / (z * z));
    const double square = z * z, cube = square * z;
    return {-tails.first / z,
            -tails.second / cube,
            -tails.third / (cube * square),
            -tails.fourth / (cube * square * square)};
}

}  // namespace

LineIntegral integrate_line(double w, double G, double z0, double z1) {
    LineIntegral integral;
    if (G >= w) return integral;
    const double reach = std::sqrt(w - G);
    const bool low_free = z0 > -reach, high_free = z1 < reach;
    const double lo = low_free ? z0 : -reach, hi = high_free ? z1 : reach;
    if (lo >= hi) return integral;
    const double u_lo = low_free ? G + lo * lo : w, u_hi = high_free ? G + hi * hi : w;
    // So near the foot that their powers may vanish, ends are as good as beyond it.
    const double near_foot = 1e-3 * std::sqrt(std::max(G, 0.0));
    const bool from_foot = lo <= near_foot && hi >= -near_foot;
    const TailIntegrals low = integrate_inverses(G, lo, u_lo, from_foot);
    const TailIntegrals high = integrate_inverses(G, hi, u_hi, from_foot);
    const double length = hi - lo;
    // Φ = w²/u² − 3 w/u + 3 − u/w
    integral.value = w * w * (high.second - low.second) - 3.0 * w * (high.first - low.first) +
                     length * (3.0 - (G + (hi * hi + hi * lo + lo * lo) / 3.0) / w);
    integral.by_G =
        -2.0 * w * w * (high.third - low.third) + 3.0 * w * (high.second - low.second) - length / w;
    integral.by_GG = 6.0 * w * w * (high.fourth - low.fourth) - 6.0 * w * (high.third - low.third);
    const auto add_end =
        [w](double z, double u, double& first, double& by_G_end, double& second, double sign) {
            const double x = u / w;
            const double slope = -(1.0 - x) * (1.0 - x) * (2.0 + x) / (w * x * x * x);
            first = sign * (1.0 - x) * (1.0 - x) * (1.0 - x) / (x * x);
            by_G_end = sign * slope;
            second = sign * slope * 2.0 * z;
        };
    if (low_free) add_end(lo, u_lo, integral.by_low, integral.by_G_low, integral.by_low_low, -1.0);
    if (high_free) add_end(hi, u_hi, integral.by_high, integral.by_G_high, integral.by_high_high, 1.0);
    return integral;
}

}  // namespace gxrod
