#include "analyses/static.hpp"

#include <numbers>

#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"
#include "tools/rod_models.hpp"
#include "tools/static_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

using std::numbers::pi;
const Section section = make_section({1e4, 5e3, 5e3, 80.0, 100.0, 120.0});

// A cantilever of length 10 under a force at its end that bends it in space by a large angle.
Model make_bent_cantilever(const Mesh& mesh) {
    Model model = make_rod_model(along_x, 10.0, mesh, section);
    clamp(model, 0);
    add_ramp(model, last_node(model), Vec3(-1.0, 4.0, 3.0), Vec3::Zero());
    return model;
}

std::string name_of(ElementKind kind) { return kind == ElementKind::simo ? "simo" : "objective"; }
constexpr ElementKind kinds[] = {ElementKind::objective, ElementKind::simo};

}  // namespace

TEST_CASE("a static run starts unloaded and meets its steps and its end", "[analyses][static]") {
    const Model model = make_bent_cantilever({4, 2});
    StaticAnalysis analysis(model, make_static_settings(5));
    REQUIRE(analysis.start().converged());
    CHECK(analysis.state().time == 0.0);
    CHECK(analysis.ledger_row().strain_energy < 1e-25);
    int steps = 0;
    while (!analysis.finished()) {
        REQUIRE(analysis.advance().converged());
        ++steps;
        CHECK(analysis.solver_row().time_step == 0.2);
        CHECK(analysis.ledger_row().kinetic_energy == 0.0);
    }
    CHECK(steps == 5);
    CHECK(analysis.state().time == 1.0);
}

TEST_CASE("initial velocities are of no matter in statics", "[analyses][static]") {
    Model model = make_bent_cantilever({4, 2});
    model.sections[0] = make_section({1e4, 5e3, 5e3, 80.0, 100.0, 120.0}, {1, 1, 1, 1, 1, 1});
    const StaticRun still = run_static(model, make_static_settings(2));
    for (Node& node : model.nodes) node.velocity = node.angular_velocity = Vec3(1.0, 2.0, 3.0);
    const StaticRun thrown = run_static(model, make_static_settings(2));
    CHECK(thrown.tip().r == still.tip().r);
    CHECK(thrown.ledger.kinetic_energy == 0.0);
}

TEST_CASE("objective elements do not depend on the steps, simo's little", "[analyses][static]") {
    const auto measure = [](ElementKind kind, long steps) {
        return run_static(make_bent_cantilever({6, 1, kind}), make_static_settings(steps)).tip().r;
    };
    const Vec3 objective = measure(ElementKind::objective, 4);
    CHECK((measure(ElementKind::objective, 7) - objective).norm() < 1e-10);
    CHECK((measure(ElementKind::objective, 25) - objective).norm() < 1e-10);
    const Vec3 simo = measure(ElementKind::simo, 400);
    const double coarse = (measure(ElementKind::simo, 10) - simo).norm();
    const double fine = (measure(ElementKind::simo, 20) - simo).norm();
    CHECK(coarse > 1e-6);
    CHECK(coarse < 1e-2);
    CHECK(coarse / fine == Approx(2.0).margin(0.2));
}

TEST_CASE("displacements that are prescribed need the force that gave them", "[analyses][static]") {
    constexpr long steps = 32;
    for (const ElementKind kind : kinds) {
        for (int order = 1; order <= 4; ++order) {
            INFO(name_of(kind) << ", order " << order);
            Model model = make_bent_cantilever({12 / order, order, kind});
            const int tip = last_node(model);
            std::vector<Vec3> displacements{Vec3::Zero()};
            StaticAnalysis pulled(model, make_static_settings(steps));
            REQUIRE(pulled.start().converged());
            while (!pulled.finished()) {
                REQUIRE(pulled.advance().converged());
                displacements.emplace_back(pulled.state().trial[tip].r - model.nodes[tip].position);
            }
            model.loads.clear();
            Support moved{.node = tip};
            for (int i = 0; i < 3; ++i) {
                moved.moved[i] = true;
                moved.motion[i] =
                    TimeFunction([&, i](double t) { return displacements[std::lround(t * steps)][i]; });
            }
            model.supports.push_back(moved);
            StaticAnalysis driven(model, make_static_settings(steps));
            REQUIRE(driven.start().converged());
            for (int step = 1; step <= steps; ++step) {
                REQUIRE(driven.advance().converged());
                CHECK(driven.solver_row().rejected_steps == 0);
                const Snapshot snapshot = driven.snapshot();
                const Vec3 force = Vec3(-1.0, 4.0, 3.0) * step / steps;
                CHECK((snapshot.nodes[tip].r - model.nodes[tip].position - displacements[step]).norm() <
                      1e-13);
                CHECK((snapshot.reactions[tip].head<3>() - force).norm() < 1e-7);
                CHECK(snapshot.reactions[tip].tail<3>().norm() == 0.0);
                CHECK((snapshot.reactions[0].head<3>() + force).norm() < 1e-7);
            }
        }
    }
}

TEST_CASE("a clamp that turns takes a straight rod along, twice round, without strain",
          "[analyses][static]") {
    for (const ElementKind kind : kinds) {
        for (int order = 1; order <= 4; ++order) {
            INFO(name_of(kind) << ", order " << order);
            Model model = make_rod_model(along_x, 10.0, {3, order, kind}, section);
            const Vec3 axis = Vec3(1.0, -2.0, 2.0) / 3.0;
            Support clamp{.fixed = {true, true, true, false, false, false}};
            for (int i = 0; i < 3; ++i) {
                clamp.moved[3 + i] = true;
                clamp.motion[3 + i] = ramp(4.25 * pi * axis[i]);
            }
            model.supports.push_back(clamp);
            StaticAnalysis analysis(model, make_static_settings(10));
            REQUIRE(analysis.start().converged());
            while (!analysis.finished()) {
                REQUIRE(analysis.advance().converged());
                const Quat turn = exp_quaternion(analysis.state().time * 4.25 * pi * axis);
                for (std::size_t i = 0; i < model.nodes.size(); ++i) {
                    const NodeMotion& motion = analysis.state().trial[i];
                    CHECK((motion.r - turn * model.nodes[i].position).norm() < 1e-9);
                    CHECK(motion.Lambda.angularDistance(turn) < 1e-10);
                }
                CHECK(analysis.ledger_row().strain_energy < 1e-16);
                CHECK(std::abs(analysis.ledger_row().external_work) < 1e-9);
            }
        }
    }
}
