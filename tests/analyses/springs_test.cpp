// Springs in models, against motions and equilibria that are known exactly.

#include "analyses/shapes/eigenvalues.hpp"
#include "analyses/shapes/modes.hpp"
#include "assembly/system_measures.hpp"
#include "tools/catch.hpp"
#include "tools/rod_models.hpp"
#include "tools/run.hpp"
#include "tools/static_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double mass = 2.0, stiffness = 50.0, free_length = 1.5;
constexpr double start_energy = 0.5 * stiffness * 0.4 * 0.4;  // of make_oscillator

int add_body(Model& model, const Vec3& place, double of_mass = mass) {
    const int node = static_cast<int>(model.nodes.size());
    model.nodes.push_back({"body", place});
    Body body;
    body.name = "body";
    body.node = node;
    body.mass = of_mass;
    body.inertia = Vec3(0.3, 0.4, 0.5).asDiagonal();
    model.bodies.push_back(body);
    return node;
}

Spring make_spring(const Anchor& a, const Anchor& b, double k, double length, double c = 0.0) {
    Spring spring;
    spring.name = "spring";
    spring.ends = {a, b};
    spring.stiffness = k;
    spring.damping = c;
    spring.length = length;
    return spring;
}

Anchor ground(const Vec3& place) { return {-1, place}; }
Anchor point(int node, const Vec3& arm = Vec3::Zero()) { return {node, arm}; }

// A body on a spring to the origin, pulled out along x and let go.
Model make_oscillator(double damping) {
    Model model;
    add_body(model, Vec3(free_length + 0.4, 0.0, 0.0));
    model.springs.push_back(make_spring(ground(Vec3::Zero()), point(0), stiffness, free_length, damping));
    return model;
}

double exact_place(double damping, double t) {
    const double omega = std::sqrt(stiffness / mass);
    const double ratio = damping / (2.0 * mass * omega);
    const double damped = omega * std::sqrt(1.0 - ratio * ratio);
    return free_length + 0.4 * std::exp(-ratio * omega * t) *
                             (std::cos(damped * t) + ratio * omega / damped * std::sin(damped * t));
}

// The largest of the run.
struct Errors {
    double motion = 0.0;
    double energy = 0.0;
};

Errors measure(double damping, Scheme scheme, long steps) {
    DynamicSettings settings = make_settings(scheme, 2.0, steps);
    settings.newton.tolerance = 1e-13;
    Errors errors;
    run(make_oscillator(damping), settings, [&](const DynamicAnalysis& analysis) {
        const Vec3 exact(exact_place(damping, analysis.state().time), 0.0, 0.0);
        errors.motion = std::max(errors.motion, (analysis.state().trial[0].r - exact).norm());
        errors.energy = std::max(errors.energy, std::abs(analysis.ledger_row().energy_error));
    });
    return errors;
}

void hold(Model& model, int node, const std::array<bool, 6>& fixed) {
    Support support;
    support.node = node;
    support.fixed = fixed;
    model.supports.push_back(support);
}

}  // namespace

TEST_CASE("a mass on a spring swings as a cosine, and decays with a damper", "[analyses][springs]") {
    for (const double damping : {0.0, 3.0}) {
        for (const auto& [scheme, order, steps] : {std::tuple(Scheme::newmark_simplified, 2.0, 100L),
                                                   {Scheme::newmark_ibrahimbegovic, 2.0, 100L},
                                                   {Scheme::generalized_alpha, 2.0, 200L},
                                                   {Scheme::sdirk_4, 4.0, 50L},
                                                   {Scheme::runge_kutta_4, 4.0, 100L}}) {
            const Errors coarse = measure(damping, scheme, steps);
            const Errors fine = measure(damping, scheme, 2 * steps);
            INFO("damping " << damping << ", scheme " << static_cast<int>(scheme) << ", errors "
                            << coarse.motion << " " << fine.motion << ", energy " << coarse.energy << " "
                            << fine.energy);
            CHECK(std::log2(coarse.motion / fine.motion) == Approx(order).margin(0.2));
            if (scheme == Scheme::newmark_simplified || scheme == Scheme::newmark_ibrahimbegovic) {
                CHECK(fine.energy < 1e-12 * start_energy);  // of a linear motion its means are exact
            } else {
                CHECK(std::log2(coarse.energy / fine.energy) > order - 0.4);
            }
        }
    }
}

