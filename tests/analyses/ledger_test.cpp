#include "analyses/ledger.hpp"

#include <limits>

#include "integrators/scheme_samples.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/free_flight.hpp"
#include "tools/run.hpp"
#include "tools/tops.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// How far a run strays from its first momenta and from the balance of energy.
struct Drift {
    double linear = 0.0;
    double angular = 0.0;
    double energy = 0.0;
};

Drift measure_drift(const Model& model, DynamicSettings settings, double end_time, long steps) {
    settings.end_time = end_time;
    settings.steps = steps;
    settings.newton.tolerance = 1e-14;
    LedgerRow first;
    Drift drift;
    run(model, settings, [&](const DynamicAnalysis& analysis) {
        const LedgerRow row = analysis.ledger_row();
        if (analysis.state().time == 0.0) first = row;
        drift.linear = std::max(drift.linear, (row.linear_momentum - first.linear_momentum).norm());
        drift.angular = std::max(drift.angular, (row.angular_momentum - first.angular_momentum).norm());
        drift.energy = std::max(drift.energy, std::abs(row.energy_error));
    });
    return drift;
}

// An asymmetric body thrown with a tumble; its node off its centre of mass.
Model make_tumbling_body() {
    Model model = make_free_body(Vec3(1.0, 2.0, 4.0), Vec3(0.5, 2.0, 1.0));
    model.nodes[0].velocity = Vec3(1.0, 2.0, 3.0);
    model.bodies[0].centre_of_mass = Vec3(0.3, -0.2, 0.1);
    return model;
}

// A rod without loads that tumbles and bends: the free flyer with other initial rates.
Model make_tumbling_rod() {
    Model model = make_free_flight(4);
    model.loads.clear();
    for (Node& node : model.nodes) {
        node.velocity = Vec3(0.1 * node.position.y(), 0.3, 0.02 * node.position.x() * node.position.x());
        node.angular_velocity = Vec3(0.2, -0.3, 0.1);
    }
    return model;
}

// Rounding of positions that velocities, differences over a stage, bring into the momentum m r/Δt, once a
// step.
double compute_round_off(const SchemeSample& scheme, double mass_times_size, double end_time, long steps) {
    const double stages = scheme.settings.scheme == Scheme::sdirk_4 ? 4.0 : 1.0;  // h = Δt/4
    const double step = end_time / static_cast<double>(steps);
    return static_cast<double>(steps) * std::numeric_limits<double>::epsilon() * mass_times_size /
           (step / stages);
}

void add_load(Model& model, const Vec3& force, const Vec3& moment) {
    NodalLoad load;
    for (int i = 0; i < 3; ++i) {
        load.force[i] = force[i];
        load.moment[i] = moment[i];
    }
    model.loads.push_back(load);
}

}  // namespace

TEST_CASE(
    "a free body's linear momentum stays to round-off, its angular momentum and energy to the scheme's order",
    "[analyses]") {
    const Model offset = make_tumbling_body();
    Model central = offset;
    central.bodies[0].centre_of_mass.setZero();
    for (const SchemeSample& scheme : all_schemes()) {
        INFO(scheme.name);
        CHECK(measure_drift(central, scheme.settings, 2.0, 100).linear <
              compute_round_off(scheme, 1.0 * 8.0, 2.0, 100));  // 4e-11 at most
        // Of order 5, errors of more steps are near round-off.
        const long steps = scheme.order > 4.0 ? 80 : 250;
        const Drift coarse = measure_drift(offset, scheme.settings, 5.0, steps);
        const Drift fine = measure_drift(offset, scheme.settings, 5.0, 2 * steps);
        CHECK(std::log2(coarse.angular / fine.angular) == Approx(scheme.order).margin(0.15));
        // What generalized-alpha dissipates by itself is in the books: of radius 0 what is left falls faster.
        CHECK(std::log2(coarse.energy / fine.energy) > scheme.order - 0.2);
        // Seen from a node off the centre of mass, linear momentum too is only as good as the scheme.
        CHECK(std::log2(coarse.linear / fine.linear) == Approx(scheme.order).margin(0.15));
    }
}

TEST_CASE("a free rod's linear momentum stays to round-off", "[analyses]") {
    const Model model = make_tumbling_rod();
    for (const SchemeSample& scheme : all_schemes()) {
        INFO(scheme.name);
        CHECK(measure_drift(model, scheme.settings, 0.5, 100).linear <
              compute_round_off(scheme, 10.0 * 8.0, 0.5, 100));  // 1.4e-9 at most; P is of order 10
    }
}

TEST_CASE("work of constant loads and of gravity is exact where the motion is", "[analyses]") {
    // A dead force and gravity on the centre of mass, a moment about the principal axis of the spin.
    Model model = make_free_body(Vec3(1.0, 2.0, 3.0), Vec3(0.0, 0.0, 2.0));
    model.nodes[0].velocity = Vec3(1.0, 0.0, 0.0);
    model.gravity = Vec3(0.0, 0.0, -10.0);
    add_load(model, Vec3(4.0, 0.0, 1.0), Vec3(0.0, 0.0, 6.0));
    for (const SchemeSample& scheme : all_schemes()) {
        INFO(scheme.name);
        DynamicSettings settings = scheme.settings;
        settings.end_time = 1.5;
        settings.steps = 5;
        settings.newton.tolerance = 1e-14;
        LedgerRow last;
        run(model, settings, [&](const DynamicAnalysis& analysis) { last = analysis.ledger_row(); });
        // Δr = (1.5 + 4.5, 0, −9 × 1.125), turned by 2 × 1.5 + 1.5².
        const double work = 4.0 * 6.0 + (1.0 - 10.0) * -9.0 * 1.125 + 6.0 * 5.25;
        CHECK(last.external_work == Approx(work).epsilon(1e-12));
        CHECK(last.strain_energy == 0.0);
        CHECK(std::abs(last.energy_error) < 1e-11);
        CHECK(last.dissipated_energy == 0.0);
        CHECK(last.kinetic_energy == Approx(0.5 + 0.5 * 3.0 * 4.0 + work).epsilon(1e-12));
        CHECK((last.linear_momentum - Vec3(7.0, 0.0, -13.5)).norm() < 1e-11);
    }
}

TEST_CASE("energy of a loaded rod balances to the scheme's order", "[analyses]") {
    const Model model = make_free_flight(4);
    for (const SchemeSample& scheme : all_schemes()) {
        // Explicit steps, and those of β = 1/6, would have to resolve the mesh's fastest oscillation.
        if (scheme.settings.scheme == Scheme::runge_kutta_4 || scheme.settings.beta < 0.25) continue;
        INFO(scheme.name);
        const double coarse = measure_drift(model, scheme.settings, 1.0, 50).energy;
        const double fine = measure_drift(model, scheme.settings, 1.0, 100).energy;
        INFO("energy errors " << coarse << ", " << fine);
        CHECK(std::log2(coarse / fine) == Approx(scheme.order).margin(0.3));
    }
}

TEST_CASE("the work of gravity on a swinging body is its fall", "[analyses]") {
    Model model = heavy_top::make_model();
    model.nodes[0].angular_velocity = Vec3(0.0, 0.0, 0.0);
    DynamicSettings settings = make_settings(Scheme::runge_kutta_4, 0.5, 200);
    run(model, settings, [&](const DynamicAnalysis& analysis) {
        const double height = heavy_top::centre_of_mass(analysis.state().trial[0].Lambda).z();
        CHECK(analysis.ledger_row().external_work == Approx(-15.0 * 9.81 * height).margin(1e-12));
    });
}
