#include "tools/tops.hpp"

#include "rotation/rotation_map.hpp"

namespace gxrod::tools {

Model make_free_body(const Vec3& inertia, const Vec3& angular_velocity) {
    Model model;
    model.nodes.push_back({"body", Vec3::Zero(), Vec3::Zero(), angular_velocity});
    Body body;
    body.name = "body";
    body.mass = 1.0;
    body.inertia = inertia.asDiagonal();
    model.bodies.push_back(body);
    return model;
}

namespace {

Model make_top(const Body& body, double gravity, const Vec3& angular_velocity) {
    Model model;
    model.gravity = Vec3(0.0, 0.0, -gravity);
    model.nodes.push_back({"top", Vec3::Zero(), Vec3::Zero(), angular_velocity});
    model.bodies.push_back(body);
    model.supports.push_back({0, {true, true, true, false, false, false}});
    return model;
}

}  // namespace

namespace heavy_top {

Model make_model() {
    Body body;
    body.name = "top";
    body.mass = 15.0;
    body.inertia = Vec3(0.234375, 0.46875, 0.234375).asDiagonal();
    body.centre_of_mass = Vec3::UnitY();
    return make_top(body, 9.81, Vec3(0.0, 150.0, -4.61538));
}

Vec3 centre_of_mass(const Quat& Lambda) { return Lambda * Vec3::UnitY(); }

const std::vector<Reference>& references() {
    static const std::vector<Reference> table{
        {0.2, {0.605550561377, 0.598957681795, -0.523983027430}},
        {1.0, {0.173343964098, 0.640088592070, -0.748490791134}},
        {2.0, {-0.150416822746, -0.724165591637, -0.673022269560}},
    };
    return table;
}

Quat reference_rotation() { return {0.122947135042, -0.491079892551, 0.350430030343, -0.787986887550}; }

}  // namespace heavy_top

namespace fast_top {

Model make_model() {
    constexpr double tilt = 0.3;
    Body body;
    body.name = "top";
    body.mass = 1.0;
    body.inertia = Vec3(4.0, 4.0, 1.0).asDiagonal();
    body.centre_of_mass = Vec3::UnitZ();
    body.attitude = exp_quaternion(tilt * Vec3::UnitX());
    return make_top(body, 20.0, Vec3(0.0, -50.0 * std::sin(tilt), 50.0 * std::cos(tilt)));
}

Vec3 axis(const Quat& Lambda) { return Lambda * exp_quaternion(0.3 * Vec3::UnitX()) * Vec3::UnitZ(); }

Vec3 reference_axis_1() { return {0.127091429919, -0.294409779767, 0.947190925853}; }
Vec3 reference_axis_10() { return {-0.274864608390, 0.154741521011, 0.948949160245}; }

}  // namespace fast_top

}  // namespace gxrod::tools
