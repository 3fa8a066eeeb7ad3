// Contact with the tangent by differences, which finds the same equilibria and motions.
#include "analyses/contact/contact_run.hpp"

namespace gxrod::test {
namespace {

// A cantilever is pressed onto one that crosses it.
std::string crossed(const std::string& analysis) {
    return R"([section.s]
shape = { circle = { radius = 0.01 } }
material = { E = 1e9, nu = 0.3, density = 1000 }
)" + rod("lower", "0, 0, 0", "1, 0, 0", 6) +
           rod("upper", "0.8, -0.6, 0.0205", "0.8, 0.4, 0.0205", 6) +
           R"([[support]]
at = "lower.start"
fix = "all"
[[support]]
at = "upper.start"
fix = ["x", "y", "rotation"]
move = { z = "-0.2*t^2" }
[contact]
skin = 0.02
[analysis]
)" + analysis;
}

// A cantilever is pressed onto a sphere.
std::string on_sphere(const std::string& analysis) {
    return R"([section.s]
shape = { circle = { radius = 0.01 } }
material = { E = 1e9, nu = 0.3, density = 1000 }
)" + rod("lower", "0, 0, 0", "1, 0, 0", 6) +
           R"([[support]]
at = "lower.start"
fix = "all"
[[load]]
at = "lower.end"
force = [0, 0, "-10*t^2"]
[obstacle.ball]
sphere = { centre = [0.6, 0.02, -0.16], radius = 0.1 }
[analysis]
)" + analysis;
}

void check_alike(const std::string& deck) {
    const auto with = [&](const std::string& tangent) {
        return deck + "newton = { tolerance = 1e-10, max_iterations = 60, tangent = \"" + tangent + "\" }\n";
    };
    ContactRun consistent(with("consistent")), differences(with("difference"));
    bool has_touched = false;
    while (!consistent.is_finished()) {
        consistent.step();
        has_touched = has_touched || !consistent.touches().empty();
    }
    differences.finish();
    CHECK(has_touched);
    CHECK(differences.touches().size() == consistent.touches().size());
    CHECK((differences.at("lower.end").r - consistent.at("lower.end").r).norm() < 1e-8);
    CHECK(differences.reaction("lower.start")[2] ==
          Approx(consistent.reaction("lower.start")[2]).epsilon(1e-6));
}

}  // namespace

TEST_CASE("differences find the equilibria of what touches", "[analyses][touch]") {
    check_alike(crossed("kind = \"static\"\nsteps = 10\n"));
    check_alike(on_sphere("kind = \"static\"\nsteps = 10\n"));
}

TEST_CASE("differences find the motions of what touches", "[analyses][touch]") {
    const std::string motion = "kind = \"dynamic\"\nintegrator = \"generalized-alpha\"\ntime_step = 0.005\n";
    check_alike(
        replaced(crossed(motion + "end_time = 0.85\n"), "skin = 0.02", "skin = 0.02\nfriction = 0.2"));
    check_alike(on_sphere(motion + "end_time = 0.6\n"));
}

}  // namespace gxrod::test
