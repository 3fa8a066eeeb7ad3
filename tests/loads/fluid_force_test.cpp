#include "loads/fluid_force.hpp"

#include <numbers>

#include "loads/sample_fluids.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

SectionInFluid sample_section() {
    SectionInFluid section;
    section.area = 0.7;
    section.diameter = 0.4;
    section.drag = Vec3(0.3, 1.2, 0.8);
    section.added_mass = Vec3(0.1, 1.0, 0.6);
    return section;
}

WetPoint sample_point(const SectionInFluid& section, const Mat3& axes) {
    return {.section = &section, .axes = axes, .piece_length = 0.9, .piece_offset = 0.2};
}

FluidForce force_on(const WetPoint& point, const SampleFluids& fluids, const NodeMotion& motion) {
    return fluids.at(motion.r,
                     [&](const FluidsAt& there) { return compute_fluid_force(point, there, motion); });
}

// In the worst of its four parts.
double tangent_error(const WetPoint& point, const SampleFluids& fluids, const NodeMotion& motion) {
    const auto tangent = fluids.at(motion.r, [&](const FluidsAt& there) {
        return compute_fluid_force_derivative(point, there, motion);
    });
    FluidForceDerivative expected;
    for (int i = 0; i < 3; ++i) {
        const auto along = [&](auto&& change) {
            return differentiate(
                [&](double amount) {
                    WetPoint changed = point;
                    NodeMotion moved = motion;
                    change(changed, moved, amount * Vec3::Unit(i));
                    return force_on(changed, fluids, moved).force;
                },
                2e-3);
        };
        expected.by_r.col(i) = along([](WetPoint&, NodeMotion& m, const Vec3& d) { m.r += d; });
        expected.by_phi.col(i) =
            along([](WetPoint& p, NodeMotion&, const Vec3& d) { p.axes = exp_matrix(d) * p.axes; });
        expected.by_v.col(i) = along([](WetPoint&, NodeMotion& m, const Vec3& d) { m.v += d; });
        expected.by_a.col(i) = along([](WetPoint&, NodeMotion& m, const Vec3& d) { m.a += d; });
    }
    return std::max({relative_difference(tangent.by_r, expected.by_r),
                     relative_difference(tangent.by_phi, expected.by_phi),
                     relative_difference(tangent.by_v, expected.by_v),
                     relative_difference(tangent.by_a, expected.by_a)});
}

}  // namespace

TEST_CASE("the tangent of a fluid's force on a rod is its derivative", "[loads]") {
    RandomValues random(5);
    const SectionInFluid section = sample_section();
    int checked = 0;
    for (int i = 0; i < 20; ++i) {
        const NodeMotion motion = random_motion(random);
        const WetPoint point = sample_point(section, random.rotation().toRotationMatrix());
        for (const Around around : {Around::water, Around::air, Around::both}) {
            // Without a surface, deep down, far above
            for (const auto& level : {std::optional<double>{}, std::optional(3.0), std::optional(-3.0)}) {
                const SampleFluids fluids(random, around, level);
                if (!fluids.flows_past(motion.r, motion.v, point.axes)) continue;
                ++checked;
                CHECK(tangent_error(point, fluids, motion) < 1e-8);
            }
        }
    }
    CHECK(checked > 120);
}

TEST_CASE("the tangent of a fluid's force holds at the surface", "[loads]") {
    RandomValues random(6);
    const SectionInFluid section = sample_section();
    int partly = 0;
    for (int i = 0; i < 60; ++i) {
        const NodeMotion motion = random_motion(random);
        const WetPoint point = sample_point(section, random.rotation().toRotationMatrix());
        for (const Around around : {Around::water, Around::both}) {
            const SampleFluids fluids(random, around, motion.r.z() + random.number(-0.4, 0.4));
            const double wet = force_on(point, fluids, motion).wet_fraction;
            if (wet < 0.1 || wet > 0.9 || !fluids.flows_past(motion.r, motion.v, point.axes)) continue;
            ++partly;
            CHECK(tangent_error(point, fluids, motion) < 1e-8);
        }
    }
    CHECK(partly > 40);
}

