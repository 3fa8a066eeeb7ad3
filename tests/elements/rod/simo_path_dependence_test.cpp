
#include "tools/catch.hpp"
#include "tools/free_flight.hpp"
#include "tools/run.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// Where the free end is after 5 s on three elements.
Vec3 fly(ElementKind kind, long steps) {
    Model model = make_free_flight(3);
    model.rods[0].kind = kind;
    Vec3 end;
    run(model, make_settings(Scheme::sdirk_4, 5.0, steps), [&](const DynamicAnalysis& analysis) {
        end = analysis.state().trial.back().r;
    });
    return end;
}

}  // namespace

TEST_CASE(
    "on a coarse mesh simo's interpolation leaves an error of first order in the step, objective's none",
    "[elements]") {
    // simo's test functions T(θ) Σ N_I T(θ_I)⁻¹ δφ_I depend on the rotation since the step began: on three
    // elements that is what is left of the error of sdirk-4.
    const std::vector<Vec3> simo{fly(ElementKind::simo, 400), fly(ElementKind::simo, 800)};
    const double coarse = (simo[0] - simo[1]).norm();
    const double fine = (simo[1] - fly(ElementKind::simo, 1600)).norm();
    CHECK(coarse == Approx(5.94e-4).epsilon(0.01));
    CHECK(std::log2(coarse / fine) == Approx(1.0).margin(0.1));
    CHECK((fly(ElementKind::objective, 400) - fly(ElementKind::objective, 800)).norm() < 0.1 * coarse);
}
