// D5: a flexible arm of length 10 whose root is turned by 1.5 rad in 2.5 and then held.
#include <numbers>

#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/rod_models.hpp"
#include "tools/run.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double turning_time = 2.5;
const Vec3 tip_then(5.265365, 8.262314, 0.0);    // at t = 2.5
const Vec3 tip_later(-7.190856, 2.572183, 0.0);  // at t = 5
constexpr double energy = 329.578410;            // after t = 2.5; all known to 8e-7

double angle(double t) {
    const double part = 2.0 * std::numbers::pi * t / turning_time;
    return t >= turning_time ? 1.5 : 1.5 * (part - std::sin(part)) / (2.0 * std::numbers::pi);
}

Model make_arm(const Mesh& mesh) {
    Model model = make_rod_model(
        along_x, 10.0, mesh, make_section({1e4, 1e4, 1e4, 1e3, 1e3, 1e3}, {1, 1, 1, 20, 10, 10}));
    Support root{.fixed = {true, true, true, true, true, false}};
    root.moved[5] = true;
    root.motion[5] = TimeFunction(angle);
    model.supports.push_back(root);
    return model;
}

struct Flight {
    double then, later;  // errors of the tip
    double energy;       // relative error
    double energy_error;
};

Flight fly(const Mesh& mesh, Scheme scheme, long steps) {
    Flight flight{};
    DynamicSettings settings = make_settings(scheme, 5.0, steps);
    settings.newton.tolerance = 1e-9;
    run(make_arm(mesh), settings, [&](const DynamicAnalysis& analysis) {
        const Vec3& tip = analysis.state().trial.back().r;
        const LedgerRow row = analysis.ledger_row();
        if (analysis.state().time == turning_time) {
            flight.then = (tip - tip_then).norm();
            flight.energy = std::abs(row.external_work / energy - 1.0);
        }
        flight.later = (tip - tip_later).norm();
        flight.energy_error = std::abs(row.energy_error);
    });
    return flight;
}

double rate(double coarse, double fine) { return std::log2(coarse / fine); }

}  // namespace

TEST_CASE("D5: a robot arm converges with the square of mesh and step", "[analyses][D5]") {
    struct Case {
        Mesh mesh;
        long steps;
    };
    // Of orders 2 and 3 the step's share is left.
    for (const auto& [mesh, steps] : {Case{{16, 1, ElementKind::objective}, 200},
                                      Case{{16, 1, ElementKind::simo}, 200},
                                      Case{{8, 2, ElementKind::objective}, 400},
                                      Case{{6, 3, ElementKind::objective}, 400}}) {
        const Flight coarse = fly(mesh, Scheme::newmark_simplified, steps);
        const Flight fine =
            fly({2 * mesh.elements, mesh.order, mesh.kind}, Scheme::newmark_simplified, 2 * steps);
        INFO((mesh.kind == ElementKind::simo ? "simo" : "objective")
             << ", order " << mesh.order << ": " << coarse.then << " " << fine.then << ", " << coarse.later
             << " " << fine.later << ", energy " << fine.energy << ", " << coarse.energy_error << " "
             << fine.energy_error);
        CHECK(rate(coarse.then, fine.then) == Approx(2.0).margin(0.3));
        CHECK(rate(coarse.later, fine.later) == Approx(2.0).margin(0.3));
        CHECK(rate(coarse.energy_error, fine.energy_error) == Approx(2.0).margin(0.1));
        CHECK(fine.energy < 1e-3);
    }
}

TEST_CASE("D5: elements of order 3 and sdirk-4 reach five digits of the reference", "[analyses][D5]") {
    const Flight flight = fly({8, 3}, Scheme::sdirk_4, 400);
    INFO(flight.then << " " << flight.later << " " << flight.energy << " " << flight.energy_error);
    CHECK(flight.then < 1e-5);
    CHECK(flight.later < 3e-5);
    CHECK(flight.energy < 1e-6);
    CHECK(flight.energy_error < 1e-5 * energy);
}
