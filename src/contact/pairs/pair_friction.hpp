#pragma once

#include <array>

#include "contact/pairs/pair_energy.hpp"
#include "contact/traction.hpp"

// Friction of two touching straight parts of round rods (docs/theory/contact.md, (C12)). All forces of the
// pair act between one place on each line, x and y: the means of the normal forces. With d = x − y, the radii
// r and r′, and the weighted rotation since the last accepted step Ω = (r θ + r′ θ′)/(r + r′), the surfaces
// slip by d − exp(Ω) d_n, with d_n of the same two places then. So nothing slips if both rods turn together,
// or if one rolls on the other. The traction t acts on a, −t on b, at the point that divides d by the radii:
// the sum of the moments is zero.
namespace gxrod {

using Vec24 = Eigen::Matrix<double, 24, 1>;
using Mat24 = Eigen::Matrix<double, 24, 24>;

// Returns forces on the ends as forces and moments there.
inline Vec24 with_moments(const Vec12& forces) {
    Vec24 both = Vec24::Zero();
    for (int end = 0; end < 4; ++end) both.segment<3>(6 * end) = forces.segment<3>(3 * end);
    return both;
}

// The motions of both ends of both parts, in the order of PairEnergy.
struct PairMotion {
    std::array<Vec3, 4> positions;
    std::array<Vec3, 4> positions_before;  // at the last accepted step
    std::array<Vec3, 4> rotations;         // since then, rotation vectors
    double radius_a = 0.0, radius_b = 0.0;
};

// The place and size of the normal force.
struct PairPlace {
    double s = 0.5, t = 0.5;  // parameters on a and on b
    Vec3 normal = Vec3::Zero();
    double force = 0.0;
};
// Finds the place from the forces on the ends; without a force, the closest points.
PairPlace find_pair_place(const PairEnergy& energy, const PairMotion& motion);

struct PairFriction {
    Vec24 forces = Vec24::Zero();  // force and moment at each end
    Traction traction;             // traction on a
    Vec3 slip = Vec3::Zero();
    Vec3 traction_before = Vec3::Zero();  // traction of the last accepted step, turned with the rods
};
PairFriction compute_pair_friction(const PairEnergy& energy,
                                   const PairMotion& motion,
                                   const CoulombFriction& friction);

// Computes the derivative of these forces by position and rotation vector of each end.
Mat24 compute_pair_friction_derivative(const PairEnergy& energy,
                                       const PairMotion& motion,
                                       const CoulombFriction& friction);

// Increments of positions and rotation vectors of the ends.
struct PairIncrement {
    std::array<Vec3, 4> displacements{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    std::array<Vec3, 4> turns = displacements;
};

// Applies decide_slip() after this increment.
CoulombFriction advance_pair_slip(const PairEnergy& energy,
                                  const PairMotion& motion,
                                  const PairIncrement& increment,
                                  const CoulombFriction& friction);

}  // namespace gxrod
