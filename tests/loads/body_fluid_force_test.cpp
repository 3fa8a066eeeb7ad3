#include "loads/fluid_force.hpp"
#include "loads/sample_fluids.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

BodyInFluid sample_body(RandomValues& random) {
    BodyInFluid body;
    body.volume = 0.8;
    body.centre = 0.5 * random.vector();
    body.height = 0.7;
    body.drag_area = Vec3(0.5, 0.9, 1.4);
    body.added_mass = random.positive_definite<6>();
    return body;
}

BodyFluidForce force_on(const BodyInFluid& body,
                        const Mat3& axes,
                        const SampleFluids& fluids,
                        const NodeMotion& motion) {
    return fluids.at(motion.r + axes * body.centre, [&](const FluidsAt& there) {
        return compute_body_fluid_force(body, axes, there, motion);
    });
}

double tangent_error(const BodyInFluid& body,
                     const Mat3& axes,
                     const SampleFluids& fluids,
                     const NodeMotion& motion) {
    const auto tangent = fluids.at(motion.r + axes * body.centre, [&](const FluidsAt& there) {
        return compute_body_fluid_derivative(body, axes, there, motion);
    });
    BodyFluidDerivative expected;
    for (int i = 0; i < 6; ++i) {
        const auto along = [&](auto&& change) {
            const Vec6 unit = Vec6::Unit(i);
            return differentiate(
                [&](double amount) {
                    Mat3 turned = axes;
                    NodeMotion moved = motion;
                    change(turned, moved, amount * unit.head<3>(), amount * unit.tail<3>());
                    return force_on(body, turned, fluids, moved).force;
                },
                2e-3);
        };
        expected.by_place.col(i) = along([](Mat3& A, NodeMotion& m, const Vec3& d, const Vec3& turn) {
            m.r += d;
            A = exp_matrix(turn) * A;
        });
        expected.by_rates.col(i) = along([](Mat3&, NodeMotion& m, const Vec3& d, const Vec3& turn) {
            m.v += d;
            m.omega += turn;
        });
        expected.by_accelerations.col(i) = along([](Mat3&, NodeMotion& m, const Vec3& d, const Vec3& turn) {
            m.a += d;
            m.alpha += turn;
        });
    }
    return std::max({relative_difference(tangent.by_place, expected.by_place),
                     relative_difference(tangent.by_rates, expected.by_rates),
                     relative_difference(tangent.by_accelerations, expected.by_accelerations)});
}

}  // namespace

TEST_CASE("the tangent of a fluid's force on a body is its derivative", "[loads]") {
    RandomValues random(5);
    int partly = 0, checked = 0;
    for (int i = 0; i < 40; ++i) {
        const NodeMotion motion = random_motion(random);
        const BodyInFluid body = sample_body(random);
        const Mat3 axes = random.rotation().toRotationMatrix();
        const Vec3 d = axes * body.centre;
        const double z = motion.r.z() + d.z();
        for (const Around around : {Around::water, Around::air, Around::both}) {
            for (const auto& level :
                 {std::optional<double>{}, std::optional(z + 0.05), std::optional(-9.0)}) {
                const SampleFluids fluids(random, around, level);
                const double wet = force_on(body, axes, fluids, motion).wet_fraction;
                const bool is_at_edge = std::min(std::abs(wet), std::abs(1.0 - wet)) < 0.05;
                if (is_at_edge && wet != 0.0 && wet != 1.0) continue;
                if (!fluids.flows_past(motion.r + d, motion.v + motion.omega.cross(d), axes)) continue;
                partly += wet > 0.0 && wet < 1.0;
                ++checked;
                CHECK(tangent_error(body, axes, fluids, motion) < 1e-8);
            }
        }
    }
    CHECK(checked > 200);
    CHECK(partly > 40);
}

TEST_CASE("a body in a fluid can be described from any of its points", "[loads]") {
    RandomValues random(7);
    for (int i = 0; i < 20; ++i) {
        const NodeMotion motion = random_motion(random);
        const BodyInFluid body = sample_body(random);
        const Mat3 axes = random.rotation().toRotationMatrix();
        const Vec3 d = axes * body.centre;
        const SampleFluids fluids(random, Around::both, motion.r.z() + d.z());
        BodyInFluid centred = body;
        centred.centre.setZero();
        NodeMotion at_centre = motion;
        at_centre.r += d;
        at_centre.v += motion.omega.cross(d);
        at_centre.a += motion.alpha.cross(d) + motion.omega.cross(motion.omega.cross(d));
        const Vec6 there = force_on(centred, axes, fluids, at_centre).force;
        Vec6 expected = there;
        expected.tail<3>() += d.cross(there.head<3>());
        CHECK(relative_difference(force_on(body, axes, fluids, motion).force, expected) < 1e-13);
    }
}

