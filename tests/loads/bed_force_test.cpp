#include "loads/bed_force.hpp"

#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

Seabed level_bed() {
    Seabed bed;
    bed.stiffness = 50.0;
    bed.axial_friction = 0.3;
    bed.lateral_friction = 0.8;
    bed.friction_stiffness = 20.0;
    return bed;
}

Seabed sloping_bed() {
    Seabed bed = level_bed();
    bed.normal = Vec3(0.2, -0.3, 1.0).normalized();
    return bed;
}

// Of one cell, curved as a saddle.
Seabed curved_bed() {
    Seabed bed = level_bed();
    bed.grid = GroundGrid{{-5.0, 5.0}, {-4.0, 6.0}, {0.0, 1.0, 2.0, -1.5}};
    return bed;
}

BedPoint piece_of_rod(const Vec3& axis = Vec3::UnitX()) { return {0.1, 0.4, axis}; }

BedPoint a_body() { return {.radius = 0.1, .area = 0.4}; }

NodeMotion at(const Vec3& r, const Vec3& v = Vec3::Zero()) {
    NodeMotion motion;
    motion.r = r;
    motion.v = v;
    return motion;
}

// In the worst of its three parts.
double tangent_error(const Seabed& bed,
                     const BedPoint& point,
                     const NodeMotion& motion,
                     const BedContact& before) {
    const BedForceDerivative tangent = compute_bed_force_derivative(bed, point, motion, before);
    BedForceDerivative expected;
    for (int i = 0; i < 3; ++i) {
        const auto along = [&](auto&& change) {
            return differentiate(
                [&](double amount) {
                    BedPoint changed = point;
                    NodeMotion moved = motion;
                    change(changed, moved, amount * Vec3::Unit(i));
                    return compute_bed_force(bed, changed, moved, before).force;
                },
                1e-5);
        };
        expected.by_r.col(i) = along([](BedPoint&, NodeMotion& m, const Vec3& d) { m.r += d; });
        expected.by_phi.col(i) =
            along([](BedPoint& p, NodeMotion&, const Vec3& d) { p.axis = exp_matrix(d) * p.axis; });
        expected.by_v.col(i) = along([](BedPoint&, NodeMotion& m, const Vec3& d) { m.v += d; });
    }
    const double scale = expected.by_r.norm();
    return std::max({(tangent.by_r - expected.by_r).norm(),
                     (tangent.by_phi - expected.by_phi).norm(),
                     (tangent.by_v - expected.by_v).norm()}) /
           scale;
}

enum class FrictionState { stick, slip };

FrictionState friction_of(const BedForce& force, const BedContact& before) {
    return force.after.target == before.target ? FrictionState::stick : FrictionState::slip;
}

}  // namespace

TEST_CASE("the ground presses by its stiffness on what is in it", "[loads]") {
    const Seabed bed = level_bed();
    const BedForce force = compute_bed_force(bed, piece_of_rod(), at({3.0, 2.0, 0.04}), {});
    const double expected = 50.0 * 0.4 * (0.1 - 0.04);
    CHECK(std::abs(force.pressure - expected) < 1e-14);
    CHECK((force.force - expected * Vec3::UnitZ()).norm() < 1e-14);
    CHECK(force.after.touches);
    CHECK(force.after.target == Vec3(3.0, 2.0, 0.04));
}

TEST_CASE("what does not touch the ground feels and remembers nothing", "[loads]") {
    const BedContact before{true, Vec3(1.0, 2.0, 3.0)};
    const BedForce force = compute_bed_force(level_bed(), piece_of_rod(), at({3.0, 2.0, 0.11}), before);
    CHECK(force.force.isZero(0.0));
    CHECK(!force.after.touches);
    CHECK(force.after.target.isZero(0.0));
}

TEST_CASE("the ground's damper brakes what sinks in and never pulls", "[loads]") {
    Seabed bed = level_bed();
    bed.damping = 6.0;
    const auto pressure = [&](double speed, double height = 0.0) {
        const NodeMotion motion = at({0.0, 0.0, height}, {9.0, 0.0, speed});
        return compute_bed_force(bed, piece_of_rod(), motion, {}).pressure;
    };
    const double still = 50.0 * 0.4 * 0.1;
    CHECK(std::abs(pressure(-0.5) - (still + 6.0 * 0.4 * 0.5)) < 1e-14);
    CHECK(std::abs(pressure(0.5) - (still - 6.0 * 0.4 * 0.5)) < 1e-14);
    CHECK(pressure(5.0) == 0.0);
    CHECK(std::abs(pressure(-5.0) - 2.0 * still) < 1e-14);
    // No jump where it starts to touch
    CHECK(pressure(-5.0, 0.1 - 1e-9) < 1e-7);
    CHECK(pressure(-9.0, 0.2) == 0.0);
}

