// Free vibrations of one element whose motion is that of one mass on a spring, at any amplitude: along its
// axis and in twist. Damping ratios are tau w/2 (Kelvin & Voigt) and c/(2 w) (mass-proportional).

#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/rod_models.hpp"
#include "tools/run.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double length = 2.0;

struct Damping {
    double kelvin_voigt, mass_proportional;
    double ratio(double omega) const { return 0.5 * kelvin_voigt * omega + 0.5 * mass_proportional / omega; }
};

// ω² = 3 EA/(ρA L²) along the axis: a third of the mass swings. In twist half of it: 2 GJ/(ρJ L²).
constexpr double EA = 12.0, rho_A = 0.5, GJ = 3.0, rho_J = 0.4;
const double omega_axial = std::sqrt(3.0 * EA / rho_A) / length;
const double omega_twist = std::sqrt(2.0 * GJ / rho_J) / length;
constexpr double start_speed = 1.5;  // of the free end, along the axis and about it

Model make_bar(ElementKind kind, const Damping& damping) {
    Section section = make_section({EA, 7.0, 7.0, GJ, 5.0, 5.0}, {rho_A, rho_A, rho_A, rho_J, 0.2, 0.2});
    section.kelvin_voigt = damping.kelvin_voigt;
    section.mass_proportional = damping.mass_proportional;
    Model model = make_rod_model(along_x, length, {1, 1, kind}, section);
    clamp(model, 0);
    model.nodes[1].velocity.x() = start_speed;
    model.nodes[1].angular_velocity.x() = start_speed;
    return model;
}

double exact_decay(double omega, double ratio, double t) {
    const double damped = omega * std::sqrt(1.0 - ratio * ratio);
    return start_speed / damped * std::exp(-ratio * omega * t) * std::sin(damped * t);
}

constexpr Damping dampings[] = {{0.05, 0.0}, {0.0, 0.8}, {0.03, 0.3}, {0.0, 0.0}};

// The largest error over the run of displacement and twist, and the ledger's at the end.
struct Errors {
    double motion = 0.0;
    double energy = 0.0;
};

Errors measure(ElementKind kind, const Damping& damping, Scheme scheme, long steps) {
    DynamicSettings settings = make_settings(scheme, 2.0, steps);
    settings.newton.tolerance = 1e-13;
    Errors errors;
    run(make_bar(kind, damping), settings, [&](const DynamicAnalysis& analysis) {
        const double t = analysis.state().time;
        const NodeMotion& end = analysis.state().trial[1];
        const double u = exact_decay(omega_axial, damping.ratio(omega_axial), t);
        const double twist = exact_decay(omega_twist, damping.ratio(omega_twist), t);
        errors.motion = std::max({errors.motion,
                                  (end.r - Vec3(length + u, 0.0, 0.0)).norm(),
                                  (log(end.Lambda) - Vec3(twist, 0.0, 0.0)).norm()});
        errors.energy = std::abs(analysis.ledger_row().energy_error);
    });
    return errors;
}

}  // namespace

TEST_CASE("vibrations decay by their damping ratio", "[analyses][damping]") {
    for (const ElementKind kind : {ElementKind::objective, ElementKind::simo}) {
        for (const Damping& damping : dampings) {
            for (const auto& [scheme, order, steps] : {std::tuple(Scheme::newmark_simplified, 2.0, 100L),
                                                       {Scheme::generalized_alpha, 2.0, 200L},
                                                       {Scheme::sdirk_4, 4.0, 50L},
                                                       {Scheme::runge_kutta_4, 4.0, 100L}}) {
                INFO((kind == ElementKind::simo ? "simo" : "objective")
                     << ", tau " << damping.kelvin_voigt << ", c " << damping.mass_proportional << ", scheme "
                     << static_cast<int>(scheme));
                const Errors coarse = measure(kind, damping, scheme, steps);
                const Errors fine = measure(kind, damping, scheme, 2 * steps);
                INFO("errors " << coarse.motion << " " << fine.motion << ", energy " << coarse.energy << " "
                               << fine.energy);
                CHECK(std::log2(coarse.motion / fine.motion) == Approx(order).margin(0.2));
                CHECK(fine.motion < 5e-3);
                if (scheme == Scheme::newmark_simplified) {
                    CHECK(fine.energy < 1e-12);  // of a linear motion its means are exact
                } else {
                    CHECK(std::log2(coarse.energy / fine.energy) > order - 0.4);  // 5 without damping
                }
            }
        }
    }
}

TEST_CASE("what a vibration loses is dissipated", "[analyses][damping]") {
    const Model model = make_bar(ElementKind::objective, dampings[2]);
    DynamicSettings settings = make_settings(Scheme::sdirk_4, 6.0, 1200);
    double energy_at_start = 0.0;
    double dissipated_before = 0.0;
    run(model, settings, [&](const DynamicAnalysis& analysis) {
        const LedgerRow row = analysis.ledger_row();
        const double energy = row.kinetic_energy + row.strain_energy;
        if (analysis.state().time == 0.0) energy_at_start = energy;
        CHECK(row.dissipated_energy >= dissipated_before);
        CHECK(energy + row.dissipated_energy == Approx(energy_at_start).epsilon(1e-8));
        CHECK(row.external_work == 0.0);
        dissipated_before = row.dissipated_energy;
    });
    // ½ m v² of the third and the half of the bar that swing.
    CHECK(energy_at_start == Approx(0.5 * start_speed * start_speed * length * (rho_A / 3.0 + rho_J / 2.0)));
    CHECK(dissipated_before > 0.9 * energy_at_start);
}
