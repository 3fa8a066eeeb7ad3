#include "environment/waves.hpp"

#include <cmath>

#include "environment/dispersion.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

constexpr double gravity = 9.81;

WaveTrain make_train(
    double height, double period, std::optional<double> depth, double direction, double phase) {
    const double frequency = 2.0 * M_PI / period;
    return {0.5 * height, frequency, find_wave_number(frequency, depth, gravity), direction, phase};
}

// Row F18a of the benchmarks.
Water make_wave(Stretching stretching) {
    Water water;
    water.depth = 50.0;
    water.waves = {make_train(6, 10, 50.0, 0, 0)};
    water.stretching = stretching;
    return water;
}

// Five trains in a depth, short and long, along one direction or several.
Water make_sea(Stretching stretching, double spread, std::optional<double> depth) {
    Water water;
    water.depth = depth;
    water.stretching = stretching;
    for (int i = 0; i < 5; ++i) {
        water.waves.push_back(make_train(1.0 + 0.3 * i, 11.0 - 2.0 * i, depth, 0.4 + spread * i, 1.1 * i));
    }
    return water;
}

Waves make_waves(const Water& water) { return {water, find_wave_kernels(InstructionSet::baseline)}; }

// A train by hyperbolic functions, before stretching.
FlowAt find_airy_flow(const WaveTrain& train, double depth, const Vec3& place, double time) {
    const double c = std::cos(train.direction), s = std::sin(train.direction);
    const double k = train.number, w = train.frequency;
    const double phase = k * (c * place[0] + s * place[1]) - w * time + train.phase;
    const double level = train.amplitude * w * std::cosh(k * (place[2] + depth)) / std::sinh(k * depth);
    const double upright = train.amplitude * w * std::sinh(k * (place[2] + depth)) / std::sinh(k * depth);
    FlowAt flow;
    flow.velocity = {level * std::cos(phase) * c, level * std::cos(phase) * s, upright * std::sin(phase)};
    flow.acceleration = {
        w * level * std::sin(phase) * c, w * level * std::sin(phase) * s, -w * upright * std::cos(phase)};
    return flow;
}

constexpr Stretching all_stretchings[] = {
    Stretching::wheeler, Stretching::vertical, Stretching::extrapolate, Stretching::none};

}  // namespace

TEST_CASE("An Airy wave has the values of the benchmarks", "[environment]") {
    const Water water = make_wave(Stretching::none);
    Waves waves = make_waves(water);
    waves.move_to(3.0);
    const Waves::At at = waves.at({20, 0, -5});
    CHECK(at.surface.elevation == Approx(1.4812838545456).epsilon(4e-14));
    CHECK(at.flow.velocity[0] == Approx(.78657784243635).epsilon(2e-14));
    CHECK(at.flow.velocity[2] == Approx(-1.3208579026163).epsilon(4e-14));
    CHECK(at.flow.acceleration[0] == Approx(-.87040789067032).epsilon(2e-14));
    CHECK(at.flow.acceleration[2] == Approx(-.47123194579394).epsilon(2e-14));
    CHECK(at.flow.velocity[1] == 0.0);
}

TEST_CASE("A stretched Airy wave has the values of the benchmarks", "[environment]") {
    const Water water = make_wave(Stretching::wheeler);
    Waves waves = make_waves(water);
    waves.move_to(0.5);
    const Waves::At at = waves.at({0, 0, 2});
    CHECK(at.surface.elevation == Approx(2.8531695488855).epsilon(2e-14));
    CHECK(at.flow.velocity[0] == Approx(1.7909006139468).epsilon(4e-14));
    CHECK(at.flow.velocity[2] == Approx(-.56265939023232).epsilon(2e-14));
    CHECK(at.flow.acceleration[0] == Approx(-.36561785148636).epsilon(2e-14));
    CHECK(at.flow.acceleration[2] == Approx(-1.0880513722751).epsilon(4e-14));
}

TEST_CASE("Several trains of any direction add up", "[environment]") {
    for (const double spread : {0.0, 0.5}) {
        const Water water = make_sea(Stretching::none, spread, 30.0);
        Waves waves = make_waves(water);
        waves.move_to(7.3);
        const Vec3 place(12, -31, -4);
        FlowAt sum;
        for (const WaveTrain& train : water.waves) {
            const FlowAt flow = find_airy_flow(train, 30.0, place, 7.3);
            sum.velocity += flow.velocity;
            sum.acceleration += flow.acceleration;
        }
        const FlowAt flow = waves.at(place).flow;
        CHECK((flow.velocity - sum.velocity).norm() < 1e-14);
        CHECK((flow.acceleration - sum.acceleration).norm() < 1e-14);
    }
}

