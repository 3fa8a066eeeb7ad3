#include <algorithm>
#include <map>

#include "assembly/system_values.hpp"
#include "deck/decks.hpp"
#include "integrators/scheme_samples.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/run.hpp"
#include "verification/rubin2007_problem.hpp"
#include "watch/history_watch.hpp"

// What lies between the ends of a step: against motions that are known, and against fine steps.

namespace gxrod::test {
namespace {

using namespace gxrod::tools;

constexpr std::array fractions{0.2, 0.5, 0.85};

// Calls look(analysis, time) at times within each step.
template <class Look>
void look_within(const Model& model, const DynamicSettings& settings, Look&& look) {
    DynamicAnalysis analysis(model, settings);
    analysis.keep_steps([](double, double) { return true; });
    REQUIRE(analysis.start().converged());
    while (!analysis.finished()) {
        REQUIRE(analysis.advance().converged());
        const double start = analysis.step_start();
        for (const double part : fractions) look(analysis, start + part * (analysis.state().time - start));
    }
}

// The largest errors of a body's rotation, angular velocity and acceleration.
std::array<double, 3> measure_rubin(const DynamicSettings& settings) {
    const Model model = rubin2007::make_model();
    std::array<double, 3> worst{};
    look_within(model, settings, [&](DynamicAnalysis& analysis, double time) {
        const NodeMotion node = analysis.snapshot_within(time).nodes[0];
        const Quat axes = node.Lambda * model.bodies[0].attitude;
        const Vec3 alpha =
            differentiate([&](double dt) { return rubin2007::exact_angular_velocity(time + dt); });
        const std::array errors{(axes.toRotationMatrix() - rubin2007::exact_rotation(time)).norm(),
                                (node.omega - rubin2007::exact_angular_velocity(time)).norm(),
                                (node.alpha - alpha).norm()};
        for (std::size_t i = 0; i < errors.size(); ++i) worst[i] = std::max(worst[i], errors[i]);
    });
    return worst;
}

// Of rotations, rates and accelerations within steps.
std::array<double, 3> expected_orders(const SchemeSample& scheme) {
    if (scheme.settings.scheme == Scheme::radau_5) return {4.0, 4.0, 4.0};
    if (scheme.settings.scheme == Scheme::gauss_4) return {3.0, 3.0, 3.0};
    return {std::min(scheme.order, 4.0), std::min(scheme.order, 3.0), std::min(scheme.order, 2.0)};
}

// Turns, swings, stretches and twists, softly; its support exerts forces and a joint holds its body.
const std::string soft_rod = R"deck(gravity = [0, 0, -9.81]
[section.s]
stiffness = { EA = 1e3, GAy = 1e3, GAz = 1e3, GJ = 50, EIy = 60, EIz = 70 }
inertia = { rhoA = 1.0, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 2
[[support]]
at = "r.start"
fix = ["x", "y", "z", "rx", "ry", "rz"]
[[load]]
at = "r.end"
force = [0, "10*sin(2*t)", 0]
frame = "follower"
[analysis]
kind = "dynamic"
end_time = 0.8
steps = 16
[[history]]
name = "middle"
at = "r@0.4"
quantities = ["force"]
)deck";

const std::string pendulum = R"deck(gravity = [0, 0, -9.81]
[body.b]
at = [1, 0, 0]
mass = 1
inertia = [0.1, 0.2, 0.3]
velocity = [0, 2, 0]
angular_velocity = [0, 0, 2]
[joint.hinge]
type = "ball"
between = ["ground", "b"]
at = [0, 0, 0]
[analysis]
kind = "dynamic"
end_time = 0.8
steps = 16
)deck";

// What is compared, by its time.
using Picture = std::map<std::string, Eigen::VectorXd>;

Picture take_picture(const Snapshot& snapshot) {
    const auto collect = [](const auto& items, const auto& value) {
        Eigen::VectorXd all(3 * static_cast<Eigen::Index>(items.size()));
        for (std::size_t i = 0; i < items.size(); ++i)
            all.segment<3>(3 * static_cast<Eigen::Index>(i)) = value(items[i]);
        return all;
    };
    Picture picture;
    picture["r"] = collect(snapshot.nodes, [](const NodeMotion& node) { return node.r; });
    picture["axes"] =
        collect(snapshot.nodes, [](const NodeMotion& node) -> Vec3 { return node.Lambda * Vec3(1, 2, 3); });
    picture["v"] = collect(snapshot.nodes, [](const NodeMotion& node) { return node.v; });
    picture["omega"] = collect(snapshot.nodes, [](const NodeMotion& node) { return node.omega; });
    picture["force"] = collect(snapshot.elements, [](const SectionValues& one) { return one.force; });
    picture["moment"] = collect(snapshot.elements, [](const SectionValues& one) { return one.moment; });
    picture["curvature"] = collect(snapshot.elements, [](const SectionValues& one) { return one.curvature; });
    picture["point force"] = collect(snapshot.points, [](const PointValues& one) { return one.force; });
    picture["reaction"] =
        collect(snapshot.reactions, [](const Vec6& one) -> Vec3 { return one.head<3>() + one.tail<3>(); });
    picture["joint force"] = collect(snapshot.joints, [](const JointValues& one) { return one.force; });
    return picture;
}

// Of a fine run, whose steps end where the coarse ones are looked into.
std::map<long, Picture> make_reference(const Problem& problem, long steps) {
    DynamicSettings settings = make_settings(Scheme::radau_5, dynamic_of(problem).end_time, steps);
    std::map<long, Picture> reference;
    DynamicAnalysis analysis(problem.model, settings);
    analysis.watch(list_rod_places(problem.output.histories));
    REQUIRE(analysis.start().converged());
    for (long step = 1; !analysis.finished(); ++step) {
        REQUIRE(analysis.advance().converged());
        reference[step] = take_picture(analysis.snapshot());
    }
    return reference;
}

// The largest error of each kind within steps, half a step from their ends and elsewhere.
std::map<std::string, double> measure_errors(const Problem& problem,
                                             Scheme scheme,
                                             long steps,
                                             const std::map<long, Picture>& reference) {
    DynamicSettings settings = make_settings(scheme, dynamic_of(problem).end_time, steps);
    const auto fine = static_cast<double>(reference.size());
    std::map<std::string, double> worst;
    DynamicAnalysis analysis(problem.model, settings);
    analysis.watch(list_rod_places(problem.output.histories));
    analysis.keep_steps([](double, double) { return true; });
    REQUIRE(analysis.start().converged());
    while (!analysis.finished()) {
        REQUIRE(analysis.advance().converged());
        const double start = analysis.step_start();
        for (const double part : {0.25, 0.5, 0.75}) {
            const double time = start + part * (analysis.state().time - start);
            const Picture picture = take_picture(analysis.snapshot_within(time));
            const Picture& exact = reference.at(std::lround(time / settings.end_time * fine));
            for (const auto& [kind, values] : picture)
                worst[kind] = std::max(worst[kind], (values - exact.at(kind)).norm());
        }
    }
    return worst;
}

// Of `steps` steps to this time, and twice as many.
struct Steps {
    double end_time;
    long steps;
};

void check_orders(const std::string& deck,
                  Scheme scheme,
                  const Steps& of,
                  const std::map<std::string, double>& expected) {
    Problem problem = read(deck);
    std::get<DynamicSettings>(problem.stages.front().analysis).end_time = of.end_time;
    const auto reference = make_reference(problem, 8 * of.steps);
    const auto coarse = measure_errors(problem, scheme, of.steps, reference);
    const auto fine = measure_errors(problem, scheme, 2 * of.steps, reference);
    INFO("scheme " << static_cast<int>(scheme));
    for (const auto& [kind, order] : expected) {
        INFO(kind << ": errors " << coarse.at(kind) << " " << fine.at(kind));
        CHECK(std::log2(coarse.at(kind) / fine.at(kind)) > order - 0.4);
    }
}

}  // namespace

