#include "contact/pair_energy.hpp"

#include <algorithm>
#include <cassert>
#include <numbers>

#include "contact/second_order.hpp"
#include "numerics/gauss_legendre.hpp"

// Legend: A, B vectors of the segments, r from the start of b to that of a. A point x(s) of a, s in [0, 1],
// has the squared distance G + R² from the line of b; z runs along b from its foot there, z0 and z1 are the
// ends of b, lo and hi the ends of the part in range, |z| ≤ √(w − G); u = G + z². J_k = ∫ dz/u^k from lo to
// hi.
//
// The integral over b is a closed form; that over a is Gauss' rule in η, s = centre + width sinh η, which
// puts the points where the lines are near each other. Points and limits follow the ends, and so do the
// derivatives: all comes from six products of A, B and r, by which it is derived with numbers of second
// order.
namespace gxrod {
namespace {

constexpr int outer_points = 6;
using Real = SecondOrder<6>;  // by A·A, A·B, B·B, A·r, B·r, r·r

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

// ∫Φ dz and its derivatives by G, z0 and z1.
struct LineIntegral {
    double value = 0.0;
    double by_G = 0.0, by_low = 0.0, by_high = 0.0;
    double by_GG = 0.0, by_G_low = 0.0, by_G_high = 0.0, by_low_low = 0.0, by_high_high = 0.0;
};

LineIntegral integrate_line(double w, double G, double z0, double z1) {
    LineIntegral integral;
    if (G >= w) return integral;
    const double reach = std::sqrt(w - G);
    const bool low_free = z0 > -reach, high_free = z1 < reach;
    const double lo = low_free ? z0 : -reach, hi = high_free ? z1 : reach;
    if (lo >= hi) return integral;
    const double u_lo = low_free ? G + lo * lo : w, u_hi = high_free ? G + hi * hi : w;
    const bool from_foot = lo <= 0.0 && hi >= 0.0;
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

// Six products of the vectors, and what follows from them: α = |A × B|²/|B|² and so on, G = α s² + 2 β s + γ
// − R².
struct PairShape {
    Real AA, AB, BB, Ar, Br, rr;
    Real length, axial_A, axial_r, alpha, beta, gamma;
    double radii_squared, reach_squared;  // R², (R + ĝ)²

    PairShape(const Vec3& A, const Vec3& B, const Vec3& r, const PairLaw& pair) {
        AA = Real::make_variable(A.squaredNorm(), 0);
        AB = Real::make_variable(A.dot(B), 1);
        BB = Real::make_variable(B.squaredNorm(), 2);
        Ar = Real::make_variable(A.dot(r), 3);
        Br = Real::make_variable(B.dot(r), 4);
        rr = Real::make_variable(r.squaredNorm(), 5);
        length = sqrt(BB);
        const Real inverse = Real(1.0) / length;
        axial_A = AB * inverse;
        axial_r = Br * inverse;
        alpha = AA - axial_A * axial_A;
        beta = Ar - axial_A * axial_r;
        gamma = rr - axial_r * axial_r;
        radii_squared = pair.radii * pair.radii;
        reach_squared = (pair.radii + pair.law.skin) * (pair.radii + pair.law.skin);
    }
};

// The quadratic a s² + 2 b s + c, whose roots bound what is in range.
struct RangeQuadratic {
    Real a, b, c;

    bool find_roots(double& low, double& high) const {
        const double discriminant = b.value * b.value - a.value * c.value;
        if (!(discriminant > 0.0) || !(a.value > 0.0)) return false;
        const double root = std::sqrt(discriminant);
        low = (-b.value - root) / a.value;
        high = (-b.value + root) / a.value;
        return true;
    }
    Real make_root(double sign) const { return (sign * sqrt(b * b - a * c) - b) / a; }
};

// The part of a whose points are within R + ĝ of segment b: an interval, because b is convex. It ends where
// the distance from b's line or from one of b's ends is R + ĝ. False if there is none.
bool find_range(const PairShape& shape, Real& first, Real& last) {
    const RangeQuadratic quadratics[3] = {
        {shape.AA, shape.Ar, shape.rr - Real(shape.reach_squared)},
        {shape.AA, shape.Ar - shape.AB, shape.rr - 2.0 * shape.Br + shape.BB - Real(shape.reach_squared)},
        {shape.alpha, shape.beta, shape.gamma - Real(shape.reach_squared)}};
    double low = std::numeric_limits<double>::infinity(), high = -low;
    int low_from = 0, high_from = 0;
    for (int k = 0; k < 3; ++k) {
        double roots[2];
        if (k == 2 && shape.alpha.value < 1e-12 * shape.AA.value) continue;
        if (!quadratics[k].find_roots(roots[0], roots[1])) continue;
        for (const double s : roots) {
            const double z = shape.axial_r.value + s * shape.axial_A.value;
            if (k == 2 && (z < 0.0 || z > shape.length.value)) continue;
            if (s < low) low = s, low_from = k;
            if (s > high) high = s, high_from = k;
        }
    }
    if (high <= 0.0 || low >= 1.0 || !(std::min(high, 1.0) - std::max(low, 0.0) > 1e-9)) return false;
    first = low > 0.0 ? quadratics[low_from].make_root(-1.0) : Real(0.0);
    last = high < 1.0 ? quadratics[high_from].make_root(1.0) : Real(1.0);
    return true;
}

// Where the points of the outer rule concentrate. Both stay smooth where the lines are parallel (least_sine)
// and where they touch, or would touch if they were longer (least_gap).
struct OuterMap {
    Real centre, width;

    OuterMap(const PairShape& shape, double w) {
        constexpr double least_sine_squared = 1e-6, least_gap = 1e-4;
        const Real alpha = shape.alpha + least_sine_squared * shape.AA;
        centre = -1.0 * shape.beta / alpha;
        const Real G =
            (shape.alpha * centre + 2.0 * shape.beta) * centre + shape.gamma - Real(shape.radii_squared);
        width = sqrt(sqrt(G * G + Real(least_gap * w * least_gap * w)) / alpha);
    }
};

struct WeightedPlaces {
    double weight = 0.0, s = 0.0, t = 0.0;
};

// c times the double integral over [0, 1]².
Real integrate_pair(const PairShape& shape, double w, WeightedPlaces& places) {
    static const auto rule = compute_gauss_rule<outer_points>();
    Real first, last, energy;
    if (!find_range(shape, first, last)) return energy;
    const OuterMap map(shape, w);
    const Real start = asinh((first - map.centre) / map.width), end = asinh((last - map.centre) / map.width);
    const Real half = 0.5 * (end - start), middle = 0.5 * (end + start);
    const Real scale = map.width * half;
    for (const QuadraturePoint& point : rule) {
        const Real eta = middle + point.xi * half;
        const double sinh = std::sinh(eta.value), cosh = std::cosh(eta.value);
        const Real s = map.centre + map.width * eta.apply(sinh, cosh, sinh);
        const Real G = (shape.alpha * s + 2.0 * shape.beta) * s + shape.gamma - Real(shape.radii_squared);
        const Real low = -1.0 * (shape.axial_r + s * shape.axial_A), high = low + shape.length;
        const LineIntegral line = integrate_line(w, G.value, low.value, high.value);
        if (line.value == 0.0) continue;
        Real inner = G.apply(line.value, line.by_G, line.by_GG);
        inner += low.apply(0.0, line.by_low, line.by_low_low);
        inner += high.apply(0.0, line.by_high, line.by_high_high);
        inner.add_products(2.0 * line.by_G_low, G.slopes, low.slopes);
        inner.add_products(2.0 * line.by_G_high, G.slopes, high.slopes);
        const Real weight = scale * eta.apply(cosh, sinh, cosh) * point.weight;
        energy += weight * inner;
        // The force is −2 Φ′ times the distance: −∫Φ′ dz, and ∫Φ′ z dz is half the change of Φ.
        const double pressure = -line.by_G * weight.value;
        places.weight += pressure;
        places.s += pressure * s.value;
        places.t -= pressure * low.value + 0.5 * (line.by_high + line.by_low) * weight.value;
    }
    // dt is dz/|B|.
    return energy / shape.length;
}

// From derivatives by the six products to those by the ends.
void spread_to_ends(const Real& energy, const Vec3& A, const Vec3& B, const Vec3& r, PairEnergy& result) {
    using Mat69 = Eigen::Matrix<double, 6, 9>;
    Mat69 J = Mat69::Zero();  // of the products by A, B, r
    J.block<1, 3>(0, 0) = 2.0 * A.transpose();
    J.block<1, 3>(1, 0) = B.transpose();
    J.block<1, 3>(1, 3) = A.transpose();
    J.block<1, 3>(2, 3) = 2.0 * B.transpose();
    J.block<1, 3>(3, 0) = r.transpose();
    J.block<1, 3>(3, 6) = A.transpose();
    J.block<1, 3>(4, 3) = r.transpose();
    J.block<1, 3>(4, 6) = B.transpose();
    J.block<1, 3>(5, 6) = 2.0 * r.transpose();
    Vec6 slopes;
    Mat6 curvatures;
    int entry = 0;
    for (int i = 0; i < 6; ++i) {
        slopes[i] = energy.slopes[i];
        for (int j = i; j < 6; ++j) curvatures(i, j) = curvatures(j, i) = energy.curvatures[entry++];
    }
    const Eigen::Matrix<double, 9, 1> g = J.transpose() * slopes;
    Eigen::Matrix<double, 9, 9> H = J.transpose() * curvatures * J;
    constexpr int places[6][2] = {{0, 0}, {0, 3}, {3, 3}, {0, 6}, {3, 6}, {6, 6}};
    for (int k = 0; k < 6; ++k) {
        const auto [row, column] = places[k];
        H.block<3, 3>(row, column).diagonal().array() += (row == column ? 2.0 : 1.0) * slopes[k];
        if (row != column) H.block<3, 3>(column, row).diagonal().array() += slopes[k];
    }
    // A = a1 − a0, B = b1 − b0, r = a0 − b0.
    constexpr double signs[4][3] = {{-1, 0, 1}, {1, 0, 0}, {0, -1, -1}, {0, 1, 0}};
    for (int end = 0; end < 4; ++end)
        for (int k = 0; k < 3; ++k) {
            if (signs[end][k] == 0.0) continue;
            result.gradient.segment<3>(3 * end) += signs[end][k] * g.segment<3>(3 * k);
            for (int other = 0; other < 4; ++other)
                for (int l = 0; l < 3; ++l)
                    if (signs[other][l] != 0.0)
                        result.hessian.block<3, 3>(3 * end, 3 * other) +=
                            signs[end][k] * signs[other][l] * H.block<3, 3>(3 * k, 3 * l);
        }
}

}  // namespace

PairEnergy compute_pair_energy(
    const PairLaw& pair, const Segment& a, const Segment& b, double length_a, double length_b) {
    PairEnergy result;
    result.distance = find_closest_points(a, b).distance;
    if (result.distance >= pair.radii + pair.law.skin) return result;
    assert(result.distance > pair.radii);
    const Vec3 A = a.end - a.start, B = b.end - b.start, r = a.start - b.start;
    const double w = pair.law.skin * (2.0 * pair.radii + pair.law.skin);
    const PairShape shape(A, B, r, pair);
    WeightedPlaces places;
    // Long lines that cross at a right angle have π ∫Φ du, hence the force 2 π d Φ, where 2 d is about w/ĝ.
    const double scale = pair.law.stiffness * pair.law.skin / (std::numbers::pi * w) * length_a * length_b;
    const Real energy = integrate_pair(shape, w, places) * scale;
    if (!(places.weight > 0.0)) return result;
    result.energy = energy.value;
    spread_to_ends(energy, A, B, r, result);
    result.s = places.s / places.weight;
    result.t = places.t / (places.weight * shape.length.value);
    result.force = -(result.gradient.segment<3>(0) + result.gradient.segment<3>(3));
    return result;
}

PairEnergy compute_closest_energy(const PairLaw& pair, const Segment& a, const Segment& b) {
    PairEnergy result;
    const ClosestPoints closest = find_closest_points(a, b);
    result.s = closest.s;
    result.t = closest.t;
    result.distance = closest.distance;
    const double d = closest.distance, gap = d - pair.radii;
    if (gap >= pair.law.skin) return result;
    assert(gap > 0.0);
    const Vec3 x = closest.offset, n = x / d, A = a.end - a.start, B = b.end - b.start;
    const double s = closest.s, t = closest.t;
    const double shares[4] = {1.0 - s, s, t - 1.0, -t};
    constexpr double by_s[4] = {-1.0, 1.0, 0.0, 0.0}, by_t[4] = {0.0, 0.0, 1.0, -1.0};
    Vec12 slope;                         // of d
    Mat12 curvature;                     // of d
    Eigen::Matrix<double, 12, 2> mixed;  // of |x|²/2 by the ends and (s, t)
    const Mat3 across = (Mat3::Identity() - n * n.transpose()) / d;
    for (int i = 0; i < 4; ++i) {
        slope.segment<3>(3 * i) = shares[i] * n;
        mixed.block<3, 1>(3 * i, 0) = by_s[i] * x + shares[i] * A;
        mixed.block<3, 1>(3 * i, 1) = by_t[i] * x - shares[i] * B;
        for (int j = 0; j < 4; ++j) curvature.block<3, 3>(3 * i, 3 * j) = shares[i] * shares[j] * across;
    }
    // The closest points follow where they are inside: condensed.
    const bool inside_a = s > 0.0 && s<1.0, inside_b = t> 0.0 && t < 1.0;
    const double AA = A.squaredNorm(), BB = B.squaredNorm(), AB = A.dot(B);
    if (inside_a && inside_b) {
        const double det = A.cross(B).squaredNorm();
        const Vec12 p = mixed.col(0), q = mixed.col(1);
        if (det > 1e-14 * AA * BB)
            curvature -= (BB * p * p.transpose() + AA * q * q.transpose() +
                          AB * (p * q.transpose() + q * p.transpose())) /
                         (det * d);
    } else if (inside_a) {
        curvature -= mixed.col(0) * mixed.col(0).transpose() / (AA * d);
    } else if (inside_b) {
        curvature -= mixed.col(1) * mixed.col(1).transpose() / (BB * d);
    }
    const double force = compute_contact_force(pair.law, gap);
    result.energy = compute_contact_energy(pair.law, gap);
    result.gradient = -force * slope;
    result.hessian =
        -compute_contact_force_slope(pair.law, gap) * slope * slope.transpose() - force * curvature;
    result.force = force * n;
    return result;
}

}  // namespace gxrod
