#include "contact/shaped_traction.hpp"

#include <cmath>

#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr FrictionShape scales{.forward = 0.25, .backward = 0.5, .across = 1.0};
constexpr double pressed = 3.0, coefficient = 0.8;

// Friction of a rod along x on the plane z = 0.
CoulombFriction make_scaly(const FrictionShape& shape) {
    CoulombFriction friction{coefficient, 50.0};
    friction.shape = &shape;
    friction.axes[0] = Vec3::UnitX();
    return friction;
}

// The traction after so many equal slips, from none.
Vec3 slide(CoulombFriction friction, const Vec3& slip, int times) {
    for (int i = 0; i < times; ++i) {
        const Vec3 pull = friction.traction - friction.stiffness * slip;
        friction.traction = compute_traction(pull, Vec3::UnitZ(), pressed, friction).value;
    }
    return friction.traction;
}

// A friction in all that it depends on, on a plane that leans.
struct Rubbing {
    Vec3 pull = Vec3(1.1, -2.2, 0.4);
    Vec3 normal = Vec3(0.2, -0.3, 0.9).normalized();
    double force = pressed;
    CoulombFriction friction;

    Vec3 traction() const { return compute_traction(pull, normal, force, friction).value; }
};

// The largest error of a derivative, relative to the tractions.
double find_derivative_error(const Rubbing& given, double width = 1e-5) {
    const TractionDerivative found =
        compute_traction_derivative(given.pull, given.normal, given.force, given.friction);
    double error = 0.0;
    const auto compare = [&](const Vec3& column, const auto& move) {
        const Vec3 expected = differentiate(
            [&](double amount) {
                Rubbing moved = given;
                move(moved, amount);
                return moved.traction();
            },
            width);
        error = std::max(error, (column - expected).norm());
    };
    for (Eigen::Index k = 0; k < 3; ++k) {
        compare(found.by_pull.col(k), [&](Rubbing& one, double amount) { one.pull[k] += amount; });
        const Vec3 turn = Vec3::Unit(k) - given.normal * given.normal[k];
        compare(found.by_normal * turn, [&](Rubbing& one, double amount) {
            one.normal = (given.normal + amount * turn).normalized();
        });
        compare(found.by_traction.col(k),
                [&](Rubbing& one, double amount) { one.friction.traction[k] += amount; });
        for (std::size_t axis = 0; axis < 2; ++axis) {
            if (given.friction.axes[axis].isZero(0.0)) continue;
            compare(found.by_axes[axis].col(k),
                    [&](Rubbing& one, double amount) { one.friction.axes[axis][k] += amount; });
        }
    }
    compare(found.by_force, [](Rubbing& one, double amount) { one.force += amount; });
    return error;
}

}  // namespace

TEST_CASE("Directed friction: with equal coefficients it is that of Coulomb", "[contact]") {
    const FrictionShape equal{};
    RandomValues random(1);
    for (int i = 0; i < 20; ++i) {
        const CoulombFriction shaped = make_scaly(equal);
        CoulombFriction plain = shaped;
        plain.shape = nullptr;
        const Vec3 pull = random.vector(4.0);
        const Traction one = compute_traction(pull, Vec3::UnitZ(), pressed, shaped);
        const Traction other = compute_traction(pull, Vec3::UnitZ(), pressed, plain);
        CHECK((one.value - other.value).norm() < 1e-14);
        CHECK(one.slides == other.slides);
    }
}

TEST_CASE("Directed friction: each part of the slip meets its own coefficient", "[contact]") {
    const auto traction_of = [](const Vec3& slip) { return slide(make_scaly(scales), 0.3 * slip, 400); };
    const double most = coefficient * pressed;
    CHECK((traction_of(Vec3::UnitX()) - Vec3(-0.25 * most, 0, 0)).norm() < 1e-12);
    CHECK((traction_of(-Vec3::UnitX()) - Vec3(0.5 * most, 0, 0)).norm() < 1e-12);
    CHECK((traction_of(Vec3::UnitY()) - Vec3(0, -most, 0)).norm() < 1e-12);
    // F = −N (μ_t cos α, μ_n sin α): Hu, Nirody, Scott and Shelley (2009).
    const double angle = 0.7;
    CHECK((traction_of(Vec3(std::cos(angle), std::sin(angle), 0)) -
           Vec3(-0.25 * most * std::cos(angle), -most * std::sin(angle), 0))
              .norm() < 1e-12);
}

TEST_CASE("Directed friction: it sticks in an ellipse, of another half axis forward than backward",
          "[contact]") {
    const CoulombFriction friction = make_scaly(scales);
    const double most = coefficient * pressed;
    const auto slides = [&](double along, double across) {
        return compute_traction(Vec3(along, across, 5.0), Vec3::UnitZ(), pressed, friction).slides;
    };
    // What pulls forward holds a rod that would slide backward.
    CHECK_FALSE(slides(0.499 * most, 0.0));
    CHECK(slides(0.501 * most, 0.0));
    CHECK_FALSE(slides(-0.249 * most, 0.0));
    CHECK(slides(-0.251 * most, 0.0));
    CHECK_FALSE(slides(0.5 * most * 0.6, 0.799 * most));
    CHECK(slides(0.5 * most * 0.6, 0.801 * most));
}

