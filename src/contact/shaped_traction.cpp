#include "contact/shaped_traction.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

// Legend: q the pull along the surface; M, positive semidefinite, the coefficients by direction relative to
// the largest one, with n as an eigenvector; s = μ λ φ of the speed; d the unit vector against the slip; g =
// k times the length of the slip. (s M + g) d = q and t = s M d, (C29).
namespace gxrod {

namespace {

using Vec2 = Eigen::Vector2d;

struct ShareAtSpeed {
    double value = 1.0, slope = 0.0;
};

ShareAtSpeed find_share(const FrictionShape& shape, double speed) {
    if (!shape.weakens()) return {};
    const double x = speed / shape.stribeck_speed;
    const double left = (1.0 - shape.kinetic) * std::exp(-x * x);
    return {shape.kinetic + left, -2.0 * x / shape.stribeck_speed * left};
}

// What M has along the projection w of an axis on the surface, more than across.
struct ConeAxis {
    Vec3 w = Vec3::Zero();
    double forward = 0.0, backward = 0.0;

    // The traction pulls forward what slides backward.
    double more(bool pulls_back) const { return pulls_back ? forward : backward; }
};

struct Cone {
    double across = 1.0;
    std::array<ConeAxis, 2> axes;
    double size = 0.0;  // s
    double size_by_speed = 0.0;
    Vec3 passing = Vec3::Zero();  // unit vector of the speed
    Vec3 passed = Vec3::Zero();   // the slip since the last accepted step, which is speed × elapsed

