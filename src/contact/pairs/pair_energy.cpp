#include "contact/pairs/pair_energy.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numbers>

#include "contact/line_integral.hpp"
#include "contact/second_order.hpp"
#include "numerics/gauss_legendre.hpp"

// Legend: A, B vectors of the segments, r from the start of b to that of a. A point x(s) of a, s in [0, 1],
// has the squared distance G + R² from the line of b; z runs along b from its foot there, z0 and z1 are the
// ends of b.
//
// The integral over b is a closed form; that over a is Gauss' rule in η, s = centre + width sinh η, which
// puts the points where the lines are near each other. Points and limits follow the ends, and so do the
// derivatives: all comes from six products of A, B and r, by which it is derived with numbers of second
// order.
namespace gxrod {
namespace {

constexpr int outer_points = 8;
using Real = SecondOrder<6>;  // by A·A, A·B, B·B, A·r, B·r, r·r

// Six products of the vectors, and what follows from them: α = |A × B|²/|B|² and so on, G = α s² + 2 β s + γ
// − R².
struct PairShape {
    Real AA, AB, BB, Ar, Br, rr;
    Real length, axial_a, axial_r, alpha, beta, gamma;
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
        axial_a = AB * inverse;
        axial_r = Br * inverse;
        alpha = AA - axial_a * axial_a;
        beta = Ar - axial_a * axial_r;
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
            const double z = shape.axial_r.value + s * shape.axial_a.value;
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

// Σ weight · ∫Φ dz over the points of the outer rule, and its derivatives by ten numbers: centre, width,
// middle and half of η's range, α, β, γ, those of the ends of b. η = middle + ξ half, s = centre + width sinh
// η, ds = width half cosh η dξ.
class OuterSum {
  public:
    enum Number { centre, width, middle, half, alpha, beta, gamma, axial_a, axial_r, length, numbers };

    double value = 0.0;
    Eigen::Matrix<double, numbers, 1> gradient = Eigen::Matrix<double, numbers, 1>::Zero();
    // Half of the Hessian: its sum with its transpose is the Hessian.
    Eigen::Matrix<double, numbers, numbers> half_hessian = Eigen::Matrix<double, numbers, numbers>::Zero();

    void add(const QuadraturePoint& point,
             const std::array<double, numbers>& x,
             double w,
             double radii_squared);

  private:
    using Row = Eigen::Matrix<double, numbers, 1>;