TEST_CASE("what a damper takes is dissipated energy", "[analyses][springs]") {
    double start = 0.0;
    LedgerRow last;
    run(make_oscillator(3.0),
        make_settings(Scheme::sdirk_4, 8.0, 1600),
        [&](const DynamicAnalysis& analysis) {
            last = analysis.ledger_row();
            const double energy = last.kinetic_energy + last.strain_energy;
            if (analysis.state().time == 0.0) start = energy;
            CHECK(energy + last.dissipated_energy == Approx(start).epsilon(1e-8));
        });
    CHECK(start == Approx(0.5 * stiffness * 0.4 * 0.4));
    CHECK(last.dissipated_energy > 0.99 * start);
}

TEST_CASE("two bodies tied by a spring alone keep their momenta", "[analyses][springs]") {
    Model model;
    const int a = add_body(model, Vec3::Zero());
    const int b = add_body(model, Vec3(1.0, 0.5, 0.0), 3.0);
    model.nodes[0].velocity = Vec3(0.3, -1.0, 0.2);
    model.nodes[1].angular_velocity = Vec3(2.0, 1.0, -3.0);
    model.springs.push_back(
        make_spring(point(a, {0.1, 0.2, 0.3}), point(b, {-0.2, 0.0, 0.1}), stiffness, 0.8, 0.5));
    LedgerRow first, last;
    // In shorter steps round-off grows, of accelerations with 1/Δt².
    run(model, make_settings(Scheme::sdirk_4, 1.0, 100), [&](const DynamicAnalysis& analysis) {
        last = analysis.ledger_row();
        if (analysis.state().time == 0.0) first = last;
    });
    CHECK((last.linear_momentum - first.linear_momentum).norm() < 1e-10);
    CHECK((last.angular_momentum - first.angular_momentum).norm() < 1e-7);
    CHECK(std::abs(last.energy_error) < 1e-7);
    CHECK(last.dissipated_energy > 0.01);
}

TEST_CASE("a spring to the ground acts from outside", "[analyses][springs]") {
    const Model model = make_oscillator(3.0);
    const System system(model);
    State state = system.initial_state();
    state.trial[0].v = Vec3(2.0, 1.0, 0.0);
    const Resultant outer =
        SystemMeasures(system).compute_outer_resultant(state, 0.0, std::vector{Vec6(Vec6::Zero())});
    CHECK((outer.force - Vec3(-stiffness * 0.4 - 3.0 * 2.0, 0.0, 0.0)).norm() < 1e-13);
}

TEST_CASE("a body between two taut springs has the frequencies of a mass on a string",
          "[analyses][springs]") {
    // Each is stretched by 0.5: along x both stiffnesses act, across it N/l of each.
    Model model;
    add_body(model, Vec3::Zero());
    model.springs.push_back(make_spring(ground({-2.0, 0.0, 0.0}), point(0), 40.0, 1.5));
    model.springs.push_back(make_spring(point(0), ground({1.0, 0.0, 0.0}), 40.0, 0.5));
    const System system(model);
    const ModesRecord record = find_modes(system, system.initial_state(), 0.0, {.count = 6});
    REQUIRE(record.modes.size() == 6);
    const double tension = 40.0 * 0.5;
    for (int i = 0; i < 3; ++i) CHECK(std::abs(record.modes[i].omega_squared) < 1e-10);  // turns
    CHECK(record.modes[3].omega_squared == Approx(tension * (1.0 / 2.0 + 1.0) / mass));
    CHECK(record.modes[4].omega_squared == Approx(tension * (1.0 / 2.0 + 1.0) / mass));
    CHECK(record.modes[5].omega_squared == Approx(80.0 / mass));
}

TEST_CASE("eigenvalues see springs and dampers", "[analyses][springs]") {
    Model model = make_oscillator(3.0);
    model.nodes[0].position.x() = free_length;
    hold(model, 0, {false, true, true, true, true, true});
    const System system(model);
    const EigenvaluesRecord record = find_eigenvalues(system, system.initial_state(), 0.0, {.count = 1});
    REQUIRE(record.failure.empty());
    REQUIRE(!record.modes.empty());
    const double growth = -3.0 / (2.0 * mass);
    CHECK(record.modes[0].growth == Approx(growth));
    CHECK(record.modes[0].omega == Approx(std::sqrt(stiffness / mass - growth * growth)));
}

