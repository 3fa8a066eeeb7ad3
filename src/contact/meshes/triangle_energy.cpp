#include "contact/meshes/triangle_energy.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {
namespace {

// Legend: z height of the point above the plane of the triangle, U = z² − radius²; of an edge: h how far its
// line is from the foot of the point, y along it from there, A = U + h², so that u = A + y² = U + ρ², ρ² = h²
// + y².

Nearness variable(const Vec3& slope, double value) {
    Nearness result(value);
    for (int i = 0; i < 3; ++i) result.slopes[static_cast<std::size_t>(i)] = slope[i];
    return result;
}

Nearness atan(const Nearness& a) {
    const double slope = 1.0 / (1.0 + a.value * a.value);
    return a.apply(std::atan(a.value), slope, -2.0 * a.value * slope * slope);
}

// The angle of (x, y).
Nearness atan2(const Nearness& y, const Nearness& x) {
    if (std::abs(x.value) >= std::abs(y.value)) {
        Nearness angle = atan(y / x);
        angle.value = std::atan2(y.value, x.value);
        return angle;
    }
    Nearness angle = -1.0 * atan(x / y);
    angle.value = std::atan2(y.value, x.value);
    return angle;
}

// atan(√s)/√s, and its continuation artanh(√−s)/√−s.
Nearness apply_arc(const Nearness& s) {
    const double x = s.value;
    if (std::abs(x) < 0.03) {
        double f = 0.0, f1 = 0.0, f2 = 0.0, power = 1.0;  // Σ (−x)^k/(2k + 1)
        for (int k = 0; k < 12; ++k) {
            const double sign = k % 2 == 0 ? 1.0 : -1.0;
            f += sign * power / (2 * k + 1);
            f1 -= sign * power * (k + 1) / (2 * k + 3);
            f2 += sign * power * (k + 1) * (k + 2) / (2 * k + 5);
            power *= x;
        }
        return s.apply(f, f1, f2);
    }
    const double root = std::sqrt(std::abs(x));
    const double f = (x > 0.0 ? std::atan(root) : std::atanh(root)) / root;
    const double slope = 1.0 / (1.0 + x);
    const double f1 = (slope - f) / (2.0 * x);
    return s.apply(f, f1, (-slope * slope - 3.0 * f1) / (2.0 * x));
}

// Part of an edge, from y1 to y2.
struct EdgePart {
    Nearness h, A, y1, y2;
    double length() const { return y2.value - y1.value; }
};

// ∫ dy/(A + y²), where that does not vanish on the way.
Nearness integrate_inverse(const Nearness& A, const Nearness& y1, const Nearness& y2) {
    const Nearness across = A + y1 * y2;
    const Nearness length = y2 - y1;
    if (A.value > 0.0 && across.value < std::sqrt(A.value) * length.value) {
        const Nearness root = sqrt(A);
        return atan2(root * length, across) / root;
    }
    const Nearness t = length / across;
    return t * apply_arc(A * t * t);
}

// The angle under which the foot sees a part.
Nearness find_angle(const EdgePart& part) {
    return atan2(part.h * (part.y2 - part.y1), part.h * part.h + part.y1 * part.y2);
}

// ∫ dy/((A + y²)(B + y²)) for small A and B next to y².
Nearness integrate_far_product(const Nearness& A, const Nearness& B, const Nearness& y1, const Nearness& y2) {
    const auto sum_at = [&](const Nearness& y) {
        const Nearness inverse = Nearness(1.0) / (y * y);
        Nearness sum, power = inverse / y, coefficient(1.0), B_power(1.0);
        for (int k = 0; k < 14; ++k) {
            sum += (-1.0 / (3 + 2 * k)) * (coefficient * power);
            power = power * inverse;
            B_power = B_power * (-1.0 * B);
            coefficient = B_power - A * coefficient;
        }
        return sum;
    };
    return sum_at(y2) - sum_at(y1);
}

// The same for A near B > 0.
Nearness integrate_near_product(const Nearness& A,
                                const Nearness& B,
                                const Nearness& y1,
                                const Nearness& y2) {
    const Nearness a = sqrt(A), b = sqrt(B);
    const Nearness ab = a * b;
    const auto at = [&](const Nearness& y) {
        const Nearness t = y / (ab + y * y);
        const Nearness apart = t * (b - a);
        return atan2(y, b) + b * t * apply_arc(apart * apart);
    };
    return (at(y2) - at(y1)) / (ab * (a + b));
}

// ∫ dθ/u along a part.
Nearness integrate_over_u(const EdgePart& part, const Nearness& U, const Nearness& angle) {
    const Nearness B = part.h * part.h;
    const bool has_foot = part.y1.value * part.y2.value <= 0.0;
    const double nearest = std::min(part.y1.value * part.y1.value, part.y2.value * part.y2.value);
    if (!has_foot && std::max(std::abs(part.A.value), B.value) < 0.04 * nearest)
        return part.h * integrate_far_product(part.A, B, part.y1, part.y2);
    if (std::abs(U.value) > 0.1 * B.value)
        return (angle - part.h * integrate_inverse(part.A, part.y1, part.y2)) / U;
    return part.h * integrate_near_product(part.A, B, part.y1, part.y2);
}

Nearness cube(const Nearness& y) { return y * y * y; }

// W(U) and what the edges take of it.
class Sum {
  public:
    Sum(const Nearness& U, double w, bool is_above) : U_(U), w_(w), is_above_(is_above) {
        if (!is_above) return;
        const Nearness rest = Nearness(1.0) - (1.0 / w) * U;
        whole_ = rest * rest * rest * (Nearness(w) / U);
    }

