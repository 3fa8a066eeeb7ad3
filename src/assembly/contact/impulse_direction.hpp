#pragma once

#include <algorithm>
#include <optional>

#include "contact/place_force.hpp"

namespace gxrod {

// The direction n̂ of a place's impulse, for which n̂ · Δx is the change of the gap. On spheres and cylinders
// it comes from the normals at both ends of a step, (C18), with a part of the change if they turn by more
// than a right angle; on meshes from the mean gradient plus its error along Δx, (C19).
struct ImpulseDirection {
    // The motion of a place, for obstacles at rest.
    struct Way {
        Vec3 gradient;          // gradient of the gap at the start
        Vec3 move;              // Δx
        double change = 0.0;    // change of the gap
        double shortest = 0.0;  // length of moves below which n̂ needs no correction
    };
    std::optional<Vec3> before = {};  // the normal at the start, for (C18)
    std::optional<Way> way = {};      // for (C19); for (C18) it limits the work to that of the change

    // Returns n̂ less the gradient at the end.
    Vec3 turn(const SurfaceTouch& touch) const {
        const Vec3 gradient = touch.slope * touch.normal;
        if (!before) return mean(touch) + lack(mean(touch)) * way->move - gradient;
        const Vec3 between = bisector(touch);
        return between + excess(between) - gradient;
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
        derivative.force_by_position += normal.force * turn_by_position(touch);
    }

  private:
    static constexpr double most = 0.9;  // largest part of n̂ that is taken off
    Vec3 mean(const SurfaceTouch& touch) const { return 0.5 * (way->gradient + touch.slope * touch.normal); }
    Vec3 bisector(const SurfaceTouch& touch) const {
        const double cosine = before->dot(touch.normal);
        return (*before + touch.normal) / (1.0 + std::max(cosine, 0.0));
    }
    double square() const { return way->move.squaredNorm() + way->shortest * way->shortest; }
    double lack(const Vec3& direction) const { return (way->change - direction.dot(way->move)) / square(); }
    // Returns the correction for work above that of the change, as in (C21).
    Vec3 excess(const Vec3& direction) const {
        if (!way) return Vec3::Zero();
        const double lacking = std::min(lack(direction), 0.0), length = way->move.norm();
        return -lacking * length < most ? Vec3(lacking * way->move) : Vec3(-most / length * way->move);
    }
    // Returns the derivative of n̂ with lack(n̂) added along the move.
    Mat3 lack_by(const SurfaceTouch& touch, const Vec3& direction, const Mat3& direction_by) const {
        const Vec3& move = way->move;
        const double lacking = lack(direction);
        const Vec3 by = touch.slope * touch.normal - direction - direction_by.transpose() * move;
        return move * (by - 2.0 * lacking * move).transpose() / square() + lacking * Mat3::Identity();
    }
    Mat3 turn_by_position(const SurfaceTouch& touch) const {
        if (!before) return -0.5 * touch.curvature + lack_by(touch, mean(touch), 0.5 * touch.curvature);
        const Mat3 between_by = bisector_by(touch);
        return between_by - touch.curvature + excess_by(touch, bisector(touch), between_by);
    }
    Mat3 bisector_by(const SurfaceTouch& touch) const {
        const double cosine = before->dot(touch.normal);
        if (cosine <= 0.0) return touch.curvature;
        const Vec3 sum = *before + touch.normal;
        const double part = 1.0 / (1.0 + cosine);
        return part * touch.curvature - part * part * sum * (touch.curvature * *before).transpose();
    }
    Mat3 excess_by(const SurfaceTouch& touch, const Vec3& direction, const Mat3& direction_by) const {
        if (!way) return Mat3::Zero();
        const double lacking = lack(direction), length = way->move.norm();
        if (lacking >= 0.0) return Mat3::Zero();
        if (-lacking * length < most) return lack_by(touch, direction, direction_by);
        const Vec3 along = way->move / length;
        return -most / length * (Mat3::Identity() - along * along.transpose());
    }
};

}  // namespace gxrod