TEST_CASE("Gradients of waves are those of their values, with every stretching", "[environment]") {
    for (const Stretching stretching : all_stretchings) {
        for (const double spread : {0.0, 0.5}) {
            for (const std::optional<double> depth : {std::optional<double>(30.0), std::optional<double>()}) {
                const Water water = make_sea(stretching, spread, depth);
                Waves waves = make_waves(water);
                waves.move_to(7.3);
                const double surface = waves.at({12, -31, 0}).surface.elevation;
                // Far below, just below still water, just below the surface and above it.
                for (const double z : {-28.0, -6.0, -0.3, surface - 0.05, surface + 0.6}) {
                    INFO(int(stretching) << " " << spread << " " << depth.has_value() << " " << z);
                    const Vec3 place(12, -31, z);
                    const Waves::At at = waves.at(place);
                    const double h = 1e-4;
                    for (int j = 0; j < 3; ++j) {
                        const Waves::At after = waves.at(place + h * Vec3::Unit(j));
                        const Waves::At before = waves.at(place - h * Vec3::Unit(j));
                        const auto slope = [&](const Vec3& b, const Vec3& a) -> Vec3 {
                            return (b - a) / (2 * h);
                        };
                        CHECK((at.flow.velocity_gradient.col(j) -
                               slope(after.flow.velocity, before.flow.velocity))
                                  .norm() < 3e-8);
                        CHECK((at.flow.acceleration_gradient.col(j) -
                               slope(after.flow.acceleration, before.flow.acceleration))
                                  .norm() < 3e-8);
                        const double rise = after.surface.elevation - before.surface.elevation;
                        CHECK(at.surface.slope[j] == Approx(rise / (2 * h)).margin(3e-9));
                    }
                }
            }
        }
    }
}

TEST_CASE("Accelerations of waves are the rates of velocities, those of the ramp included", "[environment]") {
    for (const double spread : {0.0, 0.5}) {
        Water water = make_sea(Stretching::none, spread, 30.0);
        water.ramp_start = 2.0;
        water.ramp = 6.0;
        Waves waves = make_waves(water);
        const Vec3 place(12, -31, -4);
        const double h = 1e-4;
        for (const double time : {1.0, 2.5, 5.0, 7.7, 9.0}) {
            INFO(time);
            waves.move_to(time + h);
            const FlowAt after = waves.at(place).flow;
            waves.move_to(time - h);
            const FlowAt before = waves.at(place).flow;
            waves.move_to(time);
            const FlowAt flow = waves.at(place).flow;
            CHECK((flow.acceleration - (after.velocity - before.velocity) / (2 * h)).norm() < 3e-8);
            CHECK(
                (flow.acceleration_gradient - (after.velocity_gradient - before.velocity_gradient) / (2 * h))
                    .norm() < 3e-8);
        }
    }
}

TEST_CASE("A ramp grows as its polynomial and stays", "[environment]") {
    Water ramped = make_sea(Stretching::none, 0.0, 30.0);
    const Water plain = ramped;
    ramped.ramp_start = 2.0;
    ramped.ramp = 6.0;
    Waves waves = make_waves(ramped), full = make_waves(plain);
    const Vec3 place(1, 2, -3);
    const auto share = [&](double time) {
        waves.move_to(time);
        full.move_to(time);
        CHECK(waves.at(place).surface.elevation / full.at(place).surface.elevation ==
              Approx(waves.at(place).flow.velocity[0] / full.at(place).flow.velocity[0]).margin(1e-14));
        return waves.at(place).flow.velocity[0] / full.at(place).flow.velocity[0];
    };
    CHECK(share(1.0) == 0.0);
    CHECK(waves.are_still());
    CHECK(share(2.0) == 0.0);
    CHECK(share(3.5) == Approx(0.103515625).epsilon(1e-14));  // q = ¼: (10 − 15/4 + 6/16)/64
    CHECK(share(5.0) == Approx(0.5).epsilon(1e-14));
    CHECK(share(8.0) == 1.0);
    CHECK_FALSE(waves.are_still());
    CHECK(share(80.0) == 1.0);
}

TEST_CASE("Airy waves have neither divergence nor rotation", "[environment]") {
    const Water water = make_sea(Stretching::none, 0.5, 30.0);
    Waves waves = make_waves(water);
    waves.move_to(3.1);
    for (const double z : {-29.0, -10.0, -1.0}) {
        const FlowAt flow = waves.at({5, 6, z}).flow;
        for (const Mat3& gradient : {flow.velocity_gradient, flow.acceleration_gradient}) {
            CHECK(std::abs(gradient.trace()) < 1e-16);
            CHECK((gradient - gradient.transpose()).norm() == 0.0);
            CHECK(gradient.norm() > 0.01);
        }
    }
}

TEST_CASE("At the bed waves only move along it, at the surface as the surface does", "[environment]") {
    const Water water = make_sea(Stretching::none, 0.5, 30.0);
    Waves waves = make_waves(water);
    const double h = 1e-4;
    waves.move_to(3.1 + h);
    const double after = waves.at({5, 6, 0}).surface.elevation;
    waves.move_to(3.1 - h);
    const double before = waves.at({5, 6, 0}).surface.elevation;
    waves.move_to(3.1);
    CHECK(waves.at({5, 6, 0}).flow.velocity[2] == Approx((after - before) / (2 * h)).epsilon(1e-7));
    CHECK(std::abs(waves.at({5, 6, -30}).flow.velocity[2]) < 1e-15);
    CHECK(waves.at({5, 6, -30}).flow.velocity.norm() > 0.1);
    // The pressure ρg η of linear waves at still water drives the flow: ∂u/∂t = −g ∇η.
    const Waves::At at = waves.at({5, 6, 0});
    CHECK((at.flow.acceleration.head<2>() + gravity * at.surface.slope.head<2>()).norm() < 1e-14);
    // There is no water below the bed, and what is there sees that at the bed.
    CHECK(waves.at({5, 6, -40}).flow.velocity == waves.at({5, 6, -30}).flow.velocity);
}