    // u ≥ w.
    void add_far(const EdgePart& part) {
        if (is_above_) sum_ += whole_ * find_angle(part);
    }
    void add_near(const EdgePart& part) {
        const Nearness& h = part.h;
        const Nearness dy = part.y2 - part.y1;
        const Nearness cubic =
            (1.0 / (w_ * w_)) * ((2.0 * U_ + h * h) * dy + (1.0 / 3.0) * (cube(part.y2) - cube(part.y1)));
        const Nearness smooth = h * (cubic - (3.0 / w_) * dy);
        if (is_above_) {
            sum_ += smooth + (h * integrate_inverse(part.A, part.y1, part.y2)) * (Nearness(w_) / U_);
            return;
        }
        const Nearness angle = find_angle(part);
        const Nearness x = (1.0 / w_) * U_;
        sum_ += smooth + (Nearness(3.0) - 3.0 * x + x * x) * angle - w_ * integrate_over_u(part, U_, angle);
    }
    Nearness result() const { return (0.5 / M_PI) * sum_; }

  private:
    const Nearness& U_;
    double w_;
    bool is_above_;  // sums with W(U), which edges take away; without it where the foot is outside
    Nearness whole_{}, sum_{};
};

EdgePart cut(EdgePart part, double from, double to) {
    if (from > part.y1.value) part.y1 = Nearness(from);
    if (to < part.y2.value) part.y2 = Nearness(to);
    return part;
}

void add_edge(const EdgePart& edge, double w, Sum& sum) {
    const double reach = w - edge.A.value;
    const double most = reach > 0.0 ? std::sqrt(reach) : 0.0;
    const double from = std::max(edge.y1.value, -most), to = std::min(edge.y2.value, most);
    if (from >= to) {
        sum.add_far(edge);
        return;
    }
    if (from > edge.y1.value) sum.add_far(cut(edge, edge.y1.value, from));
    sum.add_near(cut(edge, from, to));
    if (to < edge.y2.value) sum.add_far(cut(edge, to, edge.y2.value));
}

}  // namespace

Nearness compute_nearness(const Triangle& triangle, const Vec3& point, double radius, double skin) {
    const double w = skin * (2.0 * radius + skin);
    const Nearness z = variable(triangle.normal, (point - triangle.corners[0]).dot(triangle.normal));
    const Nearness U = z * z - Nearness(radius * radius);
    const ClosestOnTriangle closest = find_on_triangle(triangle, point);
    const double outside =
        closest.distance * closest.distance - z.value * z.value;  // ρ² of the closest point
    if (U.value + std::max(outside, 0.0) >= w * (1.0 - 1e-9)) return {};
    const bool is_inside = !closest.is_corner && closest.edge < 0;
    Sum sum(U, w, is_inside || U.value > 0.01 * outside);
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 offset = triangle.corners[i] - point;
        const Nearness h = variable(-triangle.out[i], offset.dot(triangle.out[i]));
        const Nearness y = variable(-triangle.along[i], offset.dot(triangle.along[i]));
        add_edge({h, U + h * h, y, y + Nearness(triangle.lengths[i])}, w, sum);
    }
    return sum.result();
}

std::optional<Nearness> find_gap(const Nearness& nearness, double radius, double skin) {
    // Of u = w v, c = 1 − v: c³ = E v.
    const double E = nearness.value;
    if (!(E > 1e-24)) return std::nullopt;
    double v = 0.0, c = 1.0;
    if (E < 1.0) {
        c = std::cbrt(E);
        for (int i = 0; i < 30; ++i) {
            const double change = (c * c * c + E * c - E) / (3.0 * c * c + E);
            c -= change;
            if (std::abs(change) < 1e-16 * c) break;
        }
        v = c * c * c / E;
    } else {
        for (int i = 0; i < 30; ++i) {
            const double rest = 1.0 - v;
            const double change = (rest * rest * rest - E * v) / (3.0 * rest * rest + E);
            v += change;
            if (std::abs(change) < 1e-16 * v) break;
        }
        c = 1.0 - v;
    }
    const double v1 = -v * v / (c * c * (1.0 + 2.0 * v));
    const double v2 = v1 * v1 * (2.0 / v + 2.0 / c - 2.0 / (1.0 + 2.0 * v));
    const double w = skin * (2.0 * radius + skin);
    const double distance = std::sqrt(radius * radius + w * v);
    const double g1 = 0.5 * w / distance;
    return nearness.apply(w * v / (distance + radius), g1 * v1, g1 * v2 - g1 * g1 / distance * v1 * v1);
}

}  // namespace gxrod
