#include "loads/fluid_force.hpp"

#include <numbers>

#include "loads/drag.hpp"
#include "loads/wet_fraction.hpp"
#include "rotation/rotation_map.hpp"

// Equation numbers: docs/theory/surroundings.md. u is the velocity of a fluid relative to the node, b that of
// the water's acceleration.
namespace gxrod {
namespace {

WetFraction find_wet_fraction(const WetPoint& point, const FluidsAt& fluids, const NodeMotion& motion) {
    return compute_wet_fraction(fluids.water,
                                motion.r.z(),
                                point.axes.col(0),
                                point.piece_offset,
                                point.piece_length,
                                point.section->diameter);
}

Vec3 find_drag_factors(const SectionInFluid& section, double density) {
    const Vec3 widths(std::numbers::pi, 1.0, 1.0);
    return 0.5 * density * section.diameter * widths.cwiseProduct(section.drag);
}

// (S1)
Vec3 compute_drag(const WetPoint& point, double density, const Vec3& u) {
    const Vec3 factors = find_drag_factors(*point.section, density);
    return point.axes * compute_cross_flow_drag(factors, point.axes.transpose() * u);
}

double displaced_mass(const WetPoint& point, const FluidsAt& fluids) {
    return fluids.water_density * point.section->area;
}

Vec3 added_masses(const WetPoint& point, const FluidsAt& fluids) {
    return displaced_mass(point, fluids) * point.section->added_mass;
}

// (S1)–(S3), wholly in the water
Vec3 compute_water_force(const WetPoint& point, const FluidsAt& fluids, const NodeMotion& motion) {
    const WaterAt& water = *fluids.water;
    const Vec3 displaced = displaced_mass(point, fluids) * (water.acceleration - fluids.gravity);
    const Vec3 b = point.axes.transpose() * (water.acceleration - motion.a);
    return compute_drag(point, fluids.water_density, water.velocity - motion.v) + displaced +
           point.axes * added_masses(point, fluids).cwiseProduct(b);
}

Vec3 compute_air_force(const WetPoint& point, const FluidsAt& fluids, const NodeMotion& motion) {
    return compute_drag(point, fluids.air_density, fluids.air->velocity - motion.v);
}

// (S6)
void add_drag_derivative(const WetPoint& point,
                         double density,
                         const Vec3& u,
                         const Mat3& velocity_gradient,
                         double share,
                         FluidForceDerivative& derivative) {
    const Vec3 factors = find_drag_factors(*point.section, density);
    const Mat3 by_u = point.axes * compute_cross_flow_drag_derivative(factors, point.axes.transpose() * u) *
                      point.axes.transpose();
    derivative.by_r += share * by_u * velocity_gradient;
    derivative.by_phi += share * (by_u * spin(u) - spin(compute_drag(point, density, u)));
    derivative.by_v -= share * by_u;
}

// (S7)
void add_inertia_derivative(const WetPoint& point,
                            const FluidsAt& fluids,
                            const NodeMotion& motion,
                            double share,
                            FluidForceDerivative& derivative) {
    const Mat3 added = point.axes * added_masses(point, fluids).asDiagonal() * point.axes.transpose();
    const Vec3 b = fluids.water->acceleration - motion.a;
    const Mat3 mass = added + displaced_mass(point, fluids) * Mat3::Identity();
    derivative.by_r += share * mass * fluids.water->acceleration_gradient;
    derivative.by_phi += share * (added * spin(b) - spin(added * b));
    derivative.by_a -= share * added;
}

}  // namespace

FluidForce compute_fluid_force(const WetPoint& point, const FluidsAt& fluids, const NodeMotion& motion) {
    FluidForce result;
    const double wet = find_wet_fraction(point, fluids, motion).value;
    result.wet_fraction = wet;
    if (wet > 0.0) result.force += wet * compute_water_force(point, fluids, motion);
    if (fluids.air && wet < 1.0) result.force += (1.0 - wet) * compute_air_force(point, fluids, motion);
    return result;
}

FluidForceDerivative compute_fluid_force_derivative(const WetPoint& point,
                                                    const FluidsAt& fluids,
                                                    const NodeMotion& motion) {
    FluidForceDerivative derivative;
    const WetFraction wet = find_wet_fraction(point, fluids, motion);
    Vec3 by_wet = Vec3::Zero();
    if (wet.value > 0.0) {
        const WaterAt& water = *fluids.water;
        add_drag_derivative(point,
                            fluids.water_density,
                            water.velocity - motion.v,
                            water.velocity_gradient,
                            wet.value,
                            derivative);
        add_inertia_derivative(point, fluids, motion, wet.value, derivative);
        by_wet += compute_water_force(point, fluids, motion);
    }
    if (fluids.air && wet.value < 1.0) {
        const AirAt& air = *fluids.air;
        add_drag_derivative(point,
                            fluids.air_density,
                            air.velocity - motion.v,
                            air.velocity_gradient,
                            1.0 - wet.value,
                            derivative);
        by_wet -= compute_air_force(point, fluids, motion);
    }
    // (S8); the derivatives of the wet fraction are zero where it is 0 or 1
    derivative.by_r += by_wet * wet.by_place.transpose();
    derivative.by_phi += by_wet * wet.by_spin.transpose();
    return derivative;
}

}  // namespace gxrod
