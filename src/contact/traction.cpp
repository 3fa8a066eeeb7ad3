#include "contact/traction.hpp"

#include <algorithm>

#include "contact/shaped_traction.hpp"

namespace gxrod {

namespace {

// A traction of the last step that is on the cone but for rounding turns with its slip, too: otherwise
// nothing would hold what slides across its direction.
constexpr double nearly_on_cone = 1.0 - 1e-5;

Mat3 tangential(const Vec3& normal) { return Mat3::Identity() - normal * normal.transpose(); }

// The traction before the cone bounds it, and how it does.
struct Bounded {
    Vec3 traction = Vec3::Zero();
    double most = 0.0;  // of the cone
    double size = 0.0;
    bool slides = false;
    bool turns = false;  // slides where its slip takes it
};

Bounded bound(const Vec3& pull, const Vec3& normal, double normal_force, const CoulombFriction& friction) {
    Bounded result;
    result.traction = tangential(normal) * pull;
    result.most = friction.coefficient * std::max(normal_force, 0.0);
    result.size = result.traction.norm();
    result.slides =
        friction.slip == Slip::slides || (friction.slip == Slip::by_law && result.size > result.most);
    const double least = std::max(nearly_on_cone * result.most, 0.5 * result.size);
    result.turns =
        result.slides && (friction.slip == Slip::by_law || result.traction.dot(friction.direction) > least);
    return result;
}

}  // namespace

Traction compute_traction(const Vec3& pull,
                          const Vec3& normal,
                          double normal_force,
                          const CoulombFriction& friction) {
    if (!friction.acts(normal_force)) return {};
    if (friction.shape != nullptr) return compute_shaped_traction(pull, normal, normal_force, friction);
    const Bounded bounded = bound(pull, normal, normal_force, friction);
    if (!bounded.slides) return {bounded.traction, false};
    if (bounded.turns) return {bounded.traction * (bounded.most / bounded.size), true};
    return {bounded.most * friction.direction, true};
}

TractionDerivative compute_traction_derivative(const Vec3& pull,
                                               const Vec3& normal,
                                               double normal_force,
                                               const CoulombFriction& friction) {
    TractionDerivative result;
    if (!friction.acts(normal_force)) return result;
    if (friction.shape != nullptr)
        return compute_shaped_traction_derivative(pull, normal, normal_force, friction);
    const Bounded bounded = bound(pull, normal, normal_force, friction);
    if (!bounded.slides || bounded.turns) {
        // P q of P = I − n nᵀ
        result.by_pull = tangential(normal);
        result.by_normal = -normal * pull.transpose() - normal.dot(pull) * Mat3::Identity();
    }
    if (!bounded.slides) return result;
    Vec3 direction = friction.direction;
    if (bounded.turns) {
        direction = bounded.traction / bounded.size;
        const Mat3 turning = (bounded.most / bounded.size) * tangential(direction);
        result.by_pull = turning * result.by_pull;
        result.by_normal = turning * result.by_normal;
    }
    result.by_force = friction.coefficient * direction;
    return result;
}

CoulombFriction decide_slip(const Vec3& pull,
                            const Vec3& normal,
                            double normal_force,
                            CoulombFriction friction) {
    if (friction.coefficient == 0.0) return friction;
    const Vec3 traction = tangential(normal) * pull;
    const double size = traction.norm();
    if (!friction.acts(normal_force)) {
        // If it comes to touch, it slides as it moves: it would be pulled back all the way otherwise.
        friction.slip = size > 0.0 ? Slip::slides : Slip::sticks;
        if (size > 0.0) friction.direction = traction / size;
        return friction;
    }
    const bool goes_on = friction.slip != Slip::slides || traction.dot(friction.direction) > 0.0;
    if (friction.shape != nullptr) {
        const std::optional<Vec3> slides = find_shaped_slip(pull, normal, normal_force, friction);
        friction.slip = slides && goes_on ? Slip::slides : Slip::sticks;
        if (friction.slip == Slip::slides) friction.direction = *slides;
        return friction;
    }
    friction.slip = size > friction.coefficient * normal_force && goes_on ? Slip::slides : Slip::sticks;
    if (friction.slip == Slip::slides) friction.direction = traction / size;
    return friction;
}

}  // namespace gxrod
