#pragma once

#include <optional>

#include "contact/place_force.hpp"

namespace gxrod {

// The direction n̂ of the impulse of a place, for which n̂ · Δx is the change of the gap: on spheres and
// cylinders by the normals at both ends of a step, (C18), or a part of the change where they turn by more
// than a right angle; on meshes by the mean gradient, and what it lacks along Δx, (C19).
struct ImpulseDirection {
    // Of meshes, at rest.
    struct Way {
        Vec3 gradient;          // of the gap at the start
        Vec3 move;              // Δx
        double change = 0.0;    // of the gap
        double shortest = 0.0;  // of moves for which the mean gradient is good enough
    };
    std::optional<Vec3> before = {};  // the normal at the start; none where that at the end is taken
    std::optional<Way> way = {};

    // n̂ less the gradient at the end.
    Vec3 turn(const SurfaceTouch& touch) const {
        if (way) return mean(touch) + lack(touch) * way->move - touch.slope * touch.normal;
        const double cosine = before->dot(touch.normal);
        if (cosine <= 0.0) return *before;
        return (*before - cosine * touch.normal) / (1.0 + cosine);
    }
    void add_to(const SurfaceTouch& touch, const NormalForce& normal, PlaceForce& force) const {
        if (before || way) force.force += normal.force * turn(touch);
    }
    void add_to(const SurfaceTouch& touch,
                const NormalForce& normal,
                PlaceForceDerivative& derivative) const {
        if (!before && !way) return;
        const Vec3 gradient = touch.slope * touch.normal;
        derivative.force_by_position -= normal.stiffness * turn(touch) * gradient.transpose();
        derivative.force_by_position += normal.force * (way ? turn_by_position(touch) : bisector_by(touch));
    }

  private:
    Vec3 mean(const SurfaceTouch& touch) const { return 0.5 * (way->gradient + touch.slope * touch.normal); }
    double square() const { return way->move.squaredNorm() + way->shortest * way->shortest; }
    double lack(const SurfaceTouch& touch) const {
        return (way->change - mean(touch).dot(way->move)) / square();
    }
    Mat3 turn_by_position(const SurfaceTouch& touch) const {
        const Vec3& move = way->move;
        const Vec3 lack_by = touch.slope * touch.normal - mean(touch) - 0.5 * touch.curvature * move;
        const double lacking = lack(touch);
        return -0.5 * touch.curvature + move * (lack_by - 2.0 * lacking * move).transpose() / square() +
               lacking * Mat3::Identity();
    }
    Mat3 bisector_by(const SurfaceTouch& touch) const {
        const double cosine = before->dot(touch.normal);
        if (cosine <= 0.0) return Mat3::Zero();
        const Vec3 sum = *before + touch.normal;
        const double part = 1.0 / (1.0 + cosine);
        return (part - 1.0) * touch.curvature - part * part * sum * (touch.curvature * *before).transpose();
    }
};

}  // namespace gxrod