TEST_CASE("the tangent of a fluid's force holds for level and upright rods at the surface", "[loads]") {
    RandomValues random(8);
    const SectionInFluid section = sample_section();
    NodeMotion motion = random_motion(random);
    motion.r.z() = 0.0;
    for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitZ()), Vec3(-Vec3::UnitZ())}) {
        const Quat turn = Quat::FromTwoVectors(Vec3::UnitX(), axis);
        WetPoint point = sample_point(section, turn.toRotationMatrix());
        point.piece_offset = 0.0;
        CHECK(tangent_error(point, {random, Around::both, 0.0}, motion) < 1e-8);
    }
}

TEST_CASE("drag on a rod across and along it is that of Morison and of friction on its surface", "[loads]") {
    const SectionInFluid section = sample_section();
    const double U = 3.0;
    const double angle = 0.4;  // between flow and rod, in the plane of section axes x, y
    const WaterAt water{.velocity = U * Vec3(std::cos(angle), std::sin(angle), 0.0)};
    const FluidsAt fluids{.water_density = 2.0, .water = &water};
    const FluidForce still = compute_fluid_force(sample_point(section, Mat3::Identity()), fluids, {});
    CHECK(still.wet_fraction == 1.0);
    const double pressure = 0.5 * 2.0 * U * U;
    const Vec3 expected(pressure * std::numbers::pi * 0.4 * 0.3 * std::pow(std::cos(angle), 2),
                        pressure * 0.4 * 1.2 * std::pow(std::sin(angle), 2),
                        0.0);
    CHECK(relative_difference(still.force, expected) < 1e-14);
}

TEST_CASE("a rod of the water's density and no drag takes the acceleration of the water", "[loads]") {
    RandomValues random(9);
    SectionInFluid section = sample_section();
    section.drag.setZero();
    NodeMotion motion = random_motion(random);
    const WaterAt water{.acceleration = motion.a};
    const Vec3 gravity = random.vector();
    const FluidsAt fluids{.water_density = 2.0, .water = &water, .gravity = gravity};
    const WetPoint point = sample_point(section, random.rotation().toRotationMatrix());
    const Vec3 force = compute_fluid_force(point, fluids, motion).force;
    // m (a − g), which inertia and weight of such a rod take
    CHECK(relative_difference(force, Vec3(2.0 * 0.7 * (motion.a - gravity))) < 1e-14);
}

TEST_CASE("added mass on a rod acts along each section axis", "[loads]") {
    RandomValues random(10);
    const SectionInFluid section = sample_section();
    const Mat3 axes = random.rotation().toRotationMatrix();
    const WaterAt water;
    const FluidsAt fluids{.water_density = 2.0, .water = &water};
    for (int i = 0; i < 3; ++i) {
        NodeMotion motion;
        motion.a = axes.col(i);
        const Vec3 force = compute_fluid_force(sample_point(section, axes), fluids, motion).force;
        CHECK((force + 2.0 * 0.7 * section.added_mass[i] * axes.col(i)).norm() < 1e-14);
    }
    const Mat3 mass = compute_fluid_force_derivative(sample_point(section, axes), fluids, {}).by_a;
    CHECK((mass - mass.transpose()).norm() < 1e-15);
}

TEST_CASE("still water and still air take energy from every moving rod", "[loads]") {
    RandomValues random(11);
    const SectionInFluid section = sample_section();
    WaterAt water;
    const AirAt air;
    for (int i = 0; i < 200; ++i) {
        NodeMotion motion = random_motion(random);
        motion.a.setZero();
        water.has_surface = true;
        water.surface = random.number(-1.0, 1.0);
        const FluidsAt fluids{
            .water_density = 2.0, .water = &water, .air_density = 1.0, .air = &air, .gravity = Vec3::Zero()};
        const WetPoint point = sample_point(section, random.rotation().toRotationMatrix());
        CHECK(compute_fluid_force(point, fluids, motion).force.dot(motion.v) < 0.0);
    }
}
