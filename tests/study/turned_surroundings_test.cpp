#include <cmath>

#include "deck/surroundings/surroundings_decks.hpp"
#include "environment/ground.hpp"
#include "study/turned_problem.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

const std::string around =
    water_deck +
    "current = { table = [[-10, 1], [0, 3]], direction = [3, 4, 0] }\n[[wave]]\nairy = { height = 2, period "
    "= 8 "
    "}\ndirection = [1, 2, 0]\n[air]\ndensity = 1\nwind = { velocity = [\"x\", \"y*z\", 3] }\n[seabed]\n"
    "stiffness = 1\nplane = { point = [1, 2, -30], normal = [0.1, 0.2, 1] }\n";

// With a depth, as the ground is not level.
std::string deck() { return tube_deck() + replaced(around, "surface = 0", "surface = 0\ndepth = 30"); }

double elevation(const WaveTrain& wave, const Vec3& place) {
    const double along = place.x() * std::cos(wave.direction) + place.y() * std::sin(wave.direction);
    return wave.amplitude * std::cos(wave.number * along + wave.phase);
}

}  // namespace

TEST_CASE("water, waves, wind and ground turn about z with their model", "[study]") {
    const Model model = read(deck()).model;
    Model turned = model;
    const Quat rotation = restrict_rotation(Quat(0.3, 0.7, -0.2, 0.6).normalized(), model);
    CHECK((rotation * Vec3::UnitZ() - Vec3::UnitZ()).norm() < 1e-15);
    CHECK(std::abs(rotation.z()) > 0.5);
    turn_model(rotation, turned);
    const Vec3 place(3.0, -2.0, 1.5);
    const Surroundings& one = model.surroundings;
    const Surroundings& other = turned.surroundings;
    const auto current = [](const Surroundings& s) { return s.water->current.profile->direction; };
    CHECK((current(other) - rotation * current(one)).norm() < 1e-15);
    CHECK((other.air->wind.field(0.0, rotation * place) - rotation * one.air->wind.field(0.0, place)).norm() <
          1e-14);
    CHECK(elevation(other.water->waves[0], rotation * place) ==
          Approx(elevation(one.water->waves[0], place)).epsilon(1e-13));
    CHECK(find_ground(*other.seabed, rotation * place).gap ==
          Approx(find_ground(*one.seabed, place).gap).epsilon(1e-13));
}

TEST_CASE("a plane model turns in its plane, and by half a turn where up is known", "[study]") {
    const Quat rotation = Quat(0.3, 0.7, -0.2, 0.6).normalized();
    Model model = read("plane = \"xz\"\n" + tube_deck("")).model;
    const Quat about_y = restrict_rotation(rotation, model);
    CHECK((about_y * Vec3::UnitY() - Vec3::UnitY()).norm() < 1e-15);
    CHECK(std::abs(about_y.y()) > 0.1);
    CHECK(*find_small_turn(model) == Vec3::UnitY());
    model = read("plane = \"xz\"\n" + tube_deck() + water_deck).model;
    CHECK((restrict_rotation(rotation, model) * Vec3(1, 2, 3) - Vec3(-1, -2, 3)).norm() < 1e-15);
    CHECK_FALSE(find_small_turn(model));
    model.plane->normal = 2;
    CHECK((restrict_rotation(rotation, model) * Vec3::UnitZ() - Vec3::UnitZ()).norm() < 1e-15);
    CHECK(*find_small_turn(model) == Vec3::UnitZ());
}

TEST_CASE("a model without surroundings turns in any way, a grid of the ground about z", "[study]") {
    const Quat rotation = Quat(0.3, 0.7, -0.2, 0.6).normalized();
    CHECK(restrict_rotation(rotation, read(tube_deck("")).model).isApprox(rotation, 0.0));
    const std::string file = GXROD_SOURCE_DIR "/tests/deck/surroundings/bed.csv";
    const Model model =
        read(tube_deck() + "[seabed]\nstiffness = 1\ngrid = { file = \"" + file + "\" }\n").model;
    Model turned = model;
    const Quat about_z = restrict_rotation(rotation, model);
    turn_model(about_z, turned);
    for (const Vec3& place : {Vec3(0.3, 0.4, 1.0), Vec3(-2.0, 0.7, 0.0)}) {
        const GroundAt one = find_ground(*model.surroundings.seabed, place);
        const GroundAt other = find_ground(*turned.surroundings.seabed, about_z * place);
        CHECK(other.gap == Approx(one.gap).epsilon(1e-13));
        CHECK((other.normal - about_z * one.normal).norm() < 1e-14);
        CHECK((other.gap_gradient - about_z * one.gap_gradient).norm() < 1e-13);
        const Mat3 R = about_z.toRotationMatrix();
        CHECK((other.normal_gradient - R * one.normal_gradient * R.transpose()).norm() < 1e-13);
    }
}

}  // namespace gxrod::test
