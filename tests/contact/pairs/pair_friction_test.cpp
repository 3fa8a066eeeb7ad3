#include "contact/pairs/pair_friction.hpp"

#include <cmath>

#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr PairLaw wires{0.3, {0.05, 40.0}};

// Two rods that cross, which moved and turned a little.
struct Crossing {
    PairMotion motion;
    CoulombFriction friction{0.4, 20.0, Vec3(0.1, -0.2, 0.05)};

    explicit Crossing(unsigned seed) {
        RandomValues random(seed);
        motion.positions = {Vec3(-1, 0, 0), Vec3(1, 0.1, 0), Vec3(0.1, -1, 0.315), Vec3(0, 1, 0.325)};
        for (std::size_t i = 0; i < 4; ++i) {
            motion.positions_before[i] = motion.positions[i] + random.vector(0.02);
            motion.rotations[i] = random.vector(0.1);
        }
        motion.radius_a = 0.1;
        motion.radius_b = 0.2;
    }
    PairEnergy energy() const {
        const auto& x = motion.positions;
        return compute_pair_energy(wires, {x[0], x[1]}, {x[2], x[3]}, 2.0, 2.0);
    }
    PairFriction force() const { return compute_pair_friction(energy(), motion, friction); }
};

double tangent_error(const Crossing& crossing) {
    const Mat24 found =
        compute_pair_friction_derivative(crossing.energy(), crossing.motion, crossing.friction);
    Mat24 expected;
    for (int column = 0; column < 24; ++column) {
        const auto end = static_cast<std::size_t>(column / 6);
        expected.col(column) = differentiate(
            [&](double amount) {
                Crossing moved = crossing;
                const int k = column % 6;
                (k < 3 ? moved.motion.positions[end][k] : moved.motion.rotations[end][k - 3]) += amount;
                return moved.force().forces;
            },
            1e-5);
    }
    return (found - expected).norm() / expected.norm();
}

// Both rods moved and turned as one body from where they are.
PairMotion move_together(PairMotion motion, const Vec3& rotation) {
    motion.positions_before = motion.positions;
    for (std::size_t i = 0; i < 4; ++i) {
        motion.positions[i] = exp_matrix(rotation) * motion.positions[i] + Vec3(0.3, 0.1, -0.2);
        motion.rotations[i] = rotation;
    }
    return motion;
}

}  // namespace

TEST_CASE("Friction of two pieces: its tangent is the derivative of its forces", "[contact]") {
    for (unsigned seed = 1; seed < 6; ++seed) {
        Crossing crossing(seed);
        REQUIRE(crossing.energy().energy > 0.0);
        INFO(seed);
        crossing.friction.stiffness = 2.0;
        crossing.friction.coefficient = 5.0;
        CHECK_FALSE(crossing.force().traction.slides);
        CHECK(tangent_error(crossing) < 1e-7);
        crossing.friction.coefficient = 0.01;
        crossing.friction.stiffness = 200.0;
        CHECK(crossing.force().traction.slides);
        CHECK(tangent_error(crossing) < 1e-7);
        crossing.friction.slip = Slip::slides;
        crossing.friction.direction = Vec3(0.6, -0.8, 0.0);
        CHECK(tangent_error(crossing) < 1e-7);
    }
}

TEST_CASE("Friction of two pieces by direction and speed: its tangent is the derivative of its forces",
          "[contact]") {
    static constexpr FrictionShape shape{0.2, 0.6, 1.0, 0.5, 0.1};
    for (unsigned seed = 1; seed < 6; ++seed) {
        Crossing crossing(seed);
        INFO(seed);
        crossing.friction.coefficient = 0.01;
        crossing.friction.stiffness = 200.0;
        crossing.friction.shape = &shape;
        crossing.friction.elapsed = 0.2;
        // Of the second axis only whether it has one.
        crossing.friction.axes = {Vec3::UnitX(), seed % 2 == 0 ? Vec3(Vec3::Zero()) : Vec3(Vec3::UnitY())};
        CHECK(crossing.force().traction.slides);
        CHECK(tangent_error(crossing) < 1e-7);
        crossing.friction.slip = Slip::slides;
        crossing.friction.direction = Vec3(0.6, -0.8, 0.0);
        CHECK(tangent_error(crossing) < 1e-7);
    }
}