    Cone(const Vec3& pull, const Vec3& normal, double normal_force, const CoulombFriction& friction) {
        const FrictionShape& shape = *friction.shape;
        across = shape.across;
        const bool has_two = !friction.axes[0].isZero(0.0) && !friction.axes[1].isZero(0.0);
        const double part = has_two ? 0.5 : 1.0;
        for (std::size_t i = 0; i < axes.size(); ++i)
            axes[i] = {friction.axes[i] - normal * normal.dot(friction.axes[i]),
                       part * (shape.forward - across),
                       part * (shape.backward - across)};
        ShareAtSpeed share;
        if (shape.weakens() && friction.elapsed > 0.0) {
            passed = (friction.traction - pull) / friction.stiffness;
            const Vec3 along = passed - normal * normal.dot(passed);
            const double length = along.norm();
            if (length > 0.0) passing = along / length;
            share = find_share(shape, length / friction.elapsed);
        }
        size = friction.coefficient * normal_force * share.value;
        size_by_speed = friction.coefficient * normal_force * share.slope;
    }
};

// For each axis, whether the traction pulls back along it.
using Sides = std::array<bool, 2>;

Sides find_sides(const Cone& cone, const Vec3& direction) {
    return {cone.axes[0].w.dot(direction) < 0.0, cone.axes[1].w.dot(direction) < 0.0};
}

Mat3 find_matrix(const Cone& cone, const Sides& sides) {
    Mat3 M = cone.across * Mat3::Identity();
    for (std::size_t i = 0; i < sides.size(); ++i)
        M += cone.axes[i].more(sides[i]) * cone.axes[i].w * cone.axes[i].w.transpose();
    return M;
}

// As in traction.cpp, relative to the cone: what is on it but for rounding turns with its slip, too.
constexpr double nearly_on_shape = 1.0 - 1e-5;

// Whether |m⁻¹ q| is at least this; without m in a direction it is beyond all.
bool is_at_least(const Vec2& m, const Vec2& q, double size) {
    double square = 0.0;
    for (int i = 0; i < 2; ++i) {
        if (q[i] != 0.0) square += (q[i] / m[i]) * (q[i] / m[i]);
    }
    return square >= size * size;
}

// Solves |(m + g)⁻¹ q| = 1. From below, where these iterations start, they rise to it. Without slip it is 0,
// but for what is nearly on the cone.
double find_slip_force(const Vec2& m, const Vec2& q) {
    const bool is_thin = std::min(m[0], m[1]) < 1e-3 * std::max(m[0], m[1]);
    if (!is_at_least(m, q, is_thin ? 1.0 : nearly_on_shape)) return 0.0;
    double g = std::max({std::abs(q[0]) - m[0], std::abs(q[1]) - m[1], q.norm() - std::max(m[0], m[1])});
    if (is_thin) g = std::max(g, 0.0);
    for (int iteration = 0; iteration < 100; ++iteration) {
        double square = 0.0, slope = 0.0;
        for (int i = 0; i < 2; ++i) {
            if (q[i] == 0.0) continue;
            const double p = q[i] / (m[i] + g);
            square += p * p;
            slope += p * p / (m[i] + g);
        }
        const double size = std::sqrt(square);
        if (!(size > 1.0)) break;
        const double next = g + square / slope * (size - 1.0);
        if (!(next > g)) break;
        g = next;
    }
    return g;
}

struct ConeSlip {
    Vec3 direction = Vec3::Zero();
    double g = 0.0;  // 0: it sticks; below 0 a little if it is nearly on the cone
    Mat3 M = Mat3::Identity();
};

ConeSlip find_cone_slip_for(const Cone& cone, const Vec3& q, const Vec3& normal, const Sides& sides) {
    ConeSlip result;
    result.M = find_matrix(cone, sides);
    Eigen::Matrix<double, 3, 2> basis;
    basis.col(0) = normal.unitOrthogonal();
    basis.col(1) = normal.cross(basis.col(0));
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen;
    eigen.computeDirect(basis.transpose() * result.M * basis);
    const Vec2 m = cone.size * eigen.eigenvalues().cwiseMax(0.0);
    const Vec2 in_plane = basis.transpose() * q;
    const Vec2 along = eigen.eigenvectors().transpose() * in_plane;
    result.g = find_slip_force(m, along);
    Vec2 p = Vec2::Zero();
    for (int i = 0; i < 2; ++i) {
        if (along[i] != 0.0) p[i] = along[i] / std::max(m[i] + result.g, 1e-300);
    }
    result.direction = (basis * (eigen.eigenvectors() * p)).stableNormalized();
    return result;
}

// With one axis, d is on the same side as q. With two, the sides that q names are tried first; one choice of
// them is that of its own solution, because M d is the gradient of a convex function of d.
ConeSlip find_cone_slip(const Cone& cone, const Vec3& q, const Vec3& normal) {
    const Sides first = find_sides(cone, q);
    for (unsigned flips = 0; flips < 4; ++flips) {
        const Sides sides{first[0] != ((flips & 1U) != 0), first[1] != ((flips & 2U) != 0)};
        const ConeSlip found = find_cone_slip_for(cone, q, normal, sides);
        if (find_sides(cone, found.direction) == sides) return found;
    }
    return find_cone_slip_for(cone, q, normal, first);
}

// How it slips: by the law, or as an iteration assumes it.
struct Taken {
    ConeSlip slipping;
    bool slides = false;
    bool turns = false;  // slides where its slip takes it
};

Taken assume(const Cone& cone, const Vec3& q, const Vec3& normal, const CoulombFriction& friction) {
    Taken taken;
    if (friction.slip == Slip::sticks) return taken;
    taken.slipping = find_cone_slip(cone, q, normal);
    const bool is_beyond = taken.slipping.g > 0.0;
    taken.slides = friction.slip == Slip::slides || is_beyond;
    const bool is_on_cone = taken.slipping.g != 0.0;
    taken.turns = taken.slides && is_on_cone &&
                  (friction.slip == Slip::by_law || q.dot(friction.direction) > 0.5 * q.norm());
    if (!taken.slides || taken.turns) return taken;
    taken.slipping.direction = friction.direction;
    taken.slipping.M = find_matrix(cone, find_sides(cone, friction.direction));
    return taken;
}

Vec3 find_tangential(const Vec3& pull, const Vec3& normal) { return pull - normal * normal.dot(pull); }

// The derivative of q − g d by a change of q; by a change of s M d it is what is left of 1.
Mat3 find_rest(const Taken& taken, double size) {
    const ConeSlip& there = taken.slipping;
    const Vec3& d = there.direction;
    const Mat3 inverse = (size * there.M + there.g * Mat3::Identity()).inverse();
    const Vec3 y = inverse * d;
    const double D = d.dot(y);
    const Mat3 turning = inverse - y * y.transpose() / D;
    return Mat3::Identity() - d * y.transpose() / D - there.g * turning;
}

}  // namespace

double find_share_at_speed(const FrictionShape& shape, double speed) {
    return find_share(shape, speed).value;
}

Traction compute_shaped_traction(const Vec3& pull,
                                 const Vec3& normal,
                                 double normal_force,
                                 const CoulombFriction& friction) {
    const Cone cone(pull, normal, normal_force, friction);
    const Vec3 q = find_tangential(pull, normal);
    const Taken taken = assume(cone, q, normal, friction);
    if (!taken.slides) return {q, false};
    return {cone.size * taken.slipping.M * taken.slipping.direction, true};
}

std::optional<Vec3> find_shaped_slip(const Vec3& pull,
                                     const Vec3& normal,
                                     double normal_force,
                                     const CoulombFriction& friction) {
    const Cone cone(pull, normal, normal_force, friction);
    const ConeSlip slipping = find_cone_slip(cone, find_tangential(pull, normal), normal);
    if (slipping.g > 0.0) return slipping.direction;
    return std::nullopt;
}

TractionDerivative compute_shaped_traction_derivative(const Vec3& pull,
                                                      const Vec3& normal,
                                                      double normal_force,
                                                      const CoulombFriction& friction) {
    TractionDerivative result;
    const Cone cone(pull, normal, normal_force, friction);
    const Taken taken = assume(cone, find_tangential(pull, normal), normal, friction);
    Mat3 by_cone = Mat3::Identity();  // by s M d
    if (!taken.slides || taken.turns) {
        const Mat3 by_q = taken.slides ? find_rest(taken, cone.size) : Mat3(Mat3::Identity());
        result.by_pull = by_q * (Mat3::Identity() - normal * normal.transpose());
        result.by_normal = -by_q * (normal * pull.transpose() + normal.dot(pull) * Mat3::Identity());
        by_cone -= by_q;
    }
    if (!taken.slides) return result;
    const Vec3& d = taken.slipping.direction;
    const Vec3 along = by_cone * taken.slipping.M * d;
    result.by_force = cone.size / normal_force * along;
    if (cone.size_by_speed != 0.0) {
        // Of the slip past the surface, which is the part along it of (t_n − pull)/k.
        const Mat3 by_slip = cone.size_by_speed / friction.elapsed * along * cone.passing.transpose();
        result.by_traction = by_slip / friction.stiffness;
        result.by_pull -= result.by_traction;
        result.by_normal -= normal.dot(cone.passed) * by_slip;
    }
    const Sides sides = find_sides(cone, d);
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const Vec3 &axis = friction.axes[i], &w = cone.axes[i].w;
        const Mat3 part = cone.size * cone.axes[i].more(sides[i]) * by_cone;
        const double wd = w.dot(d), upright = normal.dot(axis);
        result.by_axes[i] = part * (wd * (Mat3::Identity() - normal * normal.transpose()) +
                                    w * find_tangential(d, normal).transpose());
        result.by_normal -= part * (wd * (upright * Mat3::Identity() + normal * axis.transpose()) +
                                    w * (upright * d + normal.dot(d) * axis).transpose());
    }
    return result;
}

}  // namespace gxrod
