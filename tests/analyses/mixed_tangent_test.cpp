// What the mixed tangent is for: large steps in few iterations, to the same equilibria.
#include <cmath>
#include <numbers>

#include "analyses/dynamic.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/rod_models.hpp"
#include "tools/static_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

using std::numbers::pi;
constexpr ElementKind kinds[] = {ElementKind::objective, ElementKind::simo};

// S1: EI = L = 1, EA = GA = slenderness², an end couple of one turn.
Model make_roll_up(double slenderness, const Mesh& mesh) {
    const double S = slenderness * slenderness;
    Model model = make_rod_model(along_x, 1.0, mesh, make_section({S, S, S, 1.0, 1.0, 1.0}));
    clamp(model, 0);
    add_ramp(model, last_node(model), Vec3::Zero(), Vec3(0.0, 0.0, 2.0 * pi));
    return model;
}

// S2 with P L²/EI = 10.
Model make_elastica(double slenderness, const Mesh& mesh) {
    Model model = make_roll_up(slenderness, mesh);
    model.loads.clear();
    add_ramp(model, last_node(model), Vec3(0.0, 10.0, 0.0), Vec3::Zero());
    return model;
}

// S3 at 600, GJ = G/6.
Model make_bend(const Mesh& mesh) {
    const Line arc = [](double s) {
        const double angle = s / 100.0;
        return Placement{100.0 * Vec3(std::sin(angle), 1.0 - std::cos(angle), 0.0),
                         exp_quaternion(angle * Vec3::UnitZ())};
    };
    const Section section = make_section({1e7, 5e6, 5e6, 5e6 / 6.0, 1e7 / 12.0, 1e7 / 12.0});
    Model model = make_rod_model(arc, 25.0 * pi, mesh, section);
    clamp(model, 0);
    add_ramp(model, last_node(model), Vec3(0.0, 0.0, 600.0), Vec3::Zero());
    return model;
}

StaticSettings with_tangent(TangentKind tangent, long steps, double tolerance = 1e-10) {
    StaticSettings settings = make_static_settings(steps, tolerance);
    settings.newton.tangent = tangent;
    return settings;
}

StaticRun run_mixed(const Model& model, long steps) {
    return run_static(model, with_tangent(TangentKind::mixed, steps));
}

// A damped cantilever with mass, let go under a load at its end.
Model make_damped_cantilever(const Mesh& mesh) {
    const Section section = [] {
        Section damped = make_section({1e4, 1e4, 1e4, 1.0, 1.0, 1.0}, {1.0, 1.0, 1.0, 0.01, 0.01, 0.01});
        damped.kelvin_voigt = 0.01;
        return damped;
    }();
    Model model = make_rod_model(along_x, 1.0, mesh, section);
    clamp(model, 0);
    add_ramp(model, last_node(model), Vec3(0.0, 4.0, 2.0), Vec3(1.0, 0.0, 0.0));
    return model;
}

State run_dynamic(const Model& model, Scheme scheme, TangentKind tangent) {
    DynamicSettings settings;
    settings.scheme = scheme;
    settings.end_time = 1.0;
    settings.steps = 50;
    settings.newton.tolerance = 1e-12;
    settings.newton.tangent = tangent;
    DynamicAnalysis analysis(model, settings);
    REQUIRE(analysis.start().converged());
    while (!analysis.finished()) {
        REQUIRE(analysis.advance().converged());
        REQUIRE(analysis.solver_row().rejected_steps == 0);
    }
    return analysis.state();
}

std::string name_of(ElementKind kind) { return kind == ElementKind::simo ? "simo" : "objective"; }

}  // namespace

TEST_CASE("a cantilever rolls up into a circle in one step of six iterations", "[analyses][static][mixed]") {
    for (const double slenderness : {1e2, 1e4}) {
        for (const auto& [elements, most_iterations] : {std::pair(10, 6), {100, 6}}) {
            for (int order = 1; order <= 4; ++order) {
                INFO("order " << order << ", " << elements << " elements, slenderness " << slenderness);
                const StaticRun run = run_mixed(make_roll_up(slenderness, {elements, order}), 1);
                CHECK(run.steps == 1);
                CHECK(run.iterations <= most_iterations);
                CHECK(run.tip().r.norm() < 1e-8);
            }
        }
    }
}

TEST_CASE("simo elements roll up in as many steps as keep rotations below half a turn",
          "[analyses][static][mixed]") {
    for (int order = 1; order <= 4; ++order) {
        INFO("order " << order);
        const StaticRun run = run_mixed(make_roll_up(1e4, {10, order, ElementKind::simo}), 3);
        CHECK(run.steps == 3);
        CHECK(run.iterations <= 18);
    }
}

TEST_CASE("the elastica at 10 takes two steps, the 45-degree bend at 600 one", "[analyses][static][mixed]") {
    for (const double slenderness : {1e2, 1e3, 1e4}) {
        for (int order = 1; order <= 4; ++order) {
            INFO("order " << order << ", slenderness " << slenderness);
            const StaticRun run = run_mixed(make_elastica(slenderness, {24 / order, order}), 2);
            CHECK(run.steps == 2);
            CHECK(run.iterations <= 16);
        }
    }
    for (const ElementKind kind : kinds) {
        for (int order = 1; order <= 4; ++order) {
            INFO(name_of(kind) << ", order " << order);
            const StaticRun run = run_mixed(make_bend({8, order, kind}), 1);
            CHECK(run.steps == 1);
            CHECK(run.iterations <= 10);
        }
    }
}

