#include "elements/rod/rod_section.hpp"

#include "rotation/rotation_map.hpp"

namespace gxrod {

namespace {

// The mass matrix has −ρA [d]× for its coupling.
Vec3 compute_offset(const Section& section) {
    const double rho_A = section.mass(0, 0);
    if (rho_A == 0.0) return Vec3::Zero();
    return -axial(section.mass.topRightCorner<3, 3>()) / rho_A;
}

Mat3 compute_rotary_inertia(const Section& section, const Vec3& offset) {
    const Mat3 spin_d = spin(offset);
    return section.mass.bottomRightCorner<3, 3>() + section.mass(0, 0) * spin_d * spin_d;
}

}  // namespace

RodSection::RodSection(const Section& section, bool resists_acceleration)
    : stiffness(section.stiffness),
      kelvin_voigt(section.kelvin_voigt),
      mass_proportional(section.mass_proportional),
      mass(section.mass(0, 0)),
      centre_of_mass(compute_offset(section)),
      rotary_inertia(compute_rotary_inertia(section, centre_of_mass)),
      has_inertia(resists_acceleration),
      law(section.law) {
    if (section.kelvin_voigt_components) damping_roots = section.kelvin_voigt_components->cwiseSqrt();
}

Vec6 RodSection::compute_viscous_resultants(const Vec6& rates) const {
    if (!damping_roots) return kelvin_voigt * (stiffness * rates);
    return damping_roots->cwiseProduct(stiffness * damping_roots->cwiseProduct(rates));
}

Mat6 RodSection::compute_viscosity() const {
    if (!damping_roots) return kelvin_voigt * stiffness;
    return damping_roots->asDiagonal() * stiffness * damping_roots->asDiagonal();
}

}  // namespace gxrod