namespace {

constexpr double rod_length = 2.0, EI = 3.0, GA = 400.0;

Model make_cantilever() {
    Model model = make_rod_model(along_x, rod_length, {4, 3}, make_section({1e4, GA, GA, 2.0, EI, EI}));
    clamp(model, 0);
    return model;
}

}  // namespace

TEST_CASE("a spring under a cantilever's tip takes its share of a small load", "[analyses][springs]") {
    Model model = make_cantilever();
    const int tip = last_node(model);
    const double k = 5.0;
    constexpr double load = 1e-6;
    add_ramp(model, tip, {0.0, load, 0.0}, Vec3::Zero());
    model.springs.push_back(make_spring(point(tip), ground({rod_length, 7.0, 0.0}), k, 7.0));
    const StaticRun run = run_static(model, make_static_settings(1));
    const double flexibility = std::pow(rod_length, 3) / (3.0 * EI) + rod_length / GA;
    CHECK(run.tip().r.y() == Approx(load * flexibility / (1.0 + k * flexibility)).epsilon(1e-6));
    CHECK(std::abs(run.ledger.energy_error) < 1e-6 * load * load);
}

TEST_CASE("a spring holds a rod as the force that it has at the end", "[analyses][springs]") {
    Model model = make_cantilever();
    const int tip = last_node(model);
    add_ramp(model, tip, {0.0, 3.0, 1.0}, Vec3::Zero());
    Model loaded = model;
    const Vec3 arm(0.2, -0.1, 0.3);
    const Vec3 anchor(1.0, -1.0, 0.5);
    const Spring spring = make_spring(ground(anchor), point(tip, arm), 2.0, 0.5);
    model.springs.push_back(spring);
    const StaticRun held = run_static(model, make_static_settings(10));
    const Vec3 u = held.tip().Lambda * arm;
    const Vec3 d = held.tip().r + u - anchor;
    const Vec3 force = -spring.stiffness * (d.norm() - spring.length) * d.normalized();
    CHECK((held.tip().r - Vec3(rod_length, 0.0, 0.0)).norm() > 0.5);
    add_ramp(loaded, tip, force, u.cross(force));
    const StaticRun alone = run_static(loaded, make_static_settings(10));
    CHECK((alone.tip().r - held.tip().r).norm() < 1e-10);
    CHECK((alone.reactions[0] - held.reactions[0]).norm() < 1e-9);
}

TEST_CASE("a rod on a spring to the ground moves as springs in series", "[analyses][springs]") {
    Model model = make_rod_model(along_x, rod_length, {3}, make_section({20.0, GA, GA, 2.0, EI, EI}));
    const int tip = last_node(model);
    hold(model, 0, {false, true, true, true, true, true});
    model.springs.push_back(make_spring(ground({-1.0, 0.0, 0.0}), point(0), 8.0, 1.0));
    add_ramp(model, tip, {4.0, 0.0, 0.0}, Vec3::Zero());
    const StaticRun run = run_static(model, make_static_settings(2));
    CHECK(run.node(0).r.x() == Approx(4.0 / 8.0));
    CHECK(run.tip().r.x() == Approx(rod_length + 4.0 / 8.0 + 4.0 * rod_length / 20.0));
    CHECK(run.ledger.strain_energy == Approx(0.5 * 16.0 * (1.0 / 8.0 + rod_length / 20.0)));
    CHECK(std::abs(run.ledger.energy_error) < 1e-12);
}

TEST_CASE("a step that takes away a spring's length fails with a word", "[analyses][springs]") {
    // It flies to the spring's other end, which it meets exactly after a whole number of steps.
    Model model;
    add_body(model, Vec3(1.0, 0.0, 0.0));
    model.nodes[0].velocity = Vec3(-1.0, 0.0, 0.0);
    model.springs.push_back(make_spring(ground(Vec3::Zero()), point(0), 1e-300, 1.0));
    DynamicAnalysis analysis(model, make_settings(Scheme::newmark_simplified, 2.0, 8));
    REQUIRE(analysis.start().converged());
    EquilibriumReport report;
    while (!analysis.finished() && (report = analysis.advance()).converged()) continue;
    CHECK(report.outcome == Outcome::not_finite);
    CHECK(analysis.state().time < 1.0);
    CHECK_THAT(describe_failure(analysis.explain(report)),
               Catch::Contains("spring spring has almost no length left"));
}
