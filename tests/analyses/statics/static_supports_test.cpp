// Hinges, rollers and moves in axes of their own; what reactions carry.
#include <numbers>

#include "assembly/system_measures.hpp"
#include "tools/catch.hpp"
#include "tools/random_values.hpp"
#include "tools/rod_models.hpp"
#include "tools/static_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double length = 10.0;
const Section section = make_section({1e4, 5e3, 5e3, 80.0, 100.0, 120.0});

struct Case {
    std::string name;
    Model model;
};

// The same rod in the axes `Q`: supports, loads and moves are turned with it.
Model make_hinged_rod(const Mesh& mesh, const Quat& Q) {
    const Line line = [&](double s) { return Placement{Q * Vec3(s, 0.0, 0.0), Q}; };
    Model model = make_rod_model(line, length, mesh, section);
    const int end = last_node(model);
    // A hinge about z at the start, at the end a roller along x that moves across and may not twist.
    model.supports.push_back({.node = 0, .fixed = {true, true, true, true, true, false}, .axes = Q});
    Support roller{.node = end, .fixed = {false, false, true, true, true, false}, .axes = Q};
    roller.moved[1] = true;
    roller.motion[1] = ramp(2.0);
    model.supports.push_back(roller);
    const int middle = end / 2;
    add_ramp(model, middle, Q * Vec3(0.0, 12.0, 4.0), Q * Vec3(0.0, 0.0, 5.0));
    add_ramp(model, middle, Vec3(0.1, 0.2, -0.4), Vec3(0.3, 0.0, 0.0), Frame::body);
    DistributedLoad load;
    load.frame = Frame::body;
    load.force[1] = LineFunction([](double t, double s) { return 0.02 * t * s; });
    model.distributed_loads.push_back(load);
    return model;
}

}  // namespace

TEST_CASE("a model with its supports turned as one has the same equilibrium, turned", "[analyses][static]") {
    const Quat Q = RandomValues(121).rotation();
    for (const ElementKind kind : {ElementKind::objective, ElementKind::simo}) {
        for (int order = 1; order <= 4; ++order) {
            INFO((kind == ElementKind::simo ? "simo" : "objective") << ", order " << order);
            const Mesh mesh{12 / order, order, kind};
            const StaticRun plain =
                run_static(make_hinged_rod(mesh, Quat::Identity()), make_static_settings(6));
            const StaticRun turned = run_static(make_hinged_rod(mesh, Q), make_static_settings(6));
            for (std::size_t i = 0; i < plain.state.trial.size(); ++i) {
                const NodeMotion& motion = turned.state.trial[i];
                const Quat Lambda = Q.conjugate() * motion.Lambda * Q;
                CHECK((Q.conjugate() * motion.r - plain.state.trial[i].r).norm() < 1e-9);
                CHECK(Lambda.angularDistance(plain.state.trial[i].Lambda) < 1e-9);
                for (const int part : {0, 3}) {
                    const Vec3 reaction = Q.conjugate() * Vec3(turned.reactions[i].segment<3>(part));
                    CHECK((reaction - plain.reactions[i].segment<3>(part)).norm() < 1e-7);
                }
            }
            // It is no small deflection, and the hinge turned about its axis alone.
            CHECK(std::abs(plain.state.trial[6].r.y()) > 1.0);
            CHECK(plain.state.trial[0].Lambda.vec().head<2>().norm() < 1e-14);
            CHECK(std::abs(plain.state.trial[0].Lambda.z()) > 0.1);
        }
    }
}

TEST_CASE("reactions and loads are in balance", "[analyses][static]") {
    const Quat Q = RandomValues(122).rotation();
    Model model = make_hinged_rod({4, 3}, Q);
    model.loads.pop_back();
    model.distributed_loads.clear();
    model.sections[0].mass.topLeftCorner<3, 3>() = 0.2 * Mat3::Identity();
    model.gravity = TimeVector({0.0, 0.0, ramp(-2.0)});
    const StaticRun run = run_static(model, make_static_settings(6));
    const int middle = last_node(model) / 2;
    const Vec3 force = Q * Vec3(0.0, 12.0, 4.0);
    Vec3 forces = force + Vec3(0.0, 0.0, -2.0 * 0.2 * length);
    Vec3 moments = run.node(middle).r.cross(force) + Q * Vec3(0.0, 0.0, 5.0);
    // The weight acts where a potential says.
    for (int i = 0; i < 2; ++i) {
        Model same = model;
        Vec3 down = Vec3::Zero();
        down[i] = -1.0;
        same.gravity = TimeVector(down);
        const double first_moment =
            SystemMeasures(System(same)).compute_balance(run.state, 1.0).gravity_potential;
        moments += Vec3(first_moment * Vec3::Unit(i)).cross(Vec3(0.0, 0.0, -2.0));
    }
    for (std::size_t i = 0; i < run.reactions.size(); ++i) {
        forces += run.reactions[i].head<3>();
        moments += run.state.trial[i].r.cross(Vec3(run.reactions[i].head<3>())) + run.reactions[i].tail<3>();
    }
    CHECK(forces.norm() < 1e-9);
    CHECK(moments.norm() < 1e-8);
}

