#pragma once

#include <optional>

#include "rotation/types.hpp"

// The centres at which a section carries its forces without coupling, and its principal axes. Points are (y,
// z) from the node, in the section's axes.
namespace gxrod {

using SectionPoint = Eigen::Vector2d;

// Two principal stiffnesses or inertias about the axes y and z turned about x, right-handed, by at most 45°.
struct PrincipalAxes {
    double turn = 0.0;  // radians; 0 if both are equal
    double about_y = 0.0, about_z = 0.0;
};

class SectionCentres {
  public:
    // Takes a positive definite stiffness, order x y z rx ry rz, and the inertia of a rigid slice, which may
    // be zero.
    SectionCentres(const Mat6& stiffness, const Mat6& mass);

    // The point at which a force along x causes no bending: the curvatures about y and z are 0.
    const SectionPoint& tension_centre() const { return tension_centre_; }
    // The point at which forces along y and z cause no twist.
    const SectionPoint& shear_centre() const { return shear_centre_; }
    // The centre of mass; nullopt without inertia.
    const std::optional<SectionPoint>& centre_of_mass() const { return centre_of_mass_; }
    // Moment by curvature without force and torque, including all couplings: about the tension centre.
    const PrincipalAxes& bending() const { return bending_; }
    // Rotary inertia per length about the centre of mass; nullopt without inertia.
    const std::optional<PrincipalAxes>& inertia() const { return inertia_; }
    // A length of the section for comparison with its offsets: the larger radius √(EI/EA).
    double size() const { return size_; }
    // Returns a point with components set to zero that are round-off compared with the size.
    SectionPoint clean(const SectionPoint& point) const;
    // Whether a centre is away from the node, or the axes of bending are turned.
    bool are_apart() const;

  private:
    SectionPoint tension_centre_, shear_centre_;
    std::optional<SectionPoint> centre_of_mass_;
    PrincipalAxes bending_;
    std::optional<PrincipalAxes> inertia_;
    double size_ = 0.0;
};

}  // namespace gxrod