TEST_CASE("a body at rest is borne by the weight of the water it displaces, at its centre", "[loads]") {
    RandomValues random(12);
    const BodyInFluid body = sample_body(random);
    const Mat3 axes = random.rotation().toRotationMatrix();
    WaterAt water;
    water.has_surface = true;
    NodeMotion motion;
    motion.r.z() = 0.1 * body.height - (axes * body.centre).z();  // centre a tenth of the height above
    const FluidsAt fluids{.water_density = 1000.0, .water = &water, .gravity = Vec3(0.0, 0.0, -9.81)};
    const BodyFluidForce result = compute_body_fluid_force(body, axes, fluids, motion);
    CHECK(std::abs(result.wet_fraction - 0.4) < 1e-15);
    const Vec3 buoyancy(0.0, 0.0, 0.4 * 1000.0 * 0.8 * 9.81);
    CHECK(relative_difference(result.force.head<3>(), buoyancy) < 1e-13);
    CHECK(relative_difference(result.force.tail<3>(), Vec3((axes * body.centre).cross(buoyancy))) < 1e-13);
}

TEST_CASE("a body that water carries along feels its own displaced mass accelerate", "[loads]") {
    RandomValues random(13);
    const BodyInFluid body = sample_body(random);
    const WaterAt water{.velocity = random.vector(), .acceleration = random.vector()};
    NodeMotion motion;
    motion.v = water.velocity;
    motion.a = water.acceleration;
    const FluidsAt fluids{.water_density = 2.0, .water = &water};
    const Vec6 force = compute_body_fluid_force(body, Mat3::Identity(), fluids, motion).force;
    CHECK(relative_difference(force.head<3>(), Vec3(2.0 * 0.8 * water.acceleration)) < 1e-13);
}

TEST_CASE("the added mass of a body is symmetric about its node, too", "[loads]") {
    RandomValues random(14);
    const BodyInFluid body = sample_body(random);
    const WaterAt water;
    const FluidsAt fluids{.water_density = 2.0, .water = &water};
    const Mat3 axes = random.rotation().toRotationMatrix();
    const Mat6 mass = -compute_body_fluid_derivative(body, axes, fluids, {}).by_accelerations;
    CHECK(relative_difference(mass, mass.transpose()) < 1e-14);
    CHECK(mass.llt().info() == Eigen::Success);
}

TEST_CASE("still water takes energy from every moving body", "[loads]") {
    RandomValues random(15);
    const WaterAt water;
    const FluidsAt fluids{.water_density = 2.0, .water = &water};
    for (int i = 0; i < 200; ++i) {
        BodyInFluid body = sample_body(random);
        body.added_mass.setZero();
        const NodeMotion motion = random_motion(random);
        const Mat3 axes = random.rotation().toRotationMatrix();
        const Vec6 force = compute_body_fluid_force(body, axes, fluids, motion).force;
        CHECK(force.head<3>().dot(motion.v) + force.tail<3>().dot(motion.omega) < 0.0);
    }
}

TEST_CASE("Equal drag areas give a drag along the flow, whatever the attitude", "[loads]") {
    RandomValues random(16);
    const Vec3 flow(0.9, -1.3, 0.4);
    const WaterAt water{.velocity = flow};
    const AirAt air{flow, Mat3::Zero()};
    const FluidsAt in_water{.water_density = 2.0, .water = &water};
    const FluidsAt in_air{.air_density = 2.0, .air = &air};
    BodyInFluid body;
    body.height = 1.0;
    body.drag_area = Vec3(0.7, 0.7, 0.7);
    const Vec3 expected = 0.5 * 2.0 * 0.7 * flow.norm() * flow;
    for (int i = 0; i < 10; ++i) {
        const Mat3 axes = random.rotation().toRotationMatrix();
        for (const FluidsAt& fluids : {in_water, in_air}) {
            const Vec6 force = compute_body_fluid_force(body, axes, fluids, {}).force;
            CHECK(relative_difference(force.head<3>(), expected) < 1e-14);
        }
    }
}

TEST_CASE("The drag of a body has the areas of its axes and the whole speed", "[loads]") {
    const Vec3 flow(1.0, 1.0, 1.0);
    const WaterAt water{.velocity = flow};
    const FluidsAt fluids{.water_density = 2.0, .water = &water};
    BodyInFluid body;
    body.height = 1.0;
    body.drag_area = Vec3(0.5, 0.9, 1.4);
    const Vec6 force = compute_body_fluid_force(body, Mat3::Identity(), fluids, {}).force;
    CHECK(relative_difference(force.head<3>(), Vec3(std::sqrt(3.0) * body.drag_area)) < 1e-14);
}
