#include "environment/fluid_field.hpp"

#include <cmath>
#include <limits>

#include "environment/dispersion.hpp"
#include "model/evaluation_error.hpp"
#include "numerics/gauss_legendre.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

Surroundings surround(const Water& water) { return {water, {}, {}}; }

struct PileForce {
    double shear = 0.0, moment = 0.0;  // about the bed
};

// Row F7d of the benchmarks: a fixed pile of D = 1, ρ = 1025, Cd = 1, 1 + Ca = 2 from the bed at z = −50 up
// to `top`.
PileForce integrate_pile(const FluidField& field, double top) {
    constexpr int pieces = 40;
    const auto rule = compute_gauss_rule<8>();
    PileForce force;
    for (int i = 0; i < pieces; ++i) {
        const double half = 0.5 * (top + 50.0) / pieces;
        for (const QuadraturePoint& point : rule) {
            const double above_bed = half * (2 * i + 1 + point.xi);
            const WaterAt water = field.water_at({0, 0, above_bed - 50.0});
            const double u = water.velocity[0];
            const double load =
                0.5 * 1025.0 * std::abs(u) * u + 2.0 * 1025.0 * M_PI / 4.0 * water.acceleration[0];
            force.shear += half * point.weight * load;
            force.moment += half * point.weight * load * above_bed;
        }
    }
    return force;
}

Water make_pile_water(Stretching stretching) {
    Water water;
    water.density = 1025.0;
    water.surface = 0.0;
    water.depth = 50.0;
    water.stretching = stretching;
    const double frequency = 2.0 * M_PI / 10.0;
    water.waves = {{3.0, frequency, find_wave_number(frequency, 50.0, 9.81), 0.0, 0.0}};
    return water;
}

// A current that turns and grows in time.
Flow make_flow() {
    Flow flow;
    flow.profile = SpeedProfile{{-20, -5, 0}, {0.3, 1.1, 1.5}, Vec3(0.6, 0.8, 0), TimeFunction([](double t) {
                                    return 1.0 + 0.5 * std::sin(t);
                                })};
    flow.field = [](double t, const Vec3& r) {
        return Vec3(std::sin(t + 0.1 * r[1]), 0.01 * r[2] * r[0] * t, std::cos(0.2 * r[0]));
    };
    return flow;
}

}  // namespace

TEST_CASE("The forces on a pile in a wave have their closed form", "[environment]") {
    const Surroundings surroundings = surround(make_pile_water(Stretching::none));
    FluidField field(surroundings, 50.0);
    for (const double time : {0.0, 1.25, 2.5, 4.1, 7.7}) {
        field.move_to(time);
        const double phase = 2.0 * M_PI / 10.0 * time, c = std::cos(phase);
        CHECK(integrate_pile(field, 0.0).shear ==
              Approx(25578.9260687144 * std::abs(c) * c - 45917.5793966054 * std::sin(phase)).epsilon(1e-13));
    }
    field.move_to(0.0);
    CHECK(integrate_pile(field, 0.0).moment == Approx(941117.00846472).epsilon(1e-13));
    field.move_to(2.5);
    CHECK(integrate_pile(field, 0.0).moment == Approx(-1436558.2740431).epsilon(1e-13));
}

TEST_CASE("With Wheeler's stretching a pile is loaded up to the surface", "[environment]") {
    const Surroundings surroundings = surround(make_pile_water(Stretching::wheeler));
    FluidField field(surroundings, 50.0);
    field.move_to(0.0);
    const double crest = field.water_at(Vec3::Zero()).surface;
    CHECK(crest == Approx(3.0).epsilon(1e-15));
    CHECK(integrate_pile(field, crest).shear == Approx(27113.661632837).epsilon(1e-13));
    CHECK(integrate_pile(field, crest).moment == Approx(1057439.070711).epsilon(1e-12));
    field.move_to(1.25);
    CHECK(integrate_pile(field, field.water_at(Vec3::Zero()).surface).shear ==
          Approx(-20514.085152193).epsilon(1e-13));
}

