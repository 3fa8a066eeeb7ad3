// What schemes dissipate themselves, of a motion that is one mass on a spring: a bar of one element, clamped,
// that swings along its axis and in twist. There the discrete balance of energy is known in closed form
// (docs/theory/energy.md).

#include "tools/catch.hpp"
#include "tools/rod_models.hpp"
#include "tools/run.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double length = 2.0, EA = 12.0, rho_A = 0.5, GJ = 3.0, rho_J = 0.4;
// The mass that swings along the axis.
constexpr double mass = rho_A * length / 3.0;

Model make_bar() {
    Model model =
        make_rod_model(along_x,
                       length,
                       {1, 1, ElementKind::objective},
                       make_section({EA, 7.0, 7.0, GJ, 5.0, 5.0}, {rho_A, rho_A, rho_A, rho_J, 0.2, 0.2}));
    clamp(model, 0);
    model.nodes[1].velocity.x() = 1.5;
    return model;
}

DynamicSettings make_scheme(Scheme scheme, double parameter, long steps) {
    DynamicSettings settings = make_settings(scheme, 6.0, steps);
    settings.newton.tolerance = 1e-14;
    if (scheme == Scheme::generalized_alpha) {
        settings.spectral_radius = parameter;
    } else {
        settings.gamma = parameter;
        settings.beta = 0.25 * (parameter + 0.5) * (parameter + 0.5);
    }
    return settings;
}

}  // namespace

TEST_CASE("the dissipation of generalized-alpha follows its discrete balance", "[analyses]") {
    // R = −½ δ h v·Md + ⅛ δ² h² (3 a·Ma − 8 a·Md + 7 d·Md), d = a − A, δ = α_f − α_m.
    for (const double radius : {0.0, 0.5, 0.9}) {
        INFO("spectral radius " << radius);
        const double h = 6.0 / 40.0;
        const double delta = (1.0 - radius) / (1.0 + radius);
        double at_start = 0.0, before = 0.0;
        run(make_bar(),
            make_scheme(Scheme::generalized_alpha, radius, 40),
            [&](const DynamicAnalysis& analysis) {
                const NodeMotion& end = analysis.state().trial[1];
                const double a = end.a.x();
                const double d = a - analysis.state().carried_trial[2].a.x();
                const LedgerRow row = analysis.ledger_row();
                const double reversible =
                    mass * (-0.5 * delta * h * end.v.x() * d +
                            0.125 * delta * delta * h * h * (3.0 * a * a - 8.0 * a * d + 7.0 * d * d));
                const double kept = row.kinetic_energy + row.strain_energy + reversible;
                if (analysis.state().time == 0.0) at_start = kept;
                CHECK(kept + row.numerical_dissipation == Approx(at_start).epsilon(1e-10));
                CHECK(row.numerical_dissipation >= before);
                before = row.numerical_dissipation;
            });
        CHECK(before > 1e-5 * at_start);
    }
}

TEST_CASE("schemes without numerical dissipation book none", "[analyses]") {
    Model model = make_bar();
    model.nodes[1].angular_velocity.x() = 1.5;
    for (const DynamicSettings& settings : {make_scheme(Scheme::newmark_simplified, 0.6, 40),
                                            make_scheme(Scheme::newmark_ibrahimbegovic, 0.5, 40),
                                            make_scheme(Scheme::generalized_alpha, 1.0, 40),
                                            make_settings(Scheme::sdirk_4, 6.0, 40),
                                            make_settings(Scheme::runge_kutta_4, 6.0, 400)}) {
        run(model, settings, [&](const DynamicAnalysis& analysis) {
            CHECK(analysis.ledger_row().numerical_dissipation == 0.0);
        });
    }
}