    void add_curvatures_of_places(double by_s,
                                  double by_weight,
                                  const QuadraturePoint& point,
                                  const std::array<double, numbers>& x,
                                  double sinh,
                                  double cosh);
};

void OuterSum::add(const QuadraturePoint& point,
                   const std::array<double, numbers>& x,
                   double w,
                   double radii_squared) {
    const double xi = point.xi, eta = x[middle] + xi * x[half];
    const double sinh = std::sinh(eta), cosh = std::sqrt(1.0 + sinh * sinh);
    const double s = x[centre] + x[width] * sinh;
    const double G = (x[alpha] * s + 2.0 * x[beta]) * s + x[gamma] - radii_squared;
    const double low = -(x[axial_r] + s * x[axial_a]);
    const LineIntegral line = integrate_line(w, G, low, low + x[length]);
    if (line.value == 0.0) return;
    const double weight = point.weight * x[width] * x[half] * cosh;
    // The four that s depends on, then those that G and the ends depend on by themselves.
    const double stretch = x[width] * cosh, G_by_s = 2.0 * (x[alpha] * s + x[beta]);
    const double s_by[4] = {1.0, sinh, stretch, xi * stretch};
    Row G_by = Row::Zero(), low_by = Row::Zero(), weight_by = Row::Zero();
    for (int k = 0; k < 4; ++k) G_by[k] = G_by_s * s_by[k], low_by[k] = -x[axial_a] * s_by[k];
    G_by[alpha] = s * s;
    G_by[beta] = 2.0 * s;
    G_by[gamma] = 1.0;
    low_by[axial_a] = -s;
    low_by[axial_r] = -1.0;
    weight_by[width] = point.weight * x[half] * cosh;
    weight_by[middle] = point.weight * x[width] * x[half] * sinh;
    weight_by[half] = point.weight * (stretch + x[width] * x[half] * xi * sinh);
    const double by_low = line.by_low + line.by_high;  // both ends move with the foot
    Row inner_by = line.by_G * G_by + by_low * low_by;
    inner_by[length] += line.by_high;
    value += weight * line.value;
    gradient += weight * inner_by + line.value * weight_by;
    Row with_G = weight * (0.5 * line.by_GG * G_by + (line.by_G_low + line.by_G_high) * low_by);
    with_G[length] += weight * line.by_G_high;
    Row with_low = weight * 0.5 * (line.by_low_low + line.by_high_high) * low_by;
    with_low[length] += weight * line.by_high_high;
    half_hessian +=
        G_by * with_G.transpose() + low_by * with_low.transpose() + weight_by * inner_by.transpose();
    half_hessian(length, length) += 0.5 * weight * line.by_high_high;
    // Second derivatives of G and low: by s twice, by s and α, β or the slope of a along b.
    for (int k = 0; k < 4; ++k) {
        const double share = weight * s_by[k];
        half_hessian(k, alpha) += share * line.by_G * 2.0 * s;
        half_hessian(k, beta) += share * line.by_G * 2.0;
        half_hessian(k, axial_a) -= share * by_low;
        for (int l = 0; l < 4; ++l) half_hessian(k, l) += share * line.by_G * x[alpha] * s_by[l];
    }
    add_curvatures_of_places(
        weight * (line.by_G * G_by_s - by_low * x[axial_a]), line.value, point, x, sinh, cosh);
}

// Second derivatives of s and of the weight.
void OuterSum::add_curvatures_of_places(double by_s,
                                        double by_weight,
                                        const QuadraturePoint& point,
                                        const std::array<double, numbers>& x,
                                        double sinh,
                                        double cosh) {
    const double xi = point.xi, d = x[width], h = x[half], of_weight = by_weight * point.weight;
    half_hessian(width, middle) += by_s * cosh + of_weight * h * sinh;
    half_hessian(width, half) += by_s * xi * cosh + of_weight * (cosh + h * xi * sinh);
    half_hessian(middle, middle) += 0.5 * (by_s * d * sinh + of_weight * d * h * cosh);
    half_hessian(middle, half) += by_s * xi * d * sinh + of_weight * d * (sinh + h * xi * cosh);
    half_hessian(half, half) +=
        0.5 * (by_s * xi * xi * d * sinh + of_weight * d * xi * (2.0 * sinh + h * xi * cosh));
}

// Of a from s = first to last.
Real integrate_part(
    const PairShape& shape, const OuterMap& map, const Real& first, const Real& last, double w) {
    static const auto rule = compute_gauss_rule<outer_points>();
    const Real start = asinh((first - map.centre) / map.width), end = asinh((last - map.centre) / map.width);
    const Real half = 0.5 * (end - start), middle = 0.5 * (end + start);
    const Real* numbers[OuterSum::numbers] = {&map.centre,
                                              &map.width,
                                              &middle,
                                              &half,
                                              &shape.alpha,
                                              &shape.beta,
                                              &shape.gamma,
                                              &shape.axial_a,
                                              &shape.axial_r,
                                              &shape.length};
    std::array<double, OuterSum::numbers> values;
    Eigen::Matrix<double, OuterSum::numbers, 6> slopes;
    for (int k = 0; k < OuterSum::numbers; ++k) {
        values[k] = numbers[k]->value;
        for (int i = 0; i < 6; ++i) slopes(k, i) = numbers[k]->slopes[i];
    }
    OuterSum sum;
    for (const QuadraturePoint& point : rule) sum.add(point, values, w, shape.radii_squared);
    Real energy(sum.value);
    const Mat6 half_curvatures = slopes.transpose() * sum.half_hessian * slopes;
    for (int i = 0, entry = 0; i < 6; ++i) {
        energy.slopes[i] = slopes.col(i).dot(sum.gradient);
        for (int j = i; j < 6; ++j)
            energy.curvatures[entry++] = half_curvatures(i, j) + half_curvatures(j, i);
    }
    for (int k = 0; k < OuterSum::numbers; ++k)
        for (int entry = 0; entry < Real::products; ++entry)
            energy.curvatures[entry] += sum.gradient[k] * numbers[k]->curvatures[entry];
    return energy;
}

// The double integral over [0, 1]². Where an end of b is in range, the integral over b rises within √w of
// it, most of all at its foot: along lines that are nearly parallel these are short parts of a, which get
// points of their own.
Real integrate_pair(const PairShape& shape, double w) {
    Real first, last;
    if (!find_range(shape, first, last)) return {};
    const OuterMap map(shape, w);
    const double along = shape.axial_a.value;
    const Real reach = 2.0 * std::sqrt(w) < shape.length.value ? Real(std::sqrt(w)) : 0.5 * shape.length;
    // Of z, measured from the end of b that comes first along a, times axial_a.
    const Real near = (along < 0.0 ? shape.length : Real(0.0)) - shape.axial_r;
    const Real far = (along < 0.0 ? Real(0.0) : shape.length) - shape.axial_r;
    const Real inwards = (along < 0.0 ? -1.0 : 1.0) * reach;
    const Real turns[4] = {near, near + inwards, far - inwards, far};
    Real energy(0.0), from = first;
    // Across b all that is in range sees the same of it.
    if (std::abs(along) * (last.value - first.value) < 0.01 * std::sqrt(w))
        return integrate_part(shape, map, first, last, w) / shape.length;
    for (const Real& turn : turns) {
        const double at = turn.value * std::copysign(1.0, along), size = std::abs(along);
        if (at <= from.value * size || at >= last.value * size) continue;
        const Real to = turn / shape.axial_a;
        energy += integrate_part(shape, map, from, to, w);
        from = to;
    }
    energy += integrate_part(shape, map, from, last, w);
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
    const double distance = find_closest_points(a, b).distance;
    if (distance >= pair.radii + pair.law.skin) return result;
    assert(distance > pair.radii);
    const Vec3 A = a.end - a.start, B = b.end - b.start, r = a.start - b.start;
    const double w = pair.law.skin * (2.0 * pair.radii + pair.law.skin);
    const PairShape shape(A, B, r, pair);
    // Long lines that cross at a right angle have π ∫Φ du, hence the force 2 π d Φ, where 2 d is about w/ĝ.
    const double scale = pair.law.stiffness * pair.law.skin / (std::numbers::pi * w) * length_a * length_b;
    const Real energy = integrate_pair(shape, w) * scale;
    result.energy = energy.value;
    spread_to_ends(energy, A, B, r, result);
    return result;
}

PairEnergy compute_point_energy(const PairLaw& pair, const Vec3& point, const Segment& line, double length) {
    PairEnergy result;
    const Vec3 B = line.end - line.start, r = point - line.start;
    const double w = pair.law.skin * (2.0 * pair.radii + pair.law.skin);
    const PairShape shape(Vec3::Zero(), B, r, pair);
    const Real G = shape.gamma - Real(shape.radii_squared);
    const Real low = -1.0 * shape.axial_r, high = shape.length - shape.axial_r;
    const LineIntegral found = integrate_line(w, G.value, low.value, high.value);
    if (found.value == 0.0) return result;
    Real energy = G.apply(found.value, found.by_G, found.by_GG) +
                  low.apply(0.0, found.by_low, found.by_low_low) +
                  high.apply(0.0, found.by_high, found.by_high_high);
    energy.add_products(2.0 * found.by_G_low, G.slopes, low.slopes);
    energy.add_products(2.0 * found.by_G_high, G.slopes, high.slopes);
    // −d/dx of ∫ Φ(x + τ²) dτ at x = ½, where λ is κ/2 and the slope of u by the gap w/ĝ.
    constexpr double half_skin_slope = 2.0 * std::numbers::sqrt2;
    energy = energy / shape.length *
             (0.5 * pair.law.stiffness * pair.law.skin / (half_skin_slope * std::sqrt(w)) * length);
    result.energy = energy.value;
    spread_to_ends(energy, Vec3::Zero(), B, r, result);
    return result;
}

PairEnergy compute_points_energy(const PairLaw& pair, const Vec3& a, const Vec3& b) {
    PairEnergy result;
    const double d = (a - b).norm(), gap = d - pair.radii;
    if (gap >= pair.law.skin) return result;
    assert(gap > 0.0);
    const Vec3 n = (a - b) / d;
    const Mat3 along = n * n.transpose();
    const double force = compute_contact_force(pair.law, gap);
    const Mat3 hessian =
        -compute_contact_force_slope(pair.law, gap) * along - force / d * (Mat3::Identity() - along);
    result.energy = compute_contact_energy(pair.law, gap);
    result.gradient.segment<3>(0) = -force * n;
    result.gradient.segment<3>(6) = force * n;
    for (const int i : {0, 6})
        for (const int j : {0, 6}) result.hessian.block<3, 3>(i, j) = i == j ? hessian : Mat3(-hessian);
    return result;
}

}  // namespace gxrod
