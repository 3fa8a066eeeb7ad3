#pragma once

#include "rotation/types.hpp"

// Smooth curves in space by their arc length.
namespace gxrod {

class Curve {
  public:
    virtual ~Curve() = default;

    virtual double length() const = 0;
    // The position at the arc length s from the start, 0 to length().
    virtual Vec3 position(double s) const = 0;
    virtual Vec3 tangent(double s) const = 0;  // a unit vector
    // The rotation that carries axes along the curve from its start to s, turning them with the tangent but
    // never about it (parallel transport): it takes tangent(0) to tangent(s).
    virtual Quat transport(double s) const = 0;
    // Returns the total angle by which the tangent has turned from the start to s, all turns counted
    // positive.
    virtual double turn(double s) const = 0;
};

// The smallest rotation that takes one unit vector to another; they must not be opposite.
inline Quat smallest_rotation(const Vec3& from, const Vec3& to) {
    Quat rotation;
    rotation.w() = 1.0 + from.dot(to);
    rotation.vec() = from.cross(to);
    return rotation.normalized();
}

}  // namespace gxrod
