// How static runs succeed: steps that fail are cut, elements that turn too far are reported, the books close.
#include <numbers>

#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/rod_models.hpp"
#include "tools/static_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

using std::numbers::pi;

// S3, the 45-degree bend of Bathe & Bolourchi, GJ = G/6.
Model make_bend(double force, const Mesh& mesh) {
    const Line arc = [](double s) {
        const double angle = s / 100.0;
        return Placement{100.0 * Vec3(std::sin(angle), 1.0 - std::cos(angle), 0.0),
                         exp_quaternion(angle * Vec3::UnitZ())};
    };
    const Section section = make_section({1e7, 5e6, 5e6, 5e6 / 6.0, 1e7 / 12.0, 1e7 / 12.0});
    Model model = make_rod_model(arc, 25.0 * pi, mesh, section);
    clamp(model, 0);
    add_ramp(model, last_node(model), Vec3(0.0, 0.0, force), Vec3::Zero());
    return model;
}

// Length 10, EI = 100, under an end couple that bends every element by `angle`.
Model make_bent_elements(double angle, int elements, const Vec3& axis, const Mesh& mesh) {
    Model model = make_rod_model(
        along_x, 10.0, {elements, mesh.order, mesh.kind}, make_section({1e4, 1e4, 1e4, 100.0, 100.0, 100.0}));
    clamp(model, 0);
    add_ramp(model, last_node(model), Vec3::Zero(), elements * angle * 100.0 / 10.0 * axis);
    return model;
}

}  // namespace

TEST_CASE("a step that is too long is cut and the run recovers", "[analyses][static]") {
    const Model model = make_bend(600.0, {8, 1});
    const StaticRun fine = run_static(model, make_static_settings(30));
    CHECK(fine.rejected_steps == 0);
    StaticSettings coarse = make_static_settings(1);
    coarse.newton.tangent = TangentKind::consistent;
    StaticAnalysis analysis(model, coarse);
    REQUIRE(analysis.start().converged());
    long rejected = 0;
    std::vector<double> steps;
    while (!analysis.finished()) {
        REQUIRE(analysis.advance().converged());
        rejected += analysis.solver_row().rejected_steps;
        steps.push_back(analysis.solver_row().time_step);
    }
    CHECK(rejected > 0);
    CHECK(steps.front() < 1.0);
    CHECK((analysis.state().trial.back().r - fine.tip().r).norm() < 1e-8);
}

TEST_CASE("an element that would be bent or twisted beyond half a turn is reported", "[analyses][static]") {
    for (const Vec3& axis : {Vec3(0.0, 0.0, 1.0), Vec3(1.0, 0.0, 0.0)}) {
        for (const long steps : {1L, 7L}) {
            // 0.9 of half a turn is reached, exactly; 1.1 is not, nor mistaken for its complement.
            const Model model = make_bent_elements(0.9 * pi, 2, axis, {0, 1});
            const StaticRun reached = run_static(model, make_static_settings(steps));
            CHECK(reached.tip().Lambda.angularDistance(exp_quaternion(1.8 * pi * axis)) < 1e-8);
            for (const SectionValues& values : reached.elements) {
                CHECK((values.curvature - 0.18 * pi * axis).norm() < 1e-8);
            }
            const Model too_much = make_bent_elements(1.1 * pi, 2, axis, {0, 1});
            const StaticRun refused = try_static(too_much, make_static_settings(steps));
            CHECK(refused.report.outcome == Outcome::element_too_turned);
            CHECK(refused.state.time < 1.0 / 1.1);
            CHECK(refused.state.time > 0.9);
            CHECK_THAT(
                refused.failure,
                Catch::Contains("one element's nodes turn against each other by half a turn at rod node"));
        }
    }
}

TEST_CASE("huge loads in one step end where many steps end, or are refused", "[analyses][static]") {
    // Ten turns of three elements and more: whatever converges must be the state that small steps lead to.
    for (const Vec3& axis : {Vec3(0.0, 0.0, 1.0), Vec3(1.0, 0.0, 0.0), Vec3(0.6, 0.0, 0.8)}) {
        for (const int elements : {2, 3, 5, 8}) {
            for (const double turns : {0.4, 1.3, 3.0, 10.0}) {
                INFO(elements << " elements, " << turns << " turns");
                const double angle = turns * 2.0 * pi / elements;
                const Model model = make_bent_elements(angle, elements, axis, {0, 1});
                const StaticRun run = try_static(model, make_static_settings(1));
                if (!run.report.converged()) {
                    CHECK(angle > 0.9 * pi);
                    continue;
                }
                const StaticRun fine = run_static(model, make_static_settings(100));
                CHECK((run.tip().r - fine.tip().r).norm() < 1e-7);
                CHECK(run.ledger.strain_energy == Approx(fine.ledger.strain_energy).epsilon(1e-9));
            }
        }
    }
}

