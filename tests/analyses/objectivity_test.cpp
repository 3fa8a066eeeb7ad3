// A loaded rod whose clamp turns: after whole turns it must be where it was, by any way.
#include <numbers>

#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/rod_models.hpp"
#include "tools/static_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// Radius of the arc; the rod is an eighth of a circle.
constexpr double radius = 100.0;

Placement along_arc(double s) {
    const double angle = s / radius;
    return {radius * Vec3(std::sin(angle), 1.0 - std::cos(angle), 0.0),
            exp_quaternion(angle * Vec3::UnitZ())};
}

// Pulled up until t = ¼, its clamp turned about the tangent from then on.
Model make_turned_bend(const Mesh& mesh, double turns) {
    const Section section = make_section({1e7, 5e6, 5e6, 7e5, 8.3e5, 8.3e5});
    Model model = make_rod_model(along_arc, radius * std::numbers::pi / 4.0, mesh, section);
    Support support{.node = 0, .fixed = {true, true, true, false, true, true}};
    support.moved[3] = true;
    support.motion[3] = TimeFunction(
        [turns](double t) { return t < 0.25 ? 0.0 : 2.0 * std::numbers::pi * turns * (t - 0.25) / 0.75; });
    model.supports.push_back(support);
    NodalLoad load;
    load.node = last_node(model);
    load.force[2] = TimeFunction([](double t) { return 300.0 * std::min(1.0, 4.0 * t); });
    model.loads.push_back(load);
    return model;
}

// The end, and the strains and curvatures of the elements, after so many turns.
struct Bend {
    Vec3 end;
    std::vector<SectionValues> elements;
};
Bend turn(const Mesh& mesh, double turns, long steps) {
    const StaticRun run = run_static(make_turned_bend(mesh, turns), make_static_settings(steps));
    return {run.tip().r, run.elements};
}

}  // namespace

TEST_CASE("objective elements come back after whole turns, by steps of any length", "[analyses][static]") {
    for (int order = 1; order <= 4; ++order) {
        INFO("order " << order);
        const Mesh mesh{8 / order, order, ElementKind::objective};
        const Bend still = turn(mesh, 0.0, 10);
        for (const auto& [turns, steps] : {std::pair(1.0, 17L), {-2.0, 40L}, {7.0, 60L}}) {
            const Bend turned = turn(mesh, turns, steps);
            CHECK((turned.end - still.end).norm() < 1e-10 * radius);
            for (std::size_t i = 0; i < still.elements.size(); ++i) {
                const double scale = still.elements[i].curvature.norm();
                CHECK((turned.elements[i].curvature - still.elements[i].curvature).norm() < 1e-9 * scale);
            }
        }
    }
}

TEST_CASE("simo elements drift by as much in every turn, less on finer meshes", "[analyses][static]") {
    const auto drift = [](const Mesh& mesh, double turns) {
        return (turn(mesh, turns, static_cast<long>(20.0 * turns)).end - turn(mesh, 0.0, 10).end).norm();
    };
    const Mesh coarse{8, 1, ElementKind::simo};
    const double once = drift(coarse, 1.0);
    CHECK(once > 1e-4 * radius);
    CHECK(drift(coarse, 3.0) == Approx(3.0 * once).epsilon(0.1));
    CHECK(once / drift({16, 1, ElementKind::simo}, 1.0) == Approx(4.0).epsilon(0.1));
}
