// Tops and free bodies against reference motions.
#include <numbers>

#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/run.hpp"
#include "tools/tops.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

double measure_error_at_first_reference(Scheme scheme, long steps) {
    DynamicSettings settings = make_settings(scheme, 0.2, steps);
    settings.newton.tolerance = NewtonSettings().tolerance;  // as a deck has it
    const NodeMotion last = run_to_end(heavy_top::make_model(), settings);
    return (heavy_top::centre_of_mass(last.Lambda) - heavy_top::references()[0].centre_of_mass).norm();
}

// Angle between two attitudes.
double measure_turn(const Quat& a, const Quat& b) { return a.angularDistance(b); }

}  // namespace

TEST_CASE("heavy top: scheme (S) errs by 2.40e-4 at t = 0.2 with steps of 1e-4, a quarter with half the step",
          "[analyses][top]") {
    // The Euclidean norm of the error of the centre of mass. (Its largest component is 1.76e-4.)
    const double coarse = measure_error_at_first_reference(Scheme::newmark_simplified, 2000);
    const double fine = measure_error_at_first_reference(Scheme::newmark_simplified, 4000);
    CHECK(coarse == Approx(2.40e-4).epsilon(0.01));
    CHECK(coarse / fine == Approx(4.0).epsilon(0.01));
}

TEST_CASE("heavy top: schemes of order 4 reach every reference", "[analyses][top]") {
    // Errors of centre of mass and attitude at t = 2, measured: 6.3e-7 and 8.1e-7; 3.8e-6 and 6.2e-6.
    for (const auto& [scheme, steps, limit] :
         {std::tuple(Scheme::runge_kutta_4, 8000L, 1e-6), {Scheme::sdirk_4, 4000L, 7e-6}}) {
        std::size_t compared = 0;
        Quat last;
        run(heavy_top::make_model(), make_settings(scheme, 2.0, steps), [&](const DynamicAnalysis& analysis) {
            last = analysis.state().trial[0].Lambda;
            for (const auto& reference : heavy_top::references()) {
                if (analysis.state().time != reference.time) continue;
                ++compared;
                CHECK((heavy_top::centre_of_mass(last) - reference.centre_of_mass).norm() < limit);
            }
        });
        CHECK(compared == heavy_top::references().size());
        CHECK(measure_turn(last, heavy_top::reference_rotation()) < limit);
    }
}

TEST_CASE("fast top: axis at t = 1 and 10, and energy", "[analyses][top]") {
    const Model model = fast_top::make_model();
    // Measured: 9.3e-9 and 2.7e-7.
    run(model, make_settings(Scheme::runge_kutta_4, 10.0, 8000), [&](const DynamicAnalysis& analysis) {
        const Vec3 axis = fast_top::axis(analysis.state().trial[0].Lambda);
        if (analysis.state().time == 0.0) {
            const double energy = analysis.ledger_row().kinetic_energy + 20.0 * axis.z();
            CHECK(energy == Approx(fast_top::energy).epsilon(1e-14));
        }
        if (analysis.state().time == 1.0) CHECK((axis - fast_top::reference_axis_1()).norm() < 1e-8);
        if (analysis.finished()) {
            CHECK((axis - fast_top::reference_axis_10()).norm() < 3e-7);
            CHECK(std::abs(analysis.ledger_row().energy_error) < 2e-10 * fast_top::energy);
        }
    });
}

TEST_CASE("free symmetric top: attitude at t = 5", "[analyses][top]") {
    const Model model = make_free_body(Vec3(1.0, 1.0, 0.5), Vec3(0.5, 0.5, 1.0));
    const Quat reference(-0.63051414583893, 0.60480498494019, -0.30312423905729, -0.3804977500386);
    const auto measure = [&](Scheme scheme, long steps) {
        return measure_turn(run_to_end(model, make_settings(scheme, 5.0, steps)).Lambda, reference);
    };
    CHECK(measure(Scheme::sdirk_4, 200) < 4e-9);
    CHECK(measure(Scheme::runge_kutta_4, 400) < 2e-10);
    CHECK(measure(Scheme::newmark_simplified, 400) < 1e-4);
    CHECK(measure(Scheme::newmark_simplified, 200) / measure(Scheme::newmark_simplified, 400) ==
          Approx(4.0).epsilon(0.01));
}

TEST_CASE("Dzhanibekov's body flips every 6.16747290467", "[analyses][top]") {
    const Model model = make_free_body(Vec3(0.3, 0.35, 0.4), Vec3(0.1, 15.0, 0.1));
    std::vector<double> flips;
    double last_time = 0.0;
    double last_W = 15.0;
    Vec3 W_10 = Vec3::Zero();
    run(model, make_settings(Scheme::runge_kutta_4, 20.0, 16000), [&](const DynamicAnalysis& analysis) {
        const NodeMotion& motion = analysis.state().trial[0];
        const double time = analysis.state().time;
        const Vec3 W = motion.Lambda.conjugate() * motion.omega;
        // Where the spin about the middle axis changes sign, between two steps.
        if (W.y() * last_W < 0.0) flips.push_back(last_time + (time - last_time) * last_W / (last_W - W.y()));
        last_time = time;
        last_W = W.y();
        if (time == 10.0) W_10 = W;
    });
    REQUIRE(flips.size() == 3);
    CHECK(flips[1] - flips[0] == Approx(6.16747290467).epsilon(5e-7));
    CHECK(flips[2] - flips[1] == Approx(6.16747290467).epsilon(5e-7));
    CHECK((W_10 - Vec3(10.94623977013, 4.42844730509, 9.47985357634)).norm() < 5e-5);
}
