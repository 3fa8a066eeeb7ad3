#include "environment/vessel_motion.hpp"

#include <cmath>

#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

const double degree = M_PI / 180.0;

// Heave 2 e^(−i 30°), sway 1 and roll 0.1 for waves from 0 to 180°; growing with the frequency from 1 to 2.
ResponseTable one_side() {
    ResponseTable table{.frequencies = {1.0, 2.0}, .headings = {0.0, M_PI}, .responses = {}};
    for (int heading = 0; heading < 2; ++heading)
        for (const double factor : {1.0, 3.0})
            table.responses.push_back(
                {0.0, factor * heading, std::polar(2.0 * factor, -30 * degree), 0.1 * heading, 0.0, 0.0});
    return table;
}

Water two_waves() {
    Water water{.density = 1025, .surface = 0.0};
    water.waves = {
        {.amplitude = 1.5, .frequency = 1.0, .number = 0.1, .direction = 0.0, .phase = 0.4},
        {.amplitude = 0.5, .frequency = 1.5, .number = 0.2, .direction = 0.5 * M_PI, .phase = 1.0}};
    return water;
}

}  // namespace

TEST_CASE("Responses are linear between frequencies and headings, and mirrored", "[environment]") {
    const ResponseTable table = one_side();
    const auto middle = find_response(table, 1.5, 0.5 * M_PI);
    REQUIRE(middle);
    CHECK(std::abs((*middle)[2] - std::polar(4.0, -30 * degree)) < 1e-14);
    CHECK(std::abs((*middle)[1] - 1.0) < 1e-14);
    CHECK(std::abs((*middle)[3] - 0.05) < 1e-14);
    const auto other_side = find_response(table, 1.5, -0.5 * M_PI);
    REQUIRE(other_side);
    CHECK(std::abs((*other_side)[2] - (*middle)[2]) < 1e-14);
    CHECK(std::abs((*other_side)[1] + (*middle)[1]) < 1e-14);
    CHECK(std::abs((*other_side)[3] + (*middle)[3]) < 1e-14);
    CHECK(std::abs((*find_response(table, 1.5, 2.5 * M_PI))[1] - 1.0) < 1e-9);
    CHECK_FALSE(find_response(table, 0.9, 0.0));
    CHECK_FALSE(find_response(table, 2.1, 0.0));
    ResponseTable round = table;  // 0, 90, 180, 270 without 360
    round.headings = {0.0, 0.5 * M_PI, M_PI, 1.5 * M_PI};
    round.responses.insert(round.responses.end(), table.responses.begin(), table.responses.end());
    CHECK(find_response(round, 1.0, -0.1));
    CHECK(std::abs((*find_response(round, 1.0, 1.75 * M_PI))[1] - 0.5) < 1e-9);
}

TEST_CASE("A vessel moves by the sum of all waves where it is", "[environment]") {
    const Vessel vessel{.place = Vec3(10, 20, 3), .offset = Vec3(5, -4, 0), .heading = 0.0};
    std::optional<WaveTrain> beyond;
    const VesselMotion motion(vessel, one_side(), two_waves(), beyond);
    CHECK_FALSE(beyond);
    for (const double t : {0.0, 0.7, 3.1, 50.0}) {
        // η = a cos(k x − ω t + φ); the crest of the motion comes 30° later.
        const double first = 2.0 * 1.5 * std::cos(0.1 * 15.0 - t + 0.4 + 30 * degree);
        const double second = 4.0 * 0.5 * std::cos(0.2 * 16.0 - 1.5 * t + 1.0 + 30 * degree);
        const Vec6 at = motion.at(t);
        CHECK(at[2] == Approx(first + second).epsilon(1e-12));
        // Sway of the waves that go along its y, 2 · ½.
        CHECK(at[1] + 4.0 == Approx(0.5 * std::cos(0.2 * 16.0 - 1.5 * t + 1.0)).margin(1e-12));
        CHECK(at[0] == 5.0);
    }
}

TEST_CASE("A vessel carries its points as a rigid body, in its heading", "[environment]") {
    // Turned by 90°: waves along y come from behind, and heave alone follows them.
    const Vessel vessel{.place = Vec3(0, 0, 0), .heading = 0.5 * M_PI};
    Water water = two_waves();
    water.waves.erase(water.waves.begin());
    water.waves[0].direction = M_PI;  // 90° from its x: to port, along −x of the globe
    water.waves[0].phase = 0.0;
    std::optional<WaveTrain> beyond;
    const VesselMotion motion(vessel, one_side(), water, beyond);
    const double t = 0.3, here = 0.5 * std::cos(1.5 * t);
    const Vec6 at = motion.at(t);
    CHECK(at[0] == Approx(-here).epsilon(1e-12));        // sway 1 along −x
    CHECK(at[4] == Approx(0.05 * here).epsilon(1e-12));  // roll about its x, the global y
    const Vec3 point(7, -2, 4);
    const Vec6 there = motion.of_point(point, t);
    const Vec3 moved = exp_quaternion(Vec3(at.tail<3>())) * point + at.head<3>();
    CHECK((there.head<3>() - (moved - point)).norm() < 1e-14);
    CHECK(there.tail<3>() == at.tail<3>());
    CHECK(motion.largest()[4] == Approx(0.025).epsilon(1e-12));
}

TEST_CASE("A vessel begins as waves do, and says which wave is beyond its table", "[environment]") {
    Water water = two_waves();
    water.ramp = 10.0;
    water.waves[1].frequency = 2.5;
    std::optional<WaveTrain> beyond;
    const VesselMotion motion(Vessel{}, one_side(), water, beyond);
    REQUIRE(beyond);
    CHECK(beyond->frequency == 2.5);
    CHECK(motion.at(0.0).isZero(0.0));
    water.ramp = 0.0;
    const VesselMotion whole(Vessel{}, one_side(), water, beyond);
    const double q = 0.4, grown = q * q * q * (10 - 15 * q + 6 * q * q);
    CHECK((motion.at(4.0) - grown * whole.at(4.0)).norm() < 1e-14);
    CHECK((motion.at(12.0) - whole.at(12.0)).norm() < 1e-14);
}

}  // namespace gxrod::test
