#pragma once

#include <optional>

#include "contact/place_force.hpp"

namespace gxrod {

// The direction n̂ of the impulse of a place, by the normals at both ends of a step, for which n̂ · Δx is the
// change of the gap on spheres and cylinders, (C18).
struct ImpulseDirection {
    std::optional<Vec3> before = {};  // the normal at the start; none where that at the end is taken

    // n̂ less the normal at the end.
    Vec3 turn(const SurfaceTouch& touch) const {
        const double cosine = before->dot(touch.normal);
        return (*before - cosine * touch.normal) / (1.0 + cosine);
    }
    void add_to(const SurfaceTouch& touch, const NormalForce& normal, PlaceForce& force) const {
        if (before) force.force += normal.force * turn(touch);
    }
    void add_to(const SurfaceTouch& touch,
                const NormalForce& normal,
                PlaceForceDerivative& derivative) const {
        if (!before) return;
        const Vec3 &n = touch.normal, sum = *before + n;
        const double part = 1.0 / (1.0 + before->dot(n));
        derivative.force_by_position +=
            -normal.stiffness * turn(touch) * n.transpose() +
            normal.force * ((part - 1.0) * touch.curvature -
                            part * part * sum * (touch.curvature * *before).transpose());
    }
};

}  // namespace gxrod