TEST_CASE("a load that is there at load factor 0 does the work that the rod stores", "[analyses][static]") {
    Model model = make_bend(0.0, {4, 2});
    NodalLoad load;
    load.node = last_node(model);
    load.force = {0.0, 0.0, 1.0};
    model.loads.push_back(load);
    const StaticRun run = run_static(model, make_static_settings(4));
    CHECK(run.ledger.strain_energy > 1e-6);
    CHECK(std::abs(run.ledger.energy_error) < 1e-4 * run.ledger.strain_energy);
}

TEST_CASE("the energy error of statics falls with the square of the steps", "[analyses][static]") {
    Model model = make_bend(300.0, {4, 2});
    model.sections[0].mass.topLeftCorner<3, 3>().setIdentity();
    model.gravity = TimeVector({0.0, ramp(-20.0), 0.0});
    Support moved{.node = last_node(model)};
    moved.moved[0] = true;
    moved.motion[0] = ramp(-5.0);
    model.supports.push_back(moved);
    for (const ElementKind kind : {ElementKind::objective, ElementKind::simo}) {
        model.rods[0].kind = kind;
        std::vector<double> errors;
        for (const long steps : {20L, 40L, 80L}) {
            const StaticRun run = run_static(model, make_static_settings(steps));
            errors.push_back(std::abs(run.ledger.energy_error));
            CHECK(run.rejected_steps == 0);
            CHECK(errors.back() < 0.05 * run.ledger.strain_energy);
        }
        INFO("errors " << errors[0] << " " << errors[1] << " " << errors[2]);
        // Or faster, where equilibria in between were found for the work of the coarser steps.
        CHECK(std::log2(errors[0] / errors[1]) > 1.8);
        CHECK(std::log2(errors[1] / errors[2]) > 1.8);
    }
}

TEST_CASE("a rod sags by its weight as beams do", "[analyses][static]") {
    // q L⁴/8EI + q L²/2GA, q small enough for squares of slopes to vanish.
    constexpr double weight = 1e-6;
    for (int order = 1; order <= 4; ++order) {
        const auto measure = [&](int elements) {
            Model model = make_rod_model(along_x,
                                         2.0,
                                         {elements, order},
                                         make_section({1e3, 40.0, 50.0, 1.0, 2.0, 3.0}, {1, 1, 1, 0, 0, 0}));
            clamp(model, 0);
            model.gravity = TimeVector({0.0, 0.0, ramp(-weight)});
            const double sag = -run_static(model, make_static_settings(1)).tip().r.z();
            const double exact = weight * (16.0 / (8.0 * 2.0) + 4.0 / (2.0 * 50.0));
            return std::abs(sag / exact - 1.0);
        };
        INFO("order " << order << ": " << measure(1) << " " << measure(2));
        CHECK(measure(1) < 1e-11);
    }
}

TEST_CASE("moments do all their work in steps of whole turns too", "[analyses][static]") {
    // A helix of an isotropic section: its tip turns about one axis, its moment stays M, and W = M θ/2.
    for (const double turns : {1.0, 2.0, 3.0}) {
        for (const long steps : {1L, 2L, 3L}) {
            const Vec3 axis = Vec3(6.0, 3.0, 2.0) / 7.0;
            const Model model = make_bent_elements(turns * 2.0 * pi / 20.0, 20, axis, {0, 1});
            const StaticRun run = run_static(model, make_static_settings(steps));
            INFO(turns << " turns in " << steps << " steps");
            CHECK(run.rejected_steps == 0);
            const double angle = 2.0 * pi * turns;
            CHECK(run.ledger.external_work == Approx(0.5 * 100.0 / 10.0 * angle * angle).epsilon(1e-10));
            CHECK(std::abs(run.ledger.energy_error) < 1e-8);
        }
    }
}

TEST_CASE("a cable finds its shape from a straight line", "[analyses][static]") {
    // Hardly any stiffness against its first load: EI/(EA L²) = 1e-11. Of elastic cables, to (sag/L)²,
    // H = (EA w² L²/24)^⅓ and sag = w L²/(8H).
    Model model = make_rod_model(
        along_x, 100.0, {60, 1}, make_section({1e8, 1e7, 1e7, 10.0, 10.0, 10.0}, {10, 10, 10, 0, 0, 0}));
    model.supports.push_back({.node = 0, .fixed = {true, true, true, true, false, true}});
    model.supports.push_back({.node = last_node(model), .fixed = {true, true, true, false, false, false}});
    model.gravity = TimeVector(std::array<TimeFunction, 3>{0.0, 0.0, ramp(-9.81)});
    const double weight = 98.1;
    const double H = std::cbrt(1e8 * weight * weight * 1e4 / 24.0);
    const StaticRun run = run_static(model, make_static_settings(1, 1e-8));
    CHECK(run.steps < 60);
    CHECK(-run.node(30).r.z() == Approx(weight * 1e4 / (8.0 * H)).epsilon(2e-3));
    CHECK(-run.reactions[0][0] == Approx(H).epsilon(2e-3));
    CHECK(run.reactions[0][2] + run.reactions.back()[2] == Approx(100.0 * weight).epsilon(1e-7));
}
