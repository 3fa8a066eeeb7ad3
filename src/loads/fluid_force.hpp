#pragma once

#include <optional>

#include "environment/fluid_field.hpp"
#include "state/motion.hpp"

// Forces of water and air on rods and bodies (docs/theory/surroundings.md).
namespace gxrod {

// A node of an element of a rod in a fluid.
struct WetPoint {
    const SectionInFluid* section = nullptr;
    Mat3 axes = Mat3::Identity();  // Λ: columns are the section's x, y, z now
    // The piece of the element that belongs to the node: its length, and the distance of its middle from the
    // node along the section's x. It is wet up to the surface.
    double piece_length = 0.0;
    double piece_offset = 0.0;
};

// The fluids around a place. Without water, or without air, they exert no force.
struct FluidsAt {
    double water_density = 0.0;
    const WaterAt* water = nullptr;
    double air_density = 0.0;
    const AirAt* air = nullptr;
    Vec3 gravity = Vec3::Zero();
};

// A force per length, and its derivatives by the motion of its node.
struct FluidForce {
    Vec3 force = Vec3::Zero();
    double wet_fraction = 0.0;
};
struct FluidForceDerivative {
    Mat3 by_r = Mat3::Zero();    // the place, with all fields there
    Mat3 by_phi = Mat3::Zero();  // the spatial spin
    Mat3 by_v = Mat3::Zero();
    Mat3 by_a = Mat3::Zero();
};

FluidForce compute_fluid_force(const WetPoint& point, const FluidsAt& fluids, const NodeMotion& motion);
FluidForceDerivative compute_fluid_force_derivative(const WetPoint& point,
                                                    const FluidsAt& fluids,
                                                    const NodeMotion& motion);

// Force and moment on a body's node, spatial; `axes` are the body's present axes. The fluids are evaluated at
// the centre.
struct BodyFluidForce {
    Vec6 force = Vec6::Zero();
    double wet_fraction = 0.0;
};
struct BodyFluidDerivative {
    Mat6 by_place = Mat6::Zero();          // (δr, δφ)
    Mat6 by_rates = Mat6::Zero();          // (v, ω)
    Mat6 by_accelerations = Mat6::Zero();  // (a, α)
};
BodyFluidForce compute_body_fluid_force(const BodyInFluid& body,
                                        const Mat3& axes,
                                        const FluidsAt& fluids,
                                        const NodeMotion& motion);
BodyFluidDerivative compute_body_fluid_derivative(const BodyInFluid& body,
                                                  const Mat3& axes,
                                                  const FluidsAt& fluids,
                                                  const NodeMotion& motion);

}  // namespace gxrod