TEST_CASE("A level of still water shifts all but the current", "[environment]") {
    Water water = make_pile_water(Stretching::wheeler);
    const Surroundings low = surround(water);
    water.surface = 7.0;
    water.current.profile = SpeedProfile{{0, 10}, {0, 1}, Vec3::UnitY(), 1.0};
    const Surroundings high = surround(water);
    FluidField first(low, 50.0), second(high, 50.0);
    first.move_to(1.0);
    second.move_to(1.0);
    const WaterAt below = first.water_at({3, 1, -4}), above = second.water_at({3, 1, 3});
    CHECK(above.surface == Approx(below.surface + 7.0).epsilon(1e-15));
    CHECK(above.surface_slope == below.surface_slope);
    CHECK(above.velocity[0] == below.velocity[0]);
    CHECK(above.velocity[1] == Approx(0.3).epsilon(1e-15));
    CHECK(above.has_surface);
}

TEST_CASE("A profile is linear between its heights and constant beyond", "[environment]") {
    Water water;
    water.current.profile = SpeedProfile{{-20, -5, 0}, {0.3, 1.1, 1.5}, Vec3(0.6, 0.8, 0), 1.0};
    const Surroundings surroundings = surround(water);
    FluidField field(surroundings, 10.0);
    field.move_to(0.0);
    const auto speed = [&](double z) { return field.water_at({1, 2, z}).velocity.dot(Vec3(0.6, 0.8, 0)); };
    CHECK(speed(-30) == Approx(0.3));
    CHECK(speed(-20) == Approx(0.3));
    CHECK(speed(-12.5) == Approx(0.7));
    CHECK(speed(-5) == Approx(1.1));
    CHECK(speed(-2.5) == Approx(1.3));
    CHECK(speed(4) == Approx(1.5));
    CHECK_FALSE(field.water_at(Vec3::Zero()).has_surface);
    CHECK(field.is_shareable());
}

TEST_CASE("Currents have the gradients and the rates of their values", "[environment]") {
    Water water;
    water.current = make_flow();
    const Surroundings surroundings = surround(water);
    FluidField field(surroundings, 10.0);
    const Vec3 place(3, -2, -8);
    const double h = 1e-4;
    for (const double time : {0.0, 1.3}) {
        INFO(time);
        field.move_to(time + h);
        const WaterAt after = field.water_at(place);
        field.move_to(time);
        const WaterAt at = field.water_at(place);
        field.move_to(time - h);
        const WaterAt before = field.water_at(place);
        CHECK((at.acceleration - (after.velocity - before.velocity) / (2 * h)).norm() < 1e-8);
        field.move_to(time);
        for (int j = 0; j < 3; ++j) {
            const Vec3 step = h * Vec3::Unit(j);
            const Vec3 slope =
                (field.water_at(place + step).velocity - field.water_at(place - step).velocity) / (2 * h);
            CHECK((at.velocity_gradient.col(j) - slope).norm() < 1e-8);
        }
        // The profile's, whose factor has the rate ½ cos t.
        CHECK(at.acceleration_gradient(1, 2) == Approx(0.5 * std::cos(time) * 0.8 / 15 * 0.8).epsilon(1e-9));
        const WaterAt less = field.water_at(place, false);
        CHECK(less.velocity == at.velocity);
        CHECK(less.acceleration == at.acceleration);
        CHECK(less.velocity_gradient(1, 0) == 0.0);
    }
    CHECK_FALSE(field.is_shareable());
}

TEST_CASE("A function of the time need not have values before 0", "[environment]") {
    Water water;
    water.current.profile = SpeedProfile{
        {0}, {1}, Vec3::UnitX(), TimeFunction([](double t) { return t < 0.0 ? NAN : t * t + t; })};
    const Surroundings surroundings = surround(water);
    FluidField field(surroundings, 10.0);
    field.move_to(0.0);
    CHECK(field.water_at(Vec3::Zero()).acceleration[0] == Approx(1.0).epsilon(1e-9));
}

