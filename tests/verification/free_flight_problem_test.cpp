#include "verification/free_flight_problem.hpp"

#include <catch2/catch.hpp>

using namespace gxrod;
using namespace gxrod::free_flight;

TEST_CASE("the pulses of the free flight rise to 200 and give the momentum 50", "[verification]") {
    for (const Pulse pulse : {Pulse::triangular, Pulse::smooth}) {
        CHECK(std::abs(load(pulse, 0.0)) < 1e-12);
        CHECK(load(pulse, 1.25) == Approx(100.0).epsilon(1e-14));
        CHECK(load(pulse, 2.5) == Approx(200.0).epsilon(1e-14));
        CHECK(load(pulse, 5.0) == 0.0);
        CHECK(load(pulse, 7.0) == 0.0);
        double impulse = 0.0;
        constexpr int samples = 1000;
        for (int i = 0; i < samples; ++i) impulse += load(pulse, 5.0 * (i + 0.5) / samples) * 5.0 / samples;
        CHECK(impulse / 10.0 == Approx(exact_momentum().x()).epsilon(1e-12));
    }
}

TEST_CASE("the free flyer is the rod of Simo and Vu-Quoc", "[verification]") {
    const Model model = make_model(Pulse::triangular, 10);
    REQUIRE(model.rods.size() == 1);
    const Rod& rod = model.rods[0];
    CHECK(rod.element_count() == 10);
    CHECK(rod.arc_length.back() == Approx(10.0).epsilon(1e-15));
    CHECK((model.nodes.front().position - Vec3(6.0, 0.0, 0.0)).norm() < 1e-15);
    CHECK((model.nodes.back().position - Vec3(0.0, 8.0, 0.0)).norm() < 1e-15);
    for (const Quat& triad : rod.triads) CHECK((triad * Vec3::UnitX() - Vec3(-0.6, 0.8, 0.0)).norm() < 1e-15);
    const Section& section = model.sections[rod.section];
    Vec6 stiffness, mass;
    stiffness << 1e4, 1e4, 1e4, 500.0, 500.0, 500.0;
    mass << 1.0, 1.0, 1.0, 20.0, 10.0, 10.0;
    CHECK(section.stiffness == Mat6(stiffness.asDiagonal()));
    CHECK(section.mass == Mat6(mass.asDiagonal()));
    REQUIRE(model.loads.size() == 1);
    const NodalLoad& pull = model.loads[0];
    CHECK(pull.node == 0);
    CHECK(pull.force[0](2.5) == Approx(20.0).epsilon(1e-14));
    CHECK(pull.moment[1](2.5) == Approx(-100.0).epsilon(1e-14));
    CHECK(pull.moment[2](2.5) == Approx(-200.0).epsilon(1e-14));
    CHECK(model.supports.empty());
}