TEST_CASE("Directed friction: the return is along the slip, and dissipates", "[contact]") {
    RandomValues random(2);
    constexpr FrictionShape slippery{.forward = 0.0, .backward = 1.0, .across = 0.3};
    for (const FrictionShape& shape : {scales, slippery}) {
        for (int i = 0; i < 200; ++i) {
            CoulombFriction friction = make_scaly(shape);
            if (i % 2 == 0) friction.axes[1] = random.vector(1.0).normalized();
            const Vec3 normal = random.vector(1.0).normalized();
            const Vec3 pull = random.vector(6.0);
            const Traction traction = compute_traction(pull, normal, pressed, friction);
            const std::optional<Vec3> against = find_shaped_slip(pull, normal, pressed, friction);
            CHECK(traction.slides == against.has_value());
            if (!against) continue;
            const Vec3 slip = pull - normal * normal.dot(pull) - traction.value;
            CHECK((slip - slip.norm() * *against).norm() < 1e-12 * pull.norm());
            CHECK(slip.dot(traction.value) >= -1e-14);
            CHECK(std::abs(traction.value.dot(normal)) < 1e-13);
            CHECK(traction.value.norm() <= coefficient * pressed * (1.0 + 1e-14));
        }
    }
}

TEST_CASE("Friction that weakens: it holds up to its coefficient at rest and falls with the speed",
          "[contact]") {
    constexpr FrictionShape weak{.kinetic = 0.4, .stribeck_speed = 0.2};
    CoulombFriction friction = make_scaly(weak);
    const double most = coefficient * pressed;
    friction.elapsed = 0.1;
    CHECK(find_share_at_speed(weak, 0.0) == 1.0);
    for (const double speed : {0.05, 0.2, 0.5, 3.0}) {
        const double share = 0.4 + 0.6 * std::exp(-speed * speed / 0.04);
        CHECK(find_share_at_speed(weak, speed) == Approx(share).epsilon(1e-14));
        CHECK((slide(friction, Vec3(0, speed * 0.1, 0), 50) - Vec3(0, -share * most, 0)).norm() < 1e-12);
    }
    // Without time nothing has a speed.
    friction.elapsed = 0.0;
    CHECK((slide(friction, Vec3(0, 0.3, 0), 50) - Vec3(0, -most, 0)).norm() < 1e-12);
}

TEST_CASE("Directed friction: what is on the cone but for rounding turns with its slip", "[contact]") {
    Rubbing rubbing;
    rubbing.friction = make_scaly(scales);
    rubbing.friction.slip = Slip::slides;
    rubbing.pull = slide(make_scaly(scales), Vec3(0.03, 0.02, 0.0), 400) * (1.0 - 1e-6);
    rubbing.normal = Vec3::UnitZ();
    rubbing.friction.direction = rubbing.pull.normalized();
    CHECK((rubbing.traction() - rubbing.pull / (1.0 - 1e-6)).norm() < 1e-5);
    CHECK(find_derivative_error(rubbing, 1e-7) < 1e-7);
    // It resists what turns its direction.
    CHECK(
        compute_traction_derivative(rubbing.pull, rubbing.normal, pressed, rubbing.friction).by_pull.norm() >
        0.1);
}

TEST_CASE("Directed friction that weakens: derivatives agree with differences", "[contact]") {
    const FrictionShape shape{0.25, 0.5, 1.0, 0.4, 0.8};
    Rubbing rubbing;
    rubbing.friction = make_scaly(shape);
    rubbing.friction.traction = Vec3(0.1, 0.3, -0.2);
    rubbing.friction.stiffness = 5.0;
    SECTION("one axis") {}
    SECTION("two axes") { rubbing.friction.axes[1] = Vec3(-0.3, 0.8, 0.1); }
    SECTION("none") { rubbing.friction.axes[0].setZero(); }
    SECTION("pulled back") { rubbing.pull = -rubbing.pull; }
    for (const double elapsed : {0.0, 0.4}) {
        rubbing.friction.elapsed = elapsed;
        rubbing.friction.slip = Slip::by_law;
        rubbing.force = 100.0;
        CHECK(find_derivative_error(rubbing) < 1e-8);
        rubbing.force = 1.2;
        REQUIRE(compute_traction(rubbing.pull, rubbing.normal, rubbing.force, rubbing.friction).slides);
        CHECK(find_derivative_error(rubbing) < 1e-8);
        // As iterations assume it: in this direction, or where its pull takes it.
        rubbing.friction.slip = Slip::slides;
        rubbing.friction.direction = rubbing.pull.normalized();
        CHECK(find_derivative_error(rubbing) < 1e-8);
        rubbing.friction.direction = Vec3(0.5, 0.7, 0.1).normalized();
        CHECK(find_derivative_error(rubbing) < 1e-8);
        rubbing.force = 100.0;
        CHECK(find_derivative_error(rubbing) < 1e-8);
        rubbing.friction.slip = Slip::sticks;
        CHECK(find_derivative_error(rubbing) < 1e-8);
    }
}