TEST_CASE("within steps the motion of Rubin's body has the order of scheme or interpolant", "[analyses]") {
    for (const SchemeSample& scheme : all_schemes()) {
        INFO(scheme.name);
        DynamicSettings settings = scheme.settings;
        settings.end_time = rubin2007::period;
        settings.newton.tolerance = 1e-11;
        const long steps = scheme.order > 2.0 ? 400 : 800;
        std::vector<std::array<double, 3>> errors;
        for (const long count : {steps, 2 * steps}) {
            settings.steps = count;
            errors.push_back(measure_rubin(settings));
        }
        const std::array<double, 3> expected = expected_orders(scheme);
        for (std::size_t i = 0; i < expected.size(); ++i) {
            INFO("rotation, rate, acceleration: " << i << ", errors " << errors[0][i] << " " << errors[1][i]);
            CHECK(std::log2(errors[0][i] / errors[1][i]) > expected[i] - 0.15);
        }
    }
}

TEST_CASE("within steps a flexible rod has the order of scheme or interpolant", "[analyses]") {
    check_orders(soft_rod,
                 Scheme::radau_5,
                 {0.8, 32},
                 {{"r", 4.0},
                  {"axes", 4.0},
                  {"v", 4.0},
                  {"omega", 4.0},
                  {"force", 4.0},
                  {"moment", 4.0},
                  {"curvature", 4.0},
                  {"point force", 4.0},
                  {"reaction", 4.0}});
    check_orders(soft_rod,
                 Scheme::gauss_4,
                 {0.2, 32},
                 {{"r", 3.0}, {"axes", 3.0}, {"v", 3.0}, {"omega", 3.0}, {"force", 3.0}, {"reaction", 3.0}});
    check_orders(soft_rod,
                 Scheme::sdirk_4,
                 {0.2, 32},
                 {{"r", 4.0}, {"axes", 4.0}, {"v", 3.0}, {"omega", 3.0}, {"force", 2.0}, {"reaction", 2.0}});
    check_orders(soft_rod,
                 Scheme::newmark_simplified,
                 {0.2, 64},
                 {{"r", 2.0}, {"axes", 2.0}, {"v", 2.0}, {"omega", 2.0}, {"force", 2.0}, {"reaction", 2.0}});
}