TEST_CASE("mixed and consistent tangents find the same equilibria", "[analyses][static][mixed]") {
    for (const ElementKind kind : kinds) {
        for (int order = 1; order <= 4; ++order) {
            INFO(name_of(kind) << ", order " << order);
            const Model model = make_bend({4, order, kind});
            const StaticRun mixed = run_static(model, with_tangent(TangentKind::mixed, 12, 1e-12));
            const StaticRun consistent = run_static(model, with_tangent(TangentKind::consistent, 12, 1e-12));
            CHECK((mixed.tip().r - consistent.tip().r).norm() < 1e-9);
            CHECK(mixed.tip().Lambda.angularDistance(consistent.tip().Lambda) < 1e-10);
            CHECK(mixed.iterations < consistent.iterations);
        }
    }
}

TEST_CASE("the mixed tangent moves damped rods as the consistent one does", "[analyses][mixed]") {
    for (const Scheme scheme : {Scheme::newmark_simplified, Scheme::generalized_alpha, Scheme::sdirk_4}) {
        for (const ElementKind kind : kinds) {
            for (int order = 1; order <= 4; ++order) {
                INFO(name_of(kind) << ", order " << order);
                const Model model = make_damped_cantilever({3, order, kind});
                const State mixed = run_dynamic(model, scheme, TangentKind::mixed);
                const State consistent = run_dynamic(model, scheme, TangentKind::consistent);
                CHECK((mixed.trial.back().r - consistent.trial.back().r).norm() < 1e-9);
                CHECK(mixed.resultants.size() == static_cast<std::size_t>(3 * order));
                CHECK(consistent.resultants.empty());
            }
        }
    }
}

TEST_CASE("an arch snaps through with the mixed tangent too, by way of the consistent one",
          "[analyses][static][mixed]") {
    const double radius = 25.25;  // 0.5 high over 10
    const Line arc = [=](double s) {
        const double angle = std::asin(5.0 / radius) - s / radius;
        return Placement{radius * Vec3(-std::sin(angle), 0.0, std::cos(angle)),
                         exp_quaternion(-angle * Vec3::UnitY())};
    };
    const double length = 2.0 * radius * std::asin(5.0 / radius);
    Model model = make_rod_model(arc, length, {20, 1}, make_section({1e5, 1e5, 1e5, 10.0, 10.0, 10.0}));
    for (const int node : {0, last_node(model)}) {
        model.supports.push_back({.node = node, .fixed = {true, true, true, true, false, true}});
    }
    add_ramp(model, 10, Vec3(0.0, 0.0, -300.0), Vec3::Zero());
    const StaticRun consistent = run_static(model, with_tangent(TangentKind::consistent, 10));
    const StaticRun mixed = run_static(model, with_tangent(TangentKind::mixed, 10));
    CHECK(consistent.node(10).r.z() < radius - 1.0);
    CHECK((mixed.node(10).r - consistent.node(10).r).norm() < 1e-6);
    CHECK(mixed.rejected_steps == 0);
}

TEST_CASE("a step that is cut leaves nothing behind in the resultants", "[analyses][static][mixed]") {
    // In one step a node would turn by a whole turn, in two by half a turn: four are taken.
    const Model model = make_roll_up(1e2, {8, 1, ElementKind::simo});
    StaticAnalysis cut(model, with_tangent(TangentKind::mixed, 1));
    StaticAnalysis whole(model, with_tangent(TangentKind::mixed, 4));
    REQUIRE(cut.start().converged());
    REQUIRE(whole.start().converged());
    while (!whole.finished()) {
        REQUIRE(cut.advance().converged());
        REQUIRE(whole.advance().converged());
        REQUIRE(cut.state().time == whole.state().time);
        CHECK(cut.state().resultants == whole.state().resultants);
        CHECK(cut.state().trial.back().r == whole.state().trial.back().r);
    }
    CHECK(cut.finished());
}

TEST_CASE("a run that fails keeps the resultants of the last accepted step", "[analyses][static][mixed]") {
    // Two elements cannot turn by more than one turn.
    Model model = make_roll_up(1e2, {2, 1});
    model.loads.clear();
    add_ramp(model, last_node(model), Vec3::Zero(), Vec3(0.0, 0.0, 2.2 * pi));
    StaticAnalysis analysis(model, with_tangent(TangentKind::mixed, 7));
    REQUIRE(analysis.start().converged());
    std::vector<Vec6> accepted;
    while (analysis.advance().converged()) accepted = analysis.state().resultants;
    CHECK_FALSE(analysis.finished());
    REQUIRE(accepted.size() == 2);
    CHECK(analysis.state().resultants == accepted);
    // Those of pure bending.
    const double moment = 2.2 * pi * analysis.state().time;
    for (const Vec6& resultants : accepted) CHECK(resultants[5] == Approx(moment).epsilon(1e-9));
}
