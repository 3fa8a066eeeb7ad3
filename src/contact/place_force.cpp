#include "contact/place_force.hpp"

#include <algorithm>

#include "rotation/rotation_map.hpp"

namespace gxrod {

namespace {

Mat3 tangential(const Vec3& normal) { return Mat3::Identity() - normal * normal.transpose(); }

// The traction if the place stuck, not yet projected: t_n − k (Δx + θ × (−r n) − drift), (C5).
Vec3 compute_pull(const SurfaceTouch& touch, const PlaceMotion& place, const PlaceFriction& friction) {
    const Vec3 slip = place.displacement - place.radius * place.rotation.cross(touch.normal) - touch.drift;
    return friction.traction - friction.stiffness * slip;
}

}  // namespace

PlaceForce compute_place_force(const SurfaceTouch& touch,
                               const PlaceMotion& place,
                               const NormalForce& normal,
                               const PlaceFriction& friction) {
    PlaceForce result;
    const double pressed = std::max(normal.force, 0.0);
    result.force = normal.force * touch.normal;
    if (friction.coefficient == 0.0 || pressed == 0.0) return result;
    result.traction = tangential(touch.normal) * compute_pull(touch, place, friction);
    const double most = friction.coefficient * pressed;
    const double size = result.traction.norm();
    result.slides = size > most;
    if (result.slides) result.traction *= most / size;
    result.force += result.traction;
    result.moment = -place.radius * touch.normal.cross(result.traction);
    return result;
}

PlaceForceDerivative compute_place_force_derivative(const SurfaceTouch& touch,
                                                    const PlaceMotion& place,
                                                    const NormalForce& normal,
                                                    const PlaceFriction& friction) {
    PlaceForceDerivative result;
    const Vec3& n = touch.normal;
    const Mat3& H = touch.curvature;
    result.force_by_position = -normal.stiffness * n * n.transpose() + normal.force * H;
    const double pressed = std::max(normal.force, 0.0);
    if (friction.coefficient == 0.0 || pressed == 0.0) return result;
    const Mat3 P = tangential(n);
    const double k = friction.stiffness;
    const double r = place.radius;
    const Vec3 q = compute_pull(touch, place, friction);
    Vec3 t = P * q;
    // δ(P q) = P δq − (δn · q) n − (n · q) δn
    Mat3 by_position = P * (-k * Mat3::Identity() + (k * r) * spin(place.rotation) * H) -
                       n * (H * q).transpose() - n.dot(q) * H;
    Mat3 by_rotation = (-k * r) * P * spin(n);
    const double most = friction.coefficient * pressed;
    const double size = t.norm();
    if (size > most) {
        const Vec3 direction = t / size;
        const Mat3 turning = (most / size) * (Mat3::Identity() - direction * direction.transpose());
        by_position =
            turning * by_position - (friction.coefficient * normal.stiffness) * direction * n.transpose();
        by_rotation = turning * by_rotation;
        t = most * direction;
    }
    result.force_by_position += by_position;
    result.force_by_rotation = by_rotation;
    result.moment_by_position = r * (spin(t) * H - spin(n) * by_position);
    result.moment_by_rotation = -r * spin(n) * by_rotation;
    return result;
}

}  // namespace gxrod
