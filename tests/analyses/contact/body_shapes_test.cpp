// Bodies that touch by several shapes, against closed forms.
#include "analyses/contact/contact_run.hpp"
#include "assembly/contact/contacts.hpp"

namespace gxrod::test {
namespace {

const std::string even_ground = "[obstacle.floor]\nplane = { point = [0, 0, 0], normal = [0, 0, 1] }\n";

}  // namespace

TEST_CASE("A table stands on each foot as levers say", "[analyses][touch][bodies]") {
    // Feet at the corners of a triangle, the centre of mass within.
    ContactRun run(R"(
gravity = [0, 0, -10]
[body.table]
mass = 3
inertia = [1, 1, 1]
at = [0, 0, 0.5]
centre_of_mass = [0.3, 0.2, 0]
sphere = [
    { radius = 0.1, centre = [0, 0, -0.39850] },
    { radius = 0.1, centre = [1, 0, -0.39850] },
    { radius = 0.05, centre = [0, 1, -0.44925] },
]
)" + even_ground + R"(
friction = 0.2
[analysis]
kind = "static"
steps = 1
)");
    run.finish();
    const std::vector<ContactTouch> touches = run.touches();
    REQUIRE(touches.size() == 3);
    const NodeMotion& table = run.at("table");
    const Vec3 centre = table.r + table.Lambda * Vec3(0.3, 0.2, 0);
    Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
    double friction = 0.0;
    for (const ContactTouch& one : touches) {
        // Of 30 N, by the places of the feet before it sinks by a skin and tilts.
        const double share = one.point.x() > 0.5 ? 0.3 : one.point.y() > 0.5 ? 0.2 : 0.5;
        CHECK(one.normal_force.z() == Approx(30.0 * share).epsilon(2e-3));
        const Vec3 force = one.normal_force + one.friction_force;
        sum += force;
        friction += one.friction_force.norm();
        moment += (one.point - centre).cross(force);
    }
    CHECK((sum - Vec3(0, 0, 30)).norm() < 1e-6 * 30.0);
    // Points are half way between both surfaces: friction acts half a gap from there, of the skin at most.
    CHECK(moment.norm() < 0.5 * 2e-3 * friction + 1e-6 * 30.0);
    CHECK(run.obstacle().force.z() == Approx(-30.0).epsilon(1e-8));
}

TEST_CASE("A ball lies between the two bars of a body", "[analyses][touch][bodies]") {
    ContactRun run(R"(
gravity = [0, 0, -10]
[body.bars]
mass = 1
inertia = [1, 1, 1]
capsule = [
    { from = [-0.3, -1, 0], to = [-0.3, 1, 0], radius = 0.1, force = 1e4 },
    { from = [0.3, -1, 0], to = [0.3, 1, 0], radius = 0.1, force = 1e4 },
]
[body.ball]
mass = 2
inertia = [1, 1, 1]
at = [0, 0.1, 0.4015]
sphere = { radius = 0.4, force = 1e4 }
[contact]
[[support]]
at = "bars"
fix = "all"
[[support]]
at = "ball"
fix = ["y", "rotation"]
[analysis]
kind = "static"
steps = 1
)");
    run.finish();
    const std::vector<ContactTouch> touches = run.touches();
    REQUIRE(touches.size() == 2);
    const double height = run.at("ball").r.z();
    for (const ContactTouch& one : touches) {
        CHECK(one.rods == std::array{0, 1});
        // Half of 20 N each, along the line from bar to ball.
        CHECK(std::abs(one.normal_force.z()) == Approx(10.0).epsilon(1e-6));
        CHECK(std::abs(one.normal_force.x()) == Approx(10.0 * 0.3 / height).epsilon(1e-6));
    }
    CHECK(std::hypot(0.3, height) > 0.5);
    CHECK(std::hypot(0.3, height) < 0.502);
    CHECK(run.reaction("bars")[2] == Approx(10.0 + 20.0).epsilon(1e-6));
}

TEST_CASE("A dumbbell that lands on one ball turns as the impulse says", "[analyses][touch][bodies]") {
    constexpr double mass = 2.0, inertia = 0.1, half = 0.3, tilt = 0.4, speed = 3.0, e = 0.6;
    ContactRun run(fmt::format(R"(
[body.dumbbell]
mass = {}
inertia = [0.02, {}, {}]
at = [0, 0, {}]
rotation_vector = [0, {}, 0]
velocity = [0, 0, {}]
sphere = [
    {{ radius = 0.1, centre = [{}, 0, 0], force = 2e6 }},
    {{ radius = 0.1, centre = [{}, 0, 0], force = 2e6 }},
]
{}restitution = {}
[contact]
skin = 2e-3
[analysis]
kind = "dynamic"
end_time = 4e-4
integrator = "radau-5"
accuracy = 1e-7
)",
                               mass,
                               inertia,
                               inertia,
                               half * std::sin(tilt) + 0.1003,
                               tilt,
                               -speed,
                               -half,
                               half,
                               even_ground,
                               e));
    run.finish();
    // The ball at +x hits, at this distance beside the centre of mass.
    const double arm = half * std::cos(tilt);
    const double impulse = (1.0 + e) * speed / (1.0 / mass + arm * arm / inertia);
    const NodeMotion& motion = run.at("dumbbell");
    CHECK(motion.v.isApprox(Vec3(0, 0, -speed + impulse / mass), 1e-3));
    CHECK(motion.omega.isApprox(Vec3(0, -arm * impulse / inertia, 0), 1e-3));
    CHECK(std::abs(run.ledger().energy_error) < 1e-6);
}

TEST_CASE("Shapes of one body may overlap, those of two may not", "[analyses][touch][bodies]") {
    const std::string deck = R"(
gravity = [0, 0, -10]
[body.cart]
mass = 1
inertia = [1, 1, 1]
at = [0, 0, 1]
sphere = [{ radius = 0.2 }, { radius = 0.2, centre = [0.1, 0, 0] }]
capsule = { from = [0, 0, 0], to = [0, 0, 0.5], radius = 0.1 }
[body.other]
mass = 1
inertia = [1, 1, 1]
at = [HERE, 0, 1]
sphere = { radius = 0.2 }
[contact]
[obstacle.floor]
plane = { point = [0, 0, FLOOR], normal = [0, 0, 1] }
[analysis]
kind = "dynamic"
end_time = 1e-3
time_step = 1e-3
)";
    const auto with = [&](const std::string& here, const std::string& floor) {
        std::string own = deck;
        own.replace(own.find("HERE"), 4, here);
        own.replace(own.find("FLOOR"), 5, floor);
        return own;
    };
    ContactRun(with("2", "0")).finish();
    const auto overlap_of = [&](const std::string& lines) {
        const Problem problem = read(lines);
        const System system(problem.model);
        State state = system.initial_state();
        Contacts(system).search(state);
        return Contacts(system).describe_overlap(state, 0.0);
    };
    CHECK_THAT(overlap_of(with("0.4", "0")),
               Catch::Contains("sphere 2 of cart and other overlap: they are 0.3 apart"));
    CHECK_THAT(overlap_of(with("2", "0.85")), Catch::Contains("sphere 1 of cart is 0.05 deep in obstacle"));
}

}  // namespace gxrod::test
