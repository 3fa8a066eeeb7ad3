// Bushings and torsion springs in models, against motions and equilibria that are known exactly.

#include "analyses/shapes/modes.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/rod_models.hpp"
#include "tools/run.hpp"
#include "tools/static_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double inertia = 0.5, stiffness = 8.0;

// A body at the origin that turns about z alone, on a torsion spring.
Model make_torsion_pendulum(double damping) {
    Model model;
    model.nodes.push_back({"body", Vec3::Zero()});
    Body body;
    body.name = "body";
    body.mass = 1.0;
    body.inertia = Vec3(0.3, 0.4, inertia).asDiagonal();
    model.bodies.push_back(body);
    Bushing bushing;
    bushing.name = "spring";
    bushing.ends = {Anchor{}, Anchor{0}};
    bushing.stiffness(5, 5) = stiffness;
    bushing.damping(5, 5) = damping;
    model.bushings.push_back(bushing);
    Support support;
    support.fixed = {true, true, true, true, true, false};
    model.supports.push_back(support);
    return model;
}

// The largest of the run, whose angle is 2.5 sin(ω t) e^(−δ t) up to a rate of 10 at the start.
struct Errors {
    double angle = 0.0;
    double energy = 0.0;
    double dissipated = 0.0;
};

Errors measure(double damping, Scheme scheme, long steps) {
    Model model = make_torsion_pendulum(damping);
    model.nodes[0].angular_velocity = Vec3(0.0, 0.0, 10.0);
    const double decay = damping / (2.0 * inertia);
    const double omega = std::sqrt(stiffness / inertia - decay * decay);
    DynamicSettings settings = make_settings(scheme, 3.0, steps);
    settings.newton.tolerance = 1e-12;
    Errors errors;
    run(model, settings, [&](const DynamicAnalysis& analysis) {
        const double t = analysis.state().time;
        const double exact = 10.0 / omega * std::exp(-decay * t) * std::sin(omega * t);
        const double angle = log(analysis.state().trial[0].Lambda).z();
        errors.angle = std::max(errors.angle, std::abs(angle - exact));
        errors.energy = std::max(errors.energy, std::abs(analysis.ledger_row().energy_error));
        errors.dissipated = analysis.ledger_row().dissipated_energy;
    });
    return errors;
}

}  // namespace

TEST_CASE("a torsion pendulum swings far as a sine, and decays with damping", "[analyses][springs]") {
    for (const double damping : {0.0, 0.4}) {
        for (const auto& [scheme, order, steps] : {std::tuple(Scheme::newmark_simplified, 2.0, 200L),
                                                   {Scheme::generalized_alpha, 2.0, 200L},
                                                   {Scheme::sdirk_4, 4.0, 100L},
                                                   {Scheme::runge_kutta_4, 4.0, 100L}}) {
            const Errors coarse = measure(damping, scheme, steps);
            const Errors fine = measure(damping, scheme, 2 * steps);
            INFO("damping " << damping << ", scheme " << static_cast<int>(scheme) << ", errors "
                            << coarse.angle << " " << fine.angle << ", energy " << coarse.energy << " "
                            << fine.energy);
            CHECK(std::log2(coarse.angle / fine.angle) == Approx(order).margin(0.25));
            CHECK(fine.energy < 1e-2 * 0.5 * inertia * 100.0);
            CHECK((fine.dissipated > 10.0) == (damping > 0.0));
        }
    }
}

TEST_CASE("a body in a bushing has the frequencies of its stiffnesses", "[analyses][springs]") {
    Model model = make_torsion_pendulum(0.0);
    model.supports.clear();
    model.bushings[0].stiffness.diagonal() << 1.0, 2.0, 3.0, 4.0, 5.0, 6.0;
    const System system(model);
    const ModesRecord record = find_modes(system, system.initial_state(), 0.0, {.count = 6});
    REQUIRE(record.modes.size() == 6);
    std::vector<double> expected{1.0, 2.0, 3.0, 4.0 / 0.3, 5.0 / 0.4, 6.0 / inertia};
    std::sort(expected.begin(), expected.end());
    for (std::size_t i = 0; i < 6; ++i)
        CHECK(record.modes[i].omega_squared == Approx(expected[i]).epsilon(1e-12));
}

TEST_CASE("a cantilever on a bushing turns at its foot by moment over stiffness", "[analyses][springs]") {
    constexpr double length = 2.0, EI = 3.0, GA = 400.0, load = 1e-6;
    Model model = make_rod_model(along_x, length, {4, 3}, make_section({1e4, GA, GA, 2.0, EI, EI}));
    Bushing bushing;
    bushing.name = "foot";
    bushing.ends = {Anchor{}, Anchor{0}};
    bushing.stiffness.diagonal() << 50.0, 60.0, 70.0, 8.0, 9.0, 10.0;
    model.bushings.push_back(bushing);
    add_ramp(model, last_node(model), {0.0, load, 0.0}, Vec3::Zero());
    const StaticRun run = run_static(model, make_static_settings(1));
    const double turn = load * length / 10.0;
    CHECK(log(run.node(0).Lambda).z() == Approx(turn).epsilon(1e-5));
    CHECK(run.node(0).r.y() == Approx(load / 60.0).epsilon(1e-5));
    const double flexibility = std::pow(length, 3) / (3.0 * EI) + length / GA;
    CHECK(run.tip().r.y() == Approx(load * flexibility + load / 60.0 + turn * length).epsilon(1e-5));
    CHECK(std::abs(run.ledger.energy_error) < 1e-6 * load * load);
}

TEST_CASE("two bodies joined by a bushing alone keep their momenta", "[analyses][springs]") {
    Model model = make_torsion_pendulum(0.0);
    model.supports.clear();
    model.nodes.push_back({"other", Vec3(0.4, 0.1, 0.0)});
    model.bodies.push_back(model.bodies[0]);
    model.bodies[1].node = 1;
    Bushing& bushing = model.bushings[0];
    const Vec3 place(0.1, 0.3, 0.2);
    bushing.ends = {Anchor{0, place}, Anchor{1, place - model.nodes[1].position}};
    bushing.stiffness.diagonal() << 30.0, 40.0, 50.0, 3.0, 4.0, 5.0;
    bushing.stiffness(1, 5) = bushing.stiffness(5, 1) = 2.0;
    bushing.damping = 0.02 * bushing.stiffness;
    model.nodes[0].velocity = Vec3(0.3, -1.0, 0.2);
    model.nodes[1].angular_velocity = Vec3(2.0, 1.0, -3.0);
    LedgerRow first, last;
    run(model, make_settings(Scheme::sdirk_4, 1.0, 400), [&](const DynamicAnalysis& analysis) {
        last = analysis.ledger_row();
        if (analysis.state().time == 0.0) first = last;
    });
    CHECK((last.linear_momentum - first.linear_momentum).norm() < 1e-10);
    CHECK((last.angular_momentum - first.angular_momentum).norm() < 1e-7);
    CHECK(std::abs(last.energy_error) < 1e-6);
    CHECK(last.dissipated_energy > 0.01);
}
