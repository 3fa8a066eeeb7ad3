#include <algorithm>
#include <cmath>

#include "analyses/dynamic.hpp"
#include "assembly/system_values.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/rod_models.hpp"
#include "tools/run.hpp"

// Motion in time without inertia: rates matter, accelerations do not.
using namespace gxrod;
using namespace gxrod::tools;

namespace {

DynamicSettings make_slow(double end_time, long steps) {
    DynamicSettings settings = make_settings(Scheme::sdirk_4, end_time, steps);
    settings.has_inertia = false;
    settings.newton.tolerance = 1e-12;
    return settings;
}

// Heavy, with its mass beside its axis.
Section make_heavy_section() {
    Section section = make_section({100.0, 50.0, 50.0, 2.0, 3.0, 4.0}, {7.0, 7.0, 7.0, 3.0, 1.0, 2.0});
    const Vec3 offset(0.0, 0.3, -0.2);
    section.mass.topRightCorner<3, 3>() = -7.0 * spin(offset);
    section.mass.bottomLeftCorner<3, 3>() = 7.0 * spin(offset);
    section.mass.bottomRightCorner<3, 3>() -= 7.0 * spin(offset) * spin(offset);
    return section;
}

Model make_cantilever(const Section& section, ElementKind kind) {
    Model model = make_rod_model(along_x, 1.0, {2, 2}, section);
    model.rods[0].kind = kind;
    model.has_inertia = false;
    clamp(model, 0);
    return model;
}

}  // namespace

TEST_CASE("a rod that is pulled at once creeps as its Kelvin-Voigt law says", "[analyses]") {
    // EA (Γ + τ Γ′) = F, also of large strains.
    constexpr double F = 40.0, EA = 100.0, tau = 0.7;
    for (const ElementKind kind : {ElementKind::objective, ElementKind::simo}) {
        Section section = make_heavy_section();
        section.kelvin_voigt = tau;
        Model model = make_cantilever(section, kind);
        NodalLoad load;
        load.node = last_node(model);
        load.force[0] = TimeFunction([](double) { return F; });
        model.loads.push_back(load);
        std::vector<double> errors;
        for (const long steps : {8, 16, 32}) {
            double error = 0.0;
            run(model, make_slow(2.0, steps), [&](const DynamicAnalysis& analysis) {
                const double t = analysis.state().time;
                if (t == 0.0) return;  // a ten-thousandth of a step has crept
                const double exact = 1.0 + F / EA * (1.0 - std::exp(-t / tau));
                error = std::max(error, std::abs(analysis.state().trial[last_node(model)].r.x() - exact));
                const LedgerRow ledger = analysis.ledger_row();
                CHECK(ledger.kinetic_energy == 0.0);
                // F u = ½ EA Γ² + ∫ EA τ Γ′² dt.
                CHECK(std::abs(ledger.energy_error) < 2e-3 / std::pow(static_cast<double>(steps) / 8.0, 3.0));
            });
            errors.push_back(error);
        }
        for (const double order : compute_orders(errors)) CHECK(order == Approx(4.0).margin(0.3));
        CHECK(errors.back() < 1e-7);
    }
}

TEST_CASE("without inertia a rod that is swung round carries nothing but its weight", "[analyses]") {
    for (const ElementKind kind : {ElementKind::objective, ElementKind::simo}) {
        Model model = make_cantilever(make_heavy_section(), kind);
        model.bodies.push_back({.name = "tip",
                                .node = last_node(model),
                                .mass = 5.0,
                                .inertia = Vec3(3.0, 2.0, 1.5).asDiagonal(),
                                .centre_of_mass = Vec3(0.1, 0.2, 0.3)});
        Support& support = model.supports[0];
        support.fixed.fill(true);
        support.fixed[5] = false;
        support.moved[5] = true;
        support.motion[5] = TimeFunction([](double t) { return 2.0 * t; });
        const auto largest_strain = [](const DynamicAnalysis& analysis) {
            double largest = 0.0;
            for (const SectionValues& values :
                 SystemValues(analysis.system()).compute_section_values(analysis.state()))
                largest = std::max({largest, values.strain.norm(), values.curvature.norm()});
            return largest;
        };
        run(model, make_slow(1.0, 10), [&](const DynamicAnalysis& analysis) {
            CHECK(largest_strain(analysis) < 1e-11);
        });
        Model dynamic = model;
        dynamic.has_inertia = true;
        double with_inertia = 0.0;
        DynamicSettings settings = make_settings(Scheme::sdirk_4, 0.1, 10);
        run(dynamic, settings, [&](const DynamicAnalysis& analysis) {
            with_inertia = std::max(with_inertia, largest_strain(analysis));
        });
        CHECK(with_inertia > 1e-2);
    }
}
