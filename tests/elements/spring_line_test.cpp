#include "elements/spring_line.hpp"

#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

TEST_CASE("a spring's length and rate follow the points that its nodes carry", "[elements]") {
    // B is carried around z at radius 2 from the origin; A is at (0, 1, 0).
    Spring spring;
    spring.ends = {Anchor{-1, Vec3(0.0, 1.0, 0.0)}, Anchor{0, Vec3(2.0, 0.0, 0.0)}};
    spring.stiffness = 3.0;
    spring.damping = 0.5;
    spring.length = 0.25;
    const double angle = 0.7;
    const double rate = 1.3;
    NodeMotion node;
    node.Lambda = exp_quaternion(Vec3(0.0, 0.0, angle));
    node.omega = Vec3(0.0, 0.0, rate);
    const SpringLine line = compute_spring_line(spring, std::vector{node});
    // ℓ² = 4 + 1 − 4 sin φ.
    const double length = std::sqrt(5.0 - 4.0 * std::sin(angle));
    CHECK(line.length == Approx(length).epsilon(1e-15));
    CHECK(line.length_rate == Approx(-2.0 * std::cos(angle) * rate / length).epsilon(1e-14));
    CHECK(line.direction.norm() == Approx(1.0).epsilon(1e-15));
    CHECK(compute_axial_force(spring, line) == Approx(3.0 * (length - 0.25) + 0.5 * line.length_rate));
}