TEST_CASE("frames of loads and supports that turn rigidly leave strains as they are", "[analyses][static]") {
    // A bent cantilever whose clamp turns on by 1.5 turns while its end load turns with the clamp.
    const Vec3 axis = Vec3(2.0, 1.0, -2.0) / 3.0;
    const double angle = 3.0 * std::numbers::pi;
    Model model = make_rod_model(along_x, length, {6, 2}, section);
    Support clamp{.fixed = {true, true, true, false, false, false}};
    for (int i = 0; i < 3; ++i) {
        clamp.moved[3 + i] = true;
        const double component = angle * axis[i];
        clamp.motion[3 + i] =
            TimeFunction([component](double t) { return t > 0.5 ? (2.0 * t - 1.0) * component : 0.0; });
    }
    model.supports.push_back(clamp);
    NodalLoad load;
    load.node = last_node(model);
    for (int i = 0; i < 3; ++i) {
        load.force[i] = TimeFunction([=](double t) {
            const Vec3 full(-1.0, 4.0, 3.0);
            if (t <= 0.5) return 2.0 * t * full[i];
            return Vec3(exp_quaternion((2.0 * t - 1.0) * angle * axis) * full)[i];
        });
    }
    model.loads.push_back(load);
    StaticAnalysis analysis(model, make_static_settings(40));
    REQUIRE(analysis.start().converged());
    std::vector<SectionValues> bent;
    Vec3 tip = Vec3::Zero();
    while (!analysis.finished()) {
        REQUIRE(analysis.advance().converged());
        const Snapshot snapshot = analysis.snapshot();
        if (analysis.state().time == 0.5) {
            bent.assign(snapshot.elements.begin(), snapshot.elements.end());
            tip = analysis.state().trial.back().r;
        }
        for (std::size_t e = 0; e < bent.size(); ++e) {
            CHECK((snapshot.elements[e].curvature - bent[e].curvature).norm() < 1e-9);
            CHECK((snapshot.elements[e].strain - bent[e].strain).norm() < 1e-9);
        }
    }
    REQUIRE(bent.size() == 6);
    CHECK(bent[0].curvature.norm() > 0.1);
    CHECK((analysis.state().trial.back().r - exp_quaternion(angle * axis) * tip).norm() < 1e-8);
}

TEST_CASE("supports cannot wind an element beyond half a turn", "[analyses][static]") {
    Model model = make_rod_model(along_x, length, {1, 1}, section);
    clamp(model, 0);
    Support turning{.node = 1, .fixed = {true, true, true, false, true, true}};
    turning.moved[3] = true;
    turning.motion[3] = ramp(1.5 * std::numbers::pi);
    model.supports.push_back(turning);
    const StaticRun refused = try_static(model, make_static_settings(10));
    CHECK(refused.report.outcome == Outcome::element_too_turned);
    CHECK(refused.state.time > 0.6);
    CHECK(refused.state.time < 2.0 / 3.0);
}

TEST_CASE("a rod follows its clamp through a fifth of a turn a step", "[analyses][static]") {
    for (const ElementKind kind : {ElementKind::objective, ElementKind::simo}) {
        Model model = make_rod_model(along_x, length, {4, 2, kind}, section);
        Support turning{.node = 0, .fixed = {true, true, true, true, true, false}};
        turning.moved[5] = true;
        turning.motion[5] = ramp(15.0);
        model.supports.push_back(turning);
        const StaticRun run = run_static(model, make_static_settings(12));
        CHECK(run.rejected_steps == 0);
        CHECK((run.tip().r - length * Vec3(std::cos(15.0), std::sin(15.0), 0.0)).norm() < 1e-9);
    }
}

TEST_CASE("a static move can begin with any rotation", "[analyses][static]") {
    // Of a rod in 8 elements, the first step of ten twists it by more than half a turn.
    for (const double sense : {1.0, -1.0}) {
        Model model = make_rod_model(along_x, length, {8, 1}, section);
        clamp(model, 0);
        Support turning{.node = last_node(model), .fixed = {false, true, true, false, true, true}};
        turning.moved[3] = true;
        turning.motion[3] = TimeFunction([sense](double t) { return sense * (4.0 + 0.1 * t); });
        model.supports.push_back(turning);
        const StaticRun run = run_static(model, make_static_settings(10));
        CHECK(run.reactions.back()[3] == Approx(sense * section.stiffness(3, 3) * 4.1 / length));
    }
}