TEST_CASE("within steps a joint's force has the order of scheme or interpolant", "[analyses]") {
    check_orders(pendulum, Scheme::radau_5, {0.8, 32}, {{"r", 4.0}, {"omega", 4.0}, {"joint force", 3.0}});
    check_orders(
        pendulum, Scheme::newmark_simplified, {0.8, 64}, {{"r", 2.0}, {"omega", 2.0}, {"joint force", 2.0}});
}

TEST_CASE("what lies within a step meets its ends", "[analyses]") {
    const std::string deck = GENERATE(as<std::string>{}, soft_rod, pendulum);
    const Scheme scheme =
        GENERATE(Scheme::radau_5, Scheme::gauss_4, Scheme::sdirk_4, Scheme::generalized_alpha);
    const Problem problem = read(deck);
    DynamicAnalysis analysis(problem.model, make_settings(scheme, 0.8, 16));
    analysis.watch(list_rod_places(problem.output.histories));
    analysis.keep_steps([](double, double) { return true; });
    REQUIRE(analysis.start().converged());
    REQUIRE(analysis.advance().converged());
    const Picture before = take_picture(analysis.snapshot());
    REQUIRE(analysis.advance().converged());
    const Picture after = take_picture(analysis.snapshot());
    const double start = analysis.step_start();
    const double end = analysis.state().time;
    const auto check = [](const Picture& one, const Picture& other) {
        for (const auto& [kind, values] : one) {
            INFO(kind);
            CHECK((values - other.at(kind)).norm() <= 1e-8 * (1.0 + values.norm()));
        }
    };
    check(before, take_picture(analysis.snapshot_within(start)));
    check(after, take_picture(analysis.snapshot_within(end)));
    // Nothing of it remains.
    const Picture still = take_picture(analysis.snapshot());
    for (const auto& [kind, values] : after) CHECK(values == still.at(kind));
}

// A stiff rod spins, by 0.3 rad a step. The motion between the ends of steps is some 1e-5 off, of which its
// stiffness would make forces beyond all that act.
TEST_CASE("within steps forces of a stiff rod are those of equilibria, not of the motion", "[analyses]") {
    const std::string deck = R"deck([section.s]
stiffness = { EA = 1e7, GAy = 1e7, GAz = 1e7, GJ = 1e3, EIy = 1e3, EIz = 1e3 }
inertia = { rhoA = 1.0, rhoJ = 0.02, rhoIy = 0.01, rhoIz = 0.01 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 4
[[initial]]
on = "r"
spin = { axis = [0, 0, 1], through = [1, 0, 0], rate = 12 }
[analysis]
kind = "dynamic"
end_time = 0.5
steps = 20
)deck";
    const Problem problem = read(deck);
    const Scheme scheme = GENERATE(Scheme::radau_5, Scheme::generalized_alpha);
    DynamicSettings settings = make_settings(scheme, 0.5, 20);
    settings.newton.tolerance = 1e-8;
    DynamicAnalysis analysis(problem.model, settings);
    analysis.keep_steps([](double, double) { return true; });
    REQUIRE(analysis.start().converged());
    double largest = 0.0, of_equilibria = 0.0, of_motion = 0.0;
    while (!analysis.finished()) {
        const double before = analysis.snapshot().elements[0].force.x();
        REQUIRE(analysis.advance().converged());
        const double after = analysis.snapshot().elements[0].force.x();
        // At first the rod stretches.
        if (analysis.steps().steps_done() <= 5) continue;
        largest = std::max(largest, std::abs(after));
        const double middle = 0.5 * (analysis.step_start() + analysis.state().time);
        const Snapshot within = analysis.snapshot_within(middle);
        of_equilibria =
            std::max(of_equilibria, std::abs(within.elements[0].force.x() - 0.5 * (before + after)));
        State between = analysis.state();
        between.trial.assign(within.nodes.begin(), within.nodes.end());
        const double moved = SystemValues(analysis.system()).compute_section_values(between)[0].force.x();
        of_motion = std::max(of_motion, std::abs(moved - 0.5 * (before + after)));
    }
    INFO(largest << " " << of_equilibria << " " << of_motion);
    CHECK(of_equilibria < 0.1 * largest);
    CHECK(of_motion > largest);
}

}  // namespace gxrod::test
