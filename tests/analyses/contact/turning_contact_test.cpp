// What touches obstacles and other rods in a frame that turns.
#include "analyses/contact/contact_run.hpp"
#include "check/motions/turning_loads.hpp"
#include "tools/catch.hpp"

using Catch::Contains;

namespace gxrod::test {
namespace {

constexpr double mass = 0.5, stiffness = 40.0, omega = 4.0;

// A bob on a spring to the z axis, about which it turns.
std::string bob_in(const std::string& obstacle) {
    return fmt::format(R"([body.bob]
mass = {}
inertia = [1, 1, 1]
at = [1, 0, 0]
sphere = {{ radius = 0.05, force = 50 }}
[[support]]
at = "bob"
fix = ["y", "z", "rotation"]
[spring.s]
between = ["ground", "bob"]
at_a = [0, 0, 0]
stiffness = {}
[rotation]
axis = [0, 0, 1]
speed = {}
[analysis]
kind = "steady"
steps = 10
[obstacle.o]
)",
                       mass,
                       stiffness,
                       omega) +
           obstacle;
}

const std::string drum =
    "cylinder = { from = [0, 0, -1], to = [0, 0, 1], radius = 1.1, side = \"inside\" }\n";

}  // namespace

TEST_CASE("What turns presses on a drum with what its spring does not hold", "[analyses][touch]") {
    // Without the drum it stands at r = k/(k − m Ω²) = 1.25.
    ContactRun run(bob_in(drum));
    run.finish();
    const double r = run.at("bob").r.x();
    CHECK(r > 1.049);
    CHECK(r < 1.05);
    const double pressed = mass * omega * omega * r - stiffness * (r - 1.0);
    CHECK(run.obstacle().force.x() == Approx(pressed).epsilon(1e-8));
}

TEST_CASE("Obstacles that are not alike to all sides do not go with a turning frame", "[analyses][touch]") {
    const auto cause = [](const std::string& obstacle) {
        const Problem problem = read(bob_in(obstacle));
        return find_unsteady_action(problem.model, *problem.model.rotation);
    };
    CHECK(cause(drum).empty());
    CHECK(cause("plane = { point = [0, 0, -1], normal = [0, 0, 1] }").empty());
    CHECK(cause("sphere = { centre = [0, 0, 3], radius = 1 }").empty());
    CHECK_THAT(cause(drum + "friction = 0.1"), Contains("obstacle o rubs"));
    CHECK_THAT(cause("plane = { point = [0, 0, -1], normal = [0, 0, 1] }\nmove = { z = \"0.1*t\" }"),
               Contains("obstacle o moves"));
    for (const char* shape :
         {"plane = { point = [0, 0, -1], normal = [0, 0.6, 0.8] }",
          "sphere = { centre = [0.1, 0, 3], radius = 1 }",
          "cylinder = { from = [0, 0.1, -1], to = [0, 0, 1], radius = 1.2, side = \"inside\" }"})
        CHECK_THAT(cause(shape), Contains("obstacle o is not alike to all sides of the axis of rotation"));
}

TEST_CASE("Rods that turn press on each other as under centrifugal forces", "[analyses][touch]") {
    // A massless arm with a weight at its end, which leans on a post.
    const std::string arm = R"([section.s]
stiffness = { EA = 1e3, GAy = 5e2, GAz = 5e2, GJ = 1, EIy = 1, EIz = 1 }
inertia = { rhoA = 1e-9, rhoJ = 1e-12, rhoIy = 1e-12, rhoIz = 1e-12 }
radius = 0.01
[rod.arm]
section = "s"
line = { from = [0.05, 0, 0], to = [0.05, 0, 1] }
elements = 6
[rod.post]
section = "s"
line = { from = [0.1, -0.5, 0.8], to = [0.1, 0.5, 0.8] }
elements = 6
[contact]
[body.tip]
mass = 0.3
at = "arm.end"
[[support]]
at = "arm.start"
fix = "all"
[[support]]
at = "post.start"
fix = "all"
[[support]]
at = "post.end"
fix = "all"
)";
    ContactRun turning(
        arm + "[rotation]\naxis = [0, 0, 1]\nspeed = 4\n[analysis]\nkind = \"steady\"\nsteps = 10\n");
    turning.finish();
    ContactRun still(arm +
                     "[[load]]\nat = \"arm.end\"\nforce = [\"0.3*16*x\", \"0.3*16*y\", 0]\n"
                     "[analysis]\nkind = \"static\"\nsteps = 10\n");
    still.finish();
    REQUIRE(turning.touches().size() > 0);
    CHECK((turning.at("arm.end").r - still.at("arm.end").r).norm() < 1e-8);
    CHECK((turning.reaction("post.start") - still.reaction("post.start")).norm() < 1e-7);
    CHECK(turning.reaction("post.start").head<3>().norm() > 0.05);
}

}  // namespace gxrod::test
