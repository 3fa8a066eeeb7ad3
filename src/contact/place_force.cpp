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

// The traction before the cone bounds it, and how.
struct Pull {
    Vec3 traction = Vec3::Zero();
    double most = 0.0;  // of the cone
    double size = 0.0;
    bool slides = false;
    bool turns = false;  // slides where its slip takes it
};

Pull find_pull(const SurfaceTouch& touch,
               const PlaceMotion& place,
               const NormalForce& normal,
               const PlaceFriction& friction) {
    Pull pull;
    pull.traction = tangential(touch.normal) * compute_pull(touch, place, friction);
    pull.most = friction.coefficient * touch.slope * std::max(normal.force, 0.0);
    pull.size = pull.traction.norm();
    pull.slides = friction.slip == Slip::slides || (friction.slip == Slip::by_law && pull.size > pull.most);
    pull.turns = pull.slides && (friction.slip == Slip::by_law || pull.traction.dot(friction.direction) >
                                                                      std::max(pull.most, 0.5 * pull.size));
    return pull;
}

bool rubs(const NormalForce& normal, const PlaceFriction& friction) {
    return friction.coefficient > 0.0 && normal.force > 0.0;
}

}  // namespace

PlaceForce compute_place_force(const SurfaceTouch& touch,
                               const PlaceMotion& place,
                               const NormalForce& normal,
                               const PlaceFriction& friction) {
    PlaceForce result;
    result.force = normal.force * touch.slope * touch.normal;
    if (!rubs(normal, friction)) return result;
    const Pull pull = find_pull(touch, place, normal, friction);
    result.slides = pull.slides;
    result.traction = !pull.slides ? pull.traction
                      : pull.turns ? Vec3(pull.traction * (pull.most / pull.size))
                                   : Vec3(pull.most * friction.direction);
    result.force += result.traction;
    result.moment = -place.radius * touch.normal.cross(result.traction);
    return result;
}

PlaceFriction advance_slip(const SurfaceTouch& touch,
                           const PlaceMotion& place,
                           const NormalForce& normal,
                           PlaceFriction friction) {
    if (friction.coefficient == 0.0) return friction;
    const Vec3 pull = tangential(touch.normal) * compute_pull(touch, place, friction);
    const double most = friction.coefficient * touch.slope * std::max(normal.force, 0.0);
    const double size = pull.norm();
    if (!rubs(normal, friction)) {
        // If it comes to touch, it slides as it moves: it would be pulled back all the way otherwise.
        friction.slip = size > 0.0 ? Slip::slides : Slip::sticks;
        if (size > 0.0) friction.direction = pull / size;
        return friction;
    }
    const bool goes_on = friction.slip != Slip::slides || pull.dot(friction.direction) > 0.0;
    friction.slip = size > most && goes_on ? Slip::slides : Slip::sticks;
    if (friction.slip == Slip::slides) friction.direction = pull / size;
    return friction;
}

PlaceForceDerivative compute_place_force_derivative(const SurfaceTouch& touch,
                                                    const PlaceMotion& place,
                                                    const NormalForce& normal,
                                                    const PlaceFriction& friction) {
    PlaceForceDerivative result;
    const Vec3& n = touch.normal;
    const Mat3& H = touch.curvature;
    result.force_by_position =
        -normal.stiffness * touch.slope * touch.slope * n * n.transpose() + normal.force * H;
    if (!rubs(normal, friction)) return result;
    const Mat3 P = tangential(n);
    const Mat3 N = touch.slope == 1.0 ? H : Mat3(P * H / touch.slope);  // of the normal
    const double k = friction.stiffness;
    const double r = place.radius;
    const Pull pull = find_pull(touch, place, normal, friction);
    Mat3 by_position = Mat3::Zero();
    Mat3 by_rotation = Mat3::Zero();
    if (!pull.slides || pull.turns) {
        // δ(P q) = P δq − (δn · q) n − (n · q) δn
        const Vec3 q = compute_pull(touch, place, friction);
        by_position = P * (-k * Mat3::Identity() + (k * r) * spin(place.rotation) * N) -
                      n * (N.transpose() * q).transpose() - n.dot(q) * N;
        by_rotation = (-k * r) * P * spin(n);
    }
    Vec3 t = pull.traction;
    if (pull.slides) {
        const Vec3 direction = pull.turns ? Vec3(pull.traction / pull.size) : friction.direction;
        if (pull.turns) {
            const Mat3 turning =
                (pull.most / pull.size) * (Mat3::Identity() - direction * direction.transpose());
            by_position = turning * by_position;
            by_rotation = turning * by_rotation;
        }
        // Of the force along the normal, λ |∇g|.
        const Vec3 by_gap = normal.force * (H * n) - normal.stiffness * touch.slope * touch.slope * n;
        by_position += friction.coefficient * direction * by_gap.transpose();
        t = pull.most * direction;
    }
    result.force_by_position += by_position;
    result.force_by_rotation = by_rotation;
    result.moment_by_position = r * (spin(t) * N - spin(n) * by_position);
    result.moment_by_rotation = -r * spin(n) * by_rotation;
    return result;
}

}  // namespace gxrod
