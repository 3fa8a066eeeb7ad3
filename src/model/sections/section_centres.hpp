#pragma once

#include <optional>

#include "rotation/types.hpp"

// Where a section would carry its forces without coupling, and in which axes. Points are (y, z) from the
// node, in the section's axes.
namespace gxrod {

using SectionPoint = Eigen::Vector2d;

// Two stiffnesses or inertias about axes that are y and z turned about x, right-handed, by at most 45°.
struct PrincipalAxes {
    double turn = 0.0;  // radians; 0 where both are equal
    double about_y = 0.0, about_z = 0.0;
};

class SectionCentres {
  public:
    // Of a stiffness that is positive definite, order x y z rx ry rz, and of the inertia of a rigid slice,
    // which may be zero.
    SectionCentres(const Mat6& stiffness, const Mat6& mass);

    // Where a force along x makes no bending: the curvatures about y and z are 0.
    const SectionPoint& tension_centre() const { return tension_centre_; }
    // Where forces along y and z make no twist.
    const SectionPoint& shear_centre() const { return shear_centre_; }
    // nullopt without inertia.
    const std::optional<SectionPoint>& centre_of_mass() const { return centre_of_mass_; }
    // Moment by curvature where no force acts and no torque, whatever couples: about the tension centre.
    const PrincipalAxes& bending() const { return bending_; }
    // Rotary inertia per length about the centre of mass; nullopt without inertia.
    const std::optional<PrincipalAxes>& inertia() const { return inertia_; }
    // A length of the section, which its offsets can be compared with: the larger radius √(EI/EA).
    double size() const { return size_; }
    // A point whose components are zero where they are round-off compared with the size.
    SectionPoint clean(const SectionPoint& point) const;
    // Whether one of them is away from the node, or the axes of bending are turned.
    bool are_apart() const;

  private:
    SectionPoint tension_centre_, shear_centre_;
    std::optional<SectionPoint> centre_of_mass_;
    PrincipalAxes bending_;
    std::optional<PrincipalAxes> inertia_;
    double size_ = 0.0;
};

}  // namespace gxrod