TEST_CASE("A deep bed is not felt, and neither are numbers that overflow", "[environment]") {
    for (const Stretching stretching : all_stretchings) {
        // Of depths of many wave lengths, the second far beyond what cosh can hold.
        for (const double depth : {2000.0, 1e5}) {
            Water deep = make_sea(stretching, 0.0, {}), finite = make_sea(stretching, 0.0, depth);
            Waves without_bed = make_waves(deep), with_bed = make_waves(finite);
            without_bed.move_to(4.0);
            with_bed.move_to(4.0);
            for (const double z : {-1000.0, -100.0, -10.0, 0.0, 0.8, 300.0}) {
                const Waves::At expected = without_bed.at({3, 4, z}), at = with_bed.at({3, 4, z});
                CHECK(at.flow.velocity.allFinite());
                CHECK(at.flow.acceleration_gradient.allFinite());
                // Wheeler's drawing differs by η z/d.
                const double margin = stretching == Stretching::wheeler ? 3.0 / depth * 10 : 1e-14;
                CHECK((at.flow.velocity - expected.flow.velocity).norm() < margin);
            }
        }
    }
}

TEST_CASE("Trains that a depth damps away are left out without a trace", "[environment]") {
    Water water = make_sea(Stretching::none, 0.0, 200.0);
    Waves waves = make_waves(water);
    waves.move_to(1.0);
    for (const double z : {-190.0, -100.0, -60.0}) {
        const Vec3 place(3, 4, z);
        FlowAt sum;
        for (const WaveTrain& train : water.waves) {
            const FlowAt flow = find_airy_flow(train, 200.0, place, 1.0);
            sum.velocity += flow.velocity;
        }
        CHECK((waves.at(place).flow.velocity - sum.velocity).norm() < 1e-16);
    }
}

TEST_CASE("Waves in shallow water are level and even over the depth", "[environment]") {
    Water water;
    water.depth = 2.0;
    water.stretching = Stretching::none;
    const double frequency = 1e-3;
    water.waves = {{0.1, frequency, find_wave_number(frequency, 2.0, gravity), 0.0, 0.3}};
    Waves waves = make_waves(water);
    waves.move_to(5.0);
    const Waves::At at = waves.at({7, 0, -1.4});
    // u = η √(g/d), w = ∂η/∂t (1 + z/d).
    CHECK(at.flow.velocity[0] == Approx(at.surface.elevation * std::sqrt(gravity / 2.0)).epsilon(1e-6));
    const double phase = water.waves[0].number * 7.0 - frequency * 5.0 + 0.3;
    CHECK(at.flow.velocity[2] == Approx(0.1 * frequency * std::sin(phase) * 0.3).epsilon(1e-6));
}

TEST_CASE("Above still water the stretchings differ as they say", "[environment]") {
    const auto find = [&](Stretching stretching, double z) {
        const Water water = make_wave(stretching);
        Waves waves = make_waves(water);
        waves.move_to(0.0);  // η = 3 at x = 0
        return waves.at({0, 0, z}).flow.velocity[0];
    };
    const double k = .0415284525207225991, w = 2.0 * M_PI / 10.0;
    const auto airy = [&](double z) { return 3.0 * w * std::cosh(k * (z + 50)) / std::sinh(k * 50); };
    CHECK(find(Stretching::none, 2.0) == Approx(airy(2.0)).epsilon(1e-14));
    CHECK(find(Stretching::vertical, 2.0) == Approx(airy(0.0)).epsilon(1e-14));
    // The slope of C at still water is k.
    CHECK(find(Stretching::extrapolate, 2.0) == Approx(airy(0.0) + 2.0 * 3.0 * w * k).epsilon(1e-14));
    CHECK(find(Stretching::wheeler, 2.0) == Approx(airy(50.0 * 52.0 / 53.0 - 50.0)).epsilon(1e-14));
    for (const Stretching stretching : all_stretchings) {
        CHECK(find(stretching, 40.0) == Approx(find(stretching, 3.0)).epsilon(1e-14));
        if (stretching != Stretching::wheeler)
            CHECK(find(stretching, -8.0) == Approx(airy(-8.0)).epsilon(1e-14));
    }
    CHECK(find(Stretching::wheeler, -50.0) == Approx(airy(-50.0)).epsilon(1e-14));
}

TEST_CASE("Without trains there are no waves", "[environment]") {
    const Water water;
    Waves waves = make_waves(water);
    waves.move_to(1.0);
    CHECK(waves.are_still());
}

}  // namespace gxrod::test
