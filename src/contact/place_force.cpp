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
    result.force = normal.force * touch.normal;
    if (!friction.acts(normal.force)) return result;
    const Traction traction =
        compute_traction(compute_pull(touch, place, friction), touch.normal, normal.force, friction);
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
    return decide_slip(compute_pull(touch, place, friction), touch.normal, normal.force, friction);
}

PlaceForceDerivative compute_place_force_derivative(const SurfaceTouch& touch,
                                                    const PlaceMotion& place,
                                                    const NormalForce& normal,
                                                    const CoulombFriction& friction) {
    PlaceForceDerivative result;
    const Vec3& n = touch.normal;
    const Mat3& H = touch.curvature;
    result.force_by_position = -normal.stiffness * n * n.transpose() + normal.force * H;
    if (!friction.acts(normal.force)) return result;
    const double k = friction.stiffness;
    const double r = place.radius;
    const Vec3 pull = compute_pull(touch, place, friction);
    const Vec3 t = compute_traction(pull, n, normal.force, friction).value;
    const TractionDerivative there = compute_traction_derivative(pull, n, normal.force, friction);
    const Mat3 by_position = there.by_pull * (-k * Mat3::Identity() + (k * r) * spin(place.rotation) * H) +
                             there.by_normal * H - normal.stiffness * there.by_force * n.transpose();
    const Mat3 by_rotation = (-k * r) * there.by_pull * spin(n);
    result.force_by_position += by_position;
    result.force_by_rotation = by_rotation;
    result.moment_by_position = r * (spin(t) * H - spin(n) * by_position);
    result.moment_by_rotation = -r * spin(n) * by_rotation;
    return result;
}

}  // namespace gxrod
