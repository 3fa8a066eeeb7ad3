#include "verification/rubin2007_problem.hpp"

#include <cmath>
#include <numbers>

namespace gxrod::rubin2007 {

const double tilt = std::numbers::pi / 3.0;
const double period = 2.0 * std::numbers::pi;

namespace {

Mat3 rotation_about(const Vec3& axis, double angle) {
    return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

// sin²θ₀/I₁ + cos²θ₀/I₃
double compliance() {
    return std::sin(tilt) * std::sin(tilt) / inertia_1 + std::cos(tilt) * std::cos(tilt) / inertia_3;
}

}  // namespace

Vec3 moment(double time) { return 0.5 * momentum_scale * std::sin(time) * Vec3::UnitZ(); }

Mat3 exact_rotation(double time) {
    const double psi = momentum_scale / (2.0 * inertia_1) * (time - std::sin(time));
    const double beta = (inertia_1 / inertia_3 - 1.0) * std::cos(tilt) * psi;
    return rotation_about(Vec3::UnitZ(), psi) * rotation_about(Vec3::UnitY(), tilt) *
           rotation_about(Vec3::UnitZ(), beta);
}

Vec3 exact_momentum(double time) { return 0.5 * momentum_scale * (1.0 - std::cos(time)) * Vec3::UnitZ(); }

double exact_kinetic_energy(double time) {
    const double versine = 1.0 - std::cos(time);
    return 0.125 * momentum_scale * momentum_scale * compliance() * versine * versine;
}

Vec3 exact_angular_velocity(double time) {
    const Mat3 Lambda = exact_rotation(time);
    const Vec3 inverse_inertia(1.0 / inertia_1, 1.0 / inertia_1, 1.0 / inertia_3);
    return Lambda * inverse_inertia.asDiagonal() * Lambda.transpose() * exact_momentum(time);
}

Model make_model() {
    Model model;
    model.nodes.push_back({"body", Vec3::Zero()});
    Body body;
    body.name = "body";
    body.mass = 1.0;
    body.inertia = Vec3(inertia_1, inertia_1, inertia_3).asDiagonal();
    body.attitude = Quat(Eigen::AngleAxisd(tilt, Vec3::UnitY()));
    model.bodies.push_back(body);
    NodalLoad load;
    load.key = "load[0]";
    load.moment[2] = TimeFunction([](double time) { return moment(time).z(); });
    model.loads.push_back(load);
    return model;
}

Errors compute_errors(double time, const Mat3& rotation, const Vec3& momentum, double kinetic_energy) {
    const double energy_scale = 0.5 * momentum_scale * momentum_scale * compliance();
    return {(rotation - exact_rotation(time)).norm(),
            (momentum - exact_momentum(time)).norm() / momentum_scale,
            std::abs(kinetic_energy - exact_kinetic_energy(time)) / energy_scale};
}

}  // namespace gxrod::rubin2007
