#include "loads/drag.hpp"
#include "loads/fluid_force.hpp"
#include "loads/wet_fraction.hpp"
#include "rotation/rotation_map.hpp"

// Equation numbers: docs/theory/surroundings.md. d is the centre from the node, spatial; u and b are the
// velocity and the acceleration of a fluid relative to the centre.
namespace gxrod {
namespace {

using Mat36 = Eigen::Matrix<double, 3, 6>;
using Mat63 = Eigen::Matrix<double, 6, 3>;

// A body in fluids, and how its centre moves.
struct WetBody {
    const BodyInFluid& body;
    const Mat3& axes;
    const FluidsAt& fluids;
    const NodeMotion& motion;
    Vec3 d = axes * body.centre;
    WetFraction wet = compute_wet_fraction(fluids.water, motion.r.z() + d.z(), body.height);
    Vec3 velocity = motion.v + motion.omega.cross(d);
    Vec3 acceleration = motion.a + motion.alpha.cross(d) + motion.omega.cross(motion.omega.cross(d));

    bool is_in_air() const { return fluids.air && wet.value < 1.0; }
    Mat6 added_mass() const {
        Mat6 turn = Mat6::Zero();
        turn.topLeftCorner<3, 3>() = axes;
        turn.bottomRightCorner<3, 3>() = axes;
        return turn * body.added_mass * turn.transpose();
    }
    // (b, −α)
    Vec6 relative_accelerations() const {
        Vec6 relative;
        relative << fluids.water->acceleration - acceleration, -motion.alpha;
        return relative;
    }
};

// One of the fluids, as it passes the centre.
struct Passing {
    double density;
    Vec3 u;
    Mat3 velocity_gradient;
};

Passing pass_water(const WetBody& wet) {
    const WaterAt& water = *wet.fluids.water;
    return {wet.fluids.water_density, water.velocity - wet.velocity, water.velocity_gradient};
}

Passing pass_air(const WetBody& wet) {
    const AirAt& air = *wet.fluids.air;
    return {wet.fluids.air_density, air.velocity - wet.velocity, air.velocity_gradient};
}

Vec3 compute_drag(const WetBody& wet, const Passing& fluid) {
    const Vec3 factors = 0.5 * fluid.density * wet.body.drag_area;
    return wet.axes * compute_body_drag(factors, wet.axes.transpose() * fluid.u);
}

// (S10), about the centre and wholly in the water
Vec6 compute_water_force(const WetBody& wet) {
    Vec6 force = wet.added_mass() * wet.relative_accelerations();
    force.head<3>() +=
        wet.fluids.water_density * wet.body.volume * (wet.fluids.water->acceleration - wet.fluids.gravity) +
        compute_drag(wet, pass_water(wet));
    return force;
}

Vec6 compute_force_at_centre(const WetBody& wet) {
    Vec6 force = Vec6::Zero();
    const double share = wet.wet.value;
    if (share > 0.0) force += share * compute_water_force(wet);
    if (wet.is_in_air()) force.head<3>() += (1.0 - share) * compute_drag(wet, pass_air(wet));
    return force;
}

Mat36 beside(const Mat3& left, const Mat3& right) {
    Mat36 both;
    both << left, right;
    return both;
}

// How a vector at the centre follows the node.
struct Following {
    Mat36 by_place;          // (δr, δφ)
    Mat36 by_rates;          // (v, ω)
    Mat36 by_accelerations;  // (a, α)
};

Mat36 follow_place(const WetBody& wet) { return beside(Mat3::Identity(), -spin(wet.d)); }

Following follow_velocity(const WetBody& wet) {
    return {beside(Mat3::Zero(), -spin(wet.motion.omega) * spin(wet.d)), follow_place(wet), Mat36::Zero()};
}

Following follow_acceleration(const WetBody& wet) {
    const Mat3 omega = spin(wet.motion.omega);
    const Mat3 d = spin(wet.d);
    return {beside(Mat3::Zero(), -(spin(wet.motion.alpha) + omega * omega) * d),
            beside(Mat3::Zero(), -spin(wet.motion.omega.cross(wet.d)) - omega * d),
            follow_place(wet)};
}

void add_drag_derivative(const WetBody& wet,
                         const Passing& fluid,
                         double share,
                         BodyFluidDerivative& derivative) {
    const Vec3 factors = 0.5 * share * fluid.density * wet.body.drag_area;
    const Mat3 by_u = wet.axes * compute_body_drag_derivative(factors, wet.axes.transpose() * fluid.u) *
                      wet.axes.transpose();
    const Following velocity = follow_velocity(wet);
    derivative.by_place.topRows<3>() +=
        by_u * (fluid.velocity_gradient * follow_place(wet) - velocity.by_place);
    derivative.by_place.topRightCorner<3, 3>() +=
        by_u * spin(fluid.u) - share * spin(compute_drag(wet, fluid));
    derivative.by_rates.topRows<3>() -= by_u * velocity.by_rates;
}

Mat63 spin_both(const Vec6& both) {
    Mat63 spins;
    spins << spin(both.head<3>()), spin(both.tail<3>());
    return spins;
}

void add_inertia_derivative(const WetBody& wet, BodyFluidDerivative& derivative) {
    const double share = wet.wet.value;
    const Mat6 added = share * wet.added_mass();
    const Vec6 b = wet.relative_accelerations();
    const Mat36 water = wet.fluids.water->acceleration_gradient * follow_place(wet);
    const Following acceleration = follow_acceleration(wet);
    derivative.by_place += added.leftCols<3>() * (water - acceleration.by_place);
    derivative.by_place.topRows<3>() += share * wet.fluids.water_density * wet.body.volume * water;
    derivative.by_place.rightCols<3>() += added * spin_both(b) - spin_both(added * b);
    derivative.by_rates -= added.leftCols<3>() * acceleration.by_rates;
    derivative.by_accelerations -= added.leftCols<3>() * acceleration.by_accelerations;
    derivative.by_accelerations.rightCols<3>() -= added.rightCols<3>();
}

BodyFluidDerivative compute_derivative_at_centre(const WetBody& wet) {
    BodyFluidDerivative derivative;
    Vec6 by_wet = Vec6::Zero();
    const double share = wet.wet.value;
    if (share > 0.0) {
        add_drag_derivative(wet, pass_water(wet), share, derivative);
        add_inertia_derivative(wet, derivative);
        by_wet += compute_water_force(wet);
    }
    if (wet.is_in_air()) {
        add_drag_derivative(wet, pass_air(wet), 1.0 - share, derivative);
        by_wet.head<3>() -= compute_drag(wet, pass_air(wet));
    }
    derivative.by_place += by_wet * (wet.wet.by_place.transpose() * follow_place(wet));
    return derivative;
}

// Takes force and moment about the centre to those about the node.
Mat6 move_to_node(const WetBody& wet) {
    Mat6 move = Mat6::Identity();
    move.bottomLeftCorner<3, 3>() = spin(wet.d);
    return move;
}

}  // namespace

BodyFluidForce compute_body_fluid_force(const BodyInFluid& body,
                                        const Mat3& axes,
                                        const FluidsAt& fluids,
                                        const NodeMotion& motion) {
    const WetBody wet{body, axes, fluids, motion};
    return {move_to_node(wet) * compute_force_at_centre(wet), wet.wet.value};
}

// (S11)
BodyFluidDerivative compute_body_fluid_derivative(const BodyInFluid& body,
                                                  const Mat3& axes,
                                                  const FluidsAt& fluids,
                                                  const NodeMotion& motion) {
    const WetBody wet{body, axes, fluids, motion};
    BodyFluidDerivative derivative = compute_derivative_at_centre(wet);
    const Mat6 move = move_to_node(wet);
    derivative.by_place = move * derivative.by_place;
    derivative.by_rates = move * derivative.by_rates;
    derivative.by_accelerations = move * derivative.by_accelerations;
    const Vec3 force = compute_force_at_centre(wet).head<3>();
    derivative.by_place.bottomRightCorner<3, 3>() += spin(force) * spin(wet.d);
    return derivative;
}

}  // namespace gxrod