TEST_CASE("friction with the ground is elastic, then Coulomb's along and across the rod", "[loads]") {
    const Seabed bed = level_bed();
    const double depth = 0.08;
    const double pressure = 50.0 * 0.4 * depth;
    const BedContact before{true, Vec3(1.0, 2.0, 0.0)};
    const auto friction = [&](const BedPoint& point, const Vec3& move) {
        const Vec3 r = before.target + move + Vec3(0.0, 0.0, 0.1 - depth);
        Vec3 force = compute_bed_force(bed, point, at(r), before).force;
        CHECK(std::abs(force.z() - pressure) < 1e-14);
        force.z() = 0.0;
        return force;
    };
    const Vec3 x = Vec3::UnitX();
    const Vec3 y = Vec3::UnitY();
    // 20 · 0.4 a length; 1.6 pressed
    CHECK((friction(piece_of_rod(), 0.01 * x + 0.02 * y) + 0.08 * x + 0.16 * y).norm() < 1e-13);
    CHECK((friction(piece_of_rod(), 3.0 * x) + 0.3 * pressure * x).norm() < 1e-13);
    CHECK((friction(piece_of_rod(), -3.0 * y) - 0.8 * pressure * y).norm() < 1e-13);
    CHECK((friction(a_body(), 3.0 * x) + 0.8 * pressure * x).norm() < 1e-13);
    const Vec3 both = friction(piece_of_rod(), 3.0 * x + 2.0 * y) / pressure;
    CHECK(std::abs(std::hypot(both.x() / 0.3, both.y() / 0.8) - 1.0) < 1e-13);
    CHECK(std::abs(both.y() / both.x() - 2.0 / 3.0) < 1e-13);
    // An inclined rod: along its projection
    CHECK((friction(piece_of_rod(Vec3(0.0, 0.999, std::sqrt(1.0 - 0.999 * 0.999))), 3.0 * x) +
           0.8 * pressure * x)
              .norm() < 1e-13);
}

TEST_CASE("a rod that stands on the ground has no direction along it", "[loads]") {
    const BedContact before{true, Vec3::Zero()};
    const auto friction = [&](const BedPoint& point) {
        return compute_bed_force(level_bed(), point, at({2.0, 1.0, 0.0}), before).force;
    };
    CHECK((friction(piece_of_rod(Vec3::UnitZ())) - friction(a_body())).norm() < 1e-14);
}

TEST_CASE("the target of friction follows what slips and stays with what sticks", "[loads]") {
    RandomValues random(3);
    for (const Seabed& bed : {level_bed(), sloping_bed(), curved_bed()}) {
        for (int i = 0; i < 100; ++i) {
            const BedPoint point = piece_of_rod(random.direction());
            const Vec3 r(random.number(-1, 1), random.number(-1, 1), -1.5);
            const BedContact before{true, r + 0.3 * random.vector()};
            const BedForce force = compute_bed_force(bed, point, at(r), before);
            const BedForce again = compute_bed_force(bed, point, at(r), force.after);
            CHECK((again.force - force.force).norm() < 1e-12 * force.force.norm());
            CHECK(force.after.touches);
        }
    }
}

TEST_CASE("the tangent of the ground's force is its derivative", "[loads]") {
    RandomValues random(4);
    int sticks = 0, slips = 0;
    Seabed along = curved_bed();
    along.lateral_friction = 0.0;
    Seabed across = curved_bed();
    across.axial_friction = 0.0;
    for (Seabed bed : {level_bed(), sloping_bed(), curved_bed(), along, across}) {
        for (int i = 0; i < 200; ++i) {
            bed.damping = i % 2 == 0 ? 0.5 : 200.0;  // within its limits, and at them
            const BedPoint point = i % 3 == 0 ? a_body() : piece_of_rod(random.direction());
            const NodeMotion motion = at({random.number(-1, 1), random.number(-1, 1), -0.9}, random.vector());
            const BedContact before{true, motion.r + random.number(0.02, 2.0) * random.vector()};
            const BedForce force = compute_bed_force(bed, point, motion, before);
            if (!force.after.touches || force.pressure < 0.1) continue;
            (friction_of(force, before) == FrictionState::stick ? sticks : slips) += 1;
            CHECK(tangent_error(bed, point, motion, before) < 1e-8);
        }
    }
    CHECK(sticks > 50);
    CHECK(slips > 50);
}