TEST_CASE("A current is drawn with the surface where it is asked to", "[environment]") {
    for (const std::optional<double> depth : {std::optional<double>(50.0), std::optional<double>()}) {
        Water water = make_pile_water(Stretching::none);
        water.depth = depth;
        water.surface = 2.0;
        water.stretches_current = true;
        water.current.profile = SpeedProfile{{-48, 2}, {0, 1}, Vec3::UnitY(), 1.0};
        const Surroundings surroundings = surround(water);
        FluidField field(surroundings, 50.0);
        field.move_to(0.7);
        const double surface = field.water_at({4, 0, 0}).surface;
        CHECK(std::abs(surface - 2.0) > 1.0);
        // All of the current up to the surface, none at the bed.
        CHECK(field.water_at({4, 0, surface}).velocity[1] == Approx(1.0).epsilon(1e-14));
        const double z = -10.0, eta = surface - 2.0;
        const double drawn = depth ? 50.0 * (z - 2.0 + 50.0) / (50.0 + eta) : 50.0 + z - surface;
        CHECK(field.water_at({4, 0, z}).velocity[1] == Approx(drawn / 50.0).epsilon(1e-13));
        const WaterAt at = field.water_at({4, 0, z});
        for (int j = 0; j < 3; ++j) {
            const Vec3 place(4, 0, z), step = 1e-4 * Vec3::Unit(j);
            const double slope =
                (field.water_at(place + step).velocity[1] - field.water_at(place - step).velocity[1]) / 2e-4;
            CHECK(at.velocity_gradient(1, j) == Approx(slope).margin(1e-10));
        }
    }
}

TEST_CASE("Air flows by its profile and its field", "[environment]") {
    Surroundings surroundings;
    surroundings.air = Air{1.2, make_flow()};
    FluidField field(surroundings, 10.0);
    field.move_to(1.3);
    const Vec3 place(3, -2, -8);
    const AirAt at = field.air_at(place);
    const double speed = (1.0 + 0.5 * std::sin(1.3)) * (1.1 - 3.0 * 0.8 / 15.0);
    const Vec3 velocity = speed * Vec3(0.6, 0.8, 0) + surroundings.air->wind.field(1.3, place);
    CHECK((at.velocity - velocity).norm() < 1e-15);
    CHECK(at.velocity_gradient(0, 1) == Approx(0.1 * std::cos(1.3 - 0.2)).epsilon(1e-8));
}

TEST_CASE("Functions without a finite value are named", "[environment]") {
    Surroundings surroundings;
    surroundings.water = Water{};
    surroundings.water->current.profile =
        SpeedProfile{{0}, {1}, Vec3::UnitX(), TimeFunction([](double t) { return 1.0 / (t - 2.0); })};
    surroundings.air = Air{};
    surroundings.air->wind.field = [](double, const Vec3& r) { return Vec3(0, std::log(r[2]), 0); };
    FluidField field(surroundings, 10.0);
    CHECK_THROWS_AS(field.move_to(2.0), EvaluationError);
    CHECK_THROWS_WITH(field.move_to(2.0), Contains("water") && Contains("t = 2"));
    field.move_to(3.0);
    CHECK_THROWS_WITH(field.air_at({1, 2, -3}), Contains("air") && Contains("(1, 2, -3)"));
}

TEST_CASE("A field forgets functions that rest on more than the time", "[environment]") {
    double input = 1.0;
    int calls = 0;
    Water water;
    const auto factor = [&](double) {
        ++calls;
        return input;
    };
    water.current.profile = SpeedProfile{{0}, {1}, Vec3::UnitX(), TimeFunction(factor, nullptr, false)};
    const Surroundings surroundings = surround(water);
    FluidField field(surroundings, 10.0);
    field.move_to(1.0);
    field.move_to(1.0);
    CHECK(calls == 1);
    input = 2.0;
    CHECK(field.water_at(Vec3::Zero()).velocity[0] == 1.0);
    field.forget();
    field.move_to(1.0);
    CHECK(calls == 2);
    CHECK(field.water_at(Vec3::Zero()).velocity[0] == 2.0);
    CHECK(field.water_at(Vec3::Zero()).acceleration[0] == 0.0);
}

}  // namespace gxrod::test
