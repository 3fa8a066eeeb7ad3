#include "contact/place_force.hpp"

#include "rotation/rotation_map.hpp"

namespace gxrod {

namespace {

// The traction if the place stuck, not yet projected: t_n − k (Δx + θ × (−r n) − drift), (C5).
Vec3 compute_pull(const SurfaceTouch& touch, const PlaceMotion& place, const CoulombFriction& friction) {
    const Vec3 slip = place.displacement - place.radius * place.rotation.cross(touch.normal) - touch.drift;
    return friction.traction - friction.stiffness * slip;
}

}  // namespace

PlaceForce compute_place_force(const SurfaceTouch& touch,
                               const PlaceMotion& place,
                               const NormalForce& normal,
                               const CoulombFriction& friction) {
    PlaceForce result;
    const double pressed = normal.force * touch.slope;
    result.force = pressed * touch.normal;
    if (!friction.acts(normal.force)) return result;
    const Traction traction =
        compute_traction(compute_pull(touch, place, friction), touch.normal, pressed, friction);
    result.slides = traction.slides;
    result.traction = traction.value;
    result.force += result.traction;
    result.moment = -place.radius * touch.normal.cross(result.traction);
    return result;
}

CoulombFriction advance_slip(const SurfaceTouch& touch,
                             const PlaceMotion& place,
                             const NormalForce& normal,
                             const CoulombFriction& friction) {
    return decide_slip(
        compute_pull(touch, place, friction), touch.normal, normal.force * touch.slope, friction);
}

PlaceForceDerivative compute_place_force_derivative(const SurfaceTouch& touch,
                                                    const PlaceMotion& place,
                                                    const NormalForce& normal,
                                                    const CoulombFriction& friction) {
    PlaceForceDerivative result;
    const Vec3& n = touch.normal;
    const Mat3& H = touch.curvature;
    // Of λ |∇g|, the force along the normal.
    const Vec3 pressed_by = normal.force * (H * n) - normal.stiffness * touch.slope * touch.slope * n;
    result.force_by_position =
        -normal.stiffness * touch.slope * touch.slope * n * n.transpose() + normal.force * H;
    if (!friction.acts(normal.force)) return result;
    const Mat3 N =
        touch.slope == 1.0 ? H : Mat3((Mat3::Identity() - n * n.transpose()) * H / touch.slope);  // of n
    const double pressed = normal.force * touch.slope;
    const double k = friction.stiffness;
    const double r = place.radius;
    const Vec3 pull = compute_pull(touch, place, friction);
    const Vec3 t = compute_traction(pull, n, pressed, friction).value;
    const TractionDerivative there = compute_traction_derivative(pull, n, pressed, friction);
    const Mat3 by_position = there.by_pull * (-k * Mat3::Identity() + (k * r) * spin(place.rotation) * N) +
                             there.by_normal * N + there.by_force * pressed_by.transpose();
    const Mat3 by_rotation = (-k * r) * there.by_pull * spin(n);
    result.force_by_position += by_position;
    result.force_by_rotation = by_rotation;
    result.moment_by_position = r * (spin(t) * N - spin(n) * by_position);
    result.moment_by_rotation = -r * spin(n) * by_rotation;
    result.force_by_axis = there.by_axes[0];
    result.moment_by_axis = -r * spin(n) * there.by_axes[0];
    return result;
}

Vec3 compute_traction_by_force(const SurfaceTouch& touch,
                               const PlaceMotion& place,
                               const NormalForce& normal,
                               const CoulombFriction& friction) {
    return touch.slope *
           compute_traction_derivative(
               compute_pull(touch, place, friction), touch.normal, normal.force * touch.slope, friction)
               .by_force;
}

}  // namespace gxrod