TEST_CASE("the tangent of the ground's force holds for what starts to touch", "[loads]") {
    RandomValues random(5);
    for (const Seabed& bed : {level_bed(), sloping_bed(), curved_bed()}) {
        const BedPoint point = piece_of_rod(random.direction());
        CHECK(tangent_error(bed, point, at({0.2, 0.1, -1.5}), {}) < 1e-8);
        CHECK(compute_bed_force_derivative(bed, point, at({0.2, 0.1, 3.0}), {}).by_r.isZero(0.0));
    }
}

TEST_CASE("friction with the ground acts in one direction alone if the other has no coefficient", "[loads]") {
    const double depth = 0.06;
    const double pressure = 50.0 * 0.4 * depth;
    const BedContact before{true, Vec3::Zero()};
    const NodeMotion motion = at({2.0, 1.0, 0.1 - depth});
    Seabed bed = level_bed();
    bed.axial_friction = 0.0;
    Vec3 force = compute_bed_force(bed, piece_of_rod(), motion, before).force;
    CHECK((force - pressure * Vec3(0.0, -0.8, 1.0)).norm() < 1e-14);
    CHECK(tangent_error(bed, piece_of_rod(Vec3(0.8, 0.5, 0.2).normalized()), motion, before) < 1e-8);
    bed = level_bed();
    bed.lateral_friction = 0.0;
    force = compute_bed_force(bed, piece_of_rod(), motion, before).force;
    CHECK((force - pressure * Vec3(-0.3, 0.0, 1.0)).norm() < 1e-14);
    CHECK(tangent_error(bed, piece_of_rod(Vec3(0.8, 0.5, 0.2).normalized()), motion, before) < 1e-8);
    CHECK((compute_bed_force(bed, a_body(), motion, before).force - pressure * Vec3::UnitZ()).norm() < 1e-14);
}

TEST_CASE("ground without coefficients, or without stiffness, has no friction", "[loads]") {
    const BedContact before{true, Vec3::Zero()};
    const NodeMotion motion = at({2.0, 1.0, 0.0});
    Seabed smooth = level_bed();
    smooth.axial_friction = smooth.lateral_friction = 0.0;
    Seabed loose = level_bed();
    loose.friction_stiffness = 0.0;
    for (const Seabed& bed : {smooth, loose}) {
        const BedForce force = compute_bed_force(bed, piece_of_rod(), motion, before);
        CHECK((force.force - force.pressure * Vec3::UnitZ()).norm() < 1e-14);
    }
}

TEST_CASE("a loop on the ground dissipates what friction does on the way that slips", "[loads]") {
    const Seabed bed = level_bed();
    const double limit = 0.8 * 50.0 * 0.4 * 0.1;
    const double elastic = limit / (20.0 * 0.4);
    const double amplitude = 3.0 * elastic;
    BedContact contact{true, Vec3::Zero()};
    double work = 0.0;
    Vec3 place = Vec3::Zero();
    Vec3 force = Vec3::Zero();
    const int steps = 1200;  // kinks of the loop are at steps
    const auto go_to = [&](double y) {
        const BedForce next = compute_bed_force(bed, piece_of_rod(), at({0.0, y, 0.0}), contact);
        contact = next.after;
        work += 0.5 * (force + next.force).y() * (y - place.y());
        place.y() = y;
        force = next.force;
    };
    for (int i = 0; i < steps; ++i) go_to(amplitude * (i + 1) / steps);
    work = 0.0;
    for (int i = 0; i < steps; ++i) go_to(amplitude * (1.0 - 2.0 * (i + 1) / steps));
    for (int i = 0; i < steps; ++i) go_to(amplitude * (-1.0 + 2.0 * (i + 1) / steps));
    CHECK(relative_difference(work, -4.0 * limit * (amplitude - elastic)) < 1e-12);
}

TEST_CASE("friction with the ground and the ground's pressure turn with both", "[loads]") {
    RandomValues random(6);
    const Mat3 turn = random.rotation().toRotationMatrix();
    const Seabed bed = level_bed();
    Seabed turned = bed;
    turned.normal = turn * bed.normal;
    const Vec3 r(0.4, 0.2, 0.02);
    const Vec3 axis = Vec3(0.6, 0.3, 0.1).normalized();
    const Vec3 target(0.1, 0.3, 0.0);
    const Vec3 force = compute_bed_force(bed, piece_of_rod(axis), at(r), {true, target}).force;
    const Vec3 there =
        compute_bed_force(turned, piece_of_rod(turn * axis), at(turn * r), {true, turn * target}).force;
    CHECK((there - turn * force).norm() < 1e-14);
}