TEST_CASE(
    "Friction of two pieces: a rod that slides along itself meets its own coefficient and that across "
    "of the other",
    "[contact]") {
    static constexpr FrictionShape shape{0.2, 0.6, 1.0, 1.0, 0.0};
    Crossing crossing(1);
    crossing.motion.positions = {Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(0, -1, 0.32), Vec3(0, 1, 0.32)};
    crossing.motion.rotations.fill(Vec3::Zero());
    crossing.friction = {0.4, 2e6};
    crossing.friction.shape = &shape;
    crossing.friction.axes = {Vec3::UnitX(), Vec3::UnitY()};
    const double pressed = find_pair_place(crossing.energy(), crossing.motion).force;
    // What the first part meets that moves so past the second.
    const auto traction_of = [&](const Vec3& slip) {
        crossing.motion.positions_before = crossing.motion.positions;
        for (std::size_t i = 0; i < 2; ++i) crossing.motion.positions_before[i] -= slip;
        return Vec3(crossing.force().traction.value / (0.4 * pressed));
    };
    CHECK((traction_of(Vec3(0.01, 0, 0)) - Vec3(-0.5 * (0.2 + 1.0), 0, 0)).norm() < 1e-9);
    CHECK((traction_of(Vec3(-0.01, 0, 0)) - Vec3(0.5 * (0.6 + 1.0), 0, 0)).norm() < 1e-9);
    // The second slides backward along itself if the first moves along it, and the other way around.
    CHECK((traction_of(Vec3(0, 0.01, 0)) - Vec3(0, -0.5 * (0.6 + 1.0), 0)).norm() < 1e-9);
    CHECK((traction_of(Vec3(0, -0.01, 0)) - Vec3(0, 0.5 * (0.2 + 1.0), 0)).norm() < 1e-9);
}

TEST_CASE("Friction of two pieces: forces and moments are in balance, do work as the slip does",
          "[contact]") {
    Crossing crossing(1);
    crossing.friction.stiffness = 2e4;
    const PairFriction there = crossing.force();
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
        const auto own = there.forces.segment<6>(6 * static_cast<Eigen::Index>(i));
        force += own.head<3>();
        moment += crossing.motion.positions[i].cross(own.head<3>()) + own.tail<3>();
    }
    CHECK(there.forces.norm() > 0.1);
    CHECK(force.norm() < 1e-14);
    CHECK(moment.norm() < 1e-14);
    CHECK(there.traction.slides);
    const PairPlace at = find_pair_place(crossing.energy(), crossing.motion);
    CHECK(there.traction.value.norm() == Approx(0.4 * at.force));
    CHECK(std::abs(there.traction.value.dot(at.normal)) < 1e-14);
    // Where the lines cross.
    CHECK(at.s == Approx(0.525).margin(2e-3));
    CHECK(at.t == Approx(0.524).margin(2e-3));
}

TEST_CASE("Friction of two pieces: nothing slips where both turn together, nor where one rolls on the other",
          "[contact]") {
    Crossing crossing(1);
    crossing.friction.traction.setZero();
    SECTION("together, by any angle") {
        crossing.motion = move_together(crossing.motion, Vec3(0.4, -0.7, 1.1));
        CHECK(crossing.force().slip.norm() < 1e-14);
    }
    SECTION("what stuck turns with them") {
        crossing.friction.traction = Vec3(0.01, 0.02, 0);
        const Vec3 rotation(0.4, -0.7, 1.1);
        const Vec3 stuck = [&] {
            PairMotion still = crossing.motion;
            still.positions_before = still.positions;
            still.rotations.fill(Vec3::Zero());
            return compute_pair_friction(crossing.energy(), still, crossing.friction).traction.value;
        }();
        crossing.motion = move_together(crossing.motion, rotation);
        CHECK(relative_difference(crossing.force().traction.value, exp_matrix(rotation) * stuck) < 1e-12);
    }
    SECTION("a rod that rolls around a parallel one that is held, and two that drive each other") {
        const double angle = 0.7, distance = 0.31;
        PairMotion& motion = crossing.motion;
        const Vec3 along(0, 0, 1), before(distance, 0, 0);
        const Vec3 after(distance * std::cos(angle), distance * std::sin(angle), 0);
        motion.positions = {after - along, after + along, -along, along};
        motion.positions_before = {before - along, before + along, -along, along};
        // About its own axis in all (r + r')/r times the angle.
        const Vec3 turn = angle * (0.3 / 0.1) * along;
        motion.rotations = {turn, turn, Vec3::Zero(), Vec3::Zero()};
        CHECK(crossing.force().slip.norm() < 1e-14);
        motion.positions_before = motion.positions;
        motion.rotations = {-0.4 * along, -0.4 * along, 0.2 * along, 0.2 * along};
        CHECK(crossing.force().slip.norm() < 1e-14);
        motion.rotations[2] = motion.rotations[3] = -0.2 * along;
        CHECK(crossing.force().slip.norm() > 0.05);
    }
}
