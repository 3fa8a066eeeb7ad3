// Damped structures in fast rotation: what damping dissipates never falls, and is what they lose.

#include "deck/decks.hpp"
#include "run/run.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

const std::string ring = R"deck([section.s]
stiffness = { EA = 1e4, GAy = 5e3, GAz = 5e3, GJ = 10.0, EIy = 10.0, EIz = 10.0 }
inertia = { rhoA = 1.0, rhoIy = 1e-3, rhoIz = 1e-3 }
damping = { kelvin_voigt = 0.1 }
[rod.r]
section = "s"
arc = { centre = [0, 0, 0], axis = [0, 0, 1], from = [1, 0, 0], angle = "2*pi" }
elements = 8
order = 2
[[connect]]
points = ["r.start", "r.end"]
[[initial]]
on = "r"
velocity = ["-10*y", "10*x", 0]
angular_velocity = [0, 0, 10]
[analysis]
kind = "dynamic"
end_time = 10.0
time_step = 0.01
)deck";

// A straight rod that spins about an axis through its middle, and is pulled long by that.
std::string make_rod(const std::string& element) {
    return replaced(
        replaced(
            replaced(ring,
                     "arc = { centre = [0, 0, 0], axis = [0, 0, 1], from = [1, 0, 0], angle = \"2*pi\" }",
                     "line = { from = [-1, 0, 0], to = [1, 0, 0] }\nelement = \"" + element + "\""),
            "[[connect]]\npoints = [\"r.start\", \"r.end\"]\n",
            ""),
        "end_time = 10.0",
        "end_time = 5.0");
}

// Towed on a circle against a drag.
const std::string towed = R"deck([section.s]
stiffness = { EA = 1e4, GAy = 5e3, GAz = 5e3, GJ = 10.0, EIy = 10.0, EIz = 10.0 }
inertia = { rhoA = 1.0, rhoIy = 1e-3, rhoIz = 1e-3 }
damping = { mass_proportional = 0.5 }
[rod.r]
section = "s"
line = { from = [1, 0, 0], to = [3, 0, 0] }
elements = 4
order = 2
[[support]]
at = "r.start"
move = { x = "cos(5*t)-1", y = "sin(5*t)", z = "0*t" }
[[initial]]
on = "r"
velocity = ["-5*y", "5*x", 0]
angular_velocity = [0, 0, 5]
[analysis]
kind = "dynamic"
end_time = 4.0
time_step = 0.01
)deck";

struct Books {
    LedgerRow last;
    double largest_energy = 0.0;
    double largest_error = 0.0;
    bool falls = false;
};

Books keep_books(const std::string& deck, const std::string& scheme, double time_step = 0.01) {
    const Problem problem =
        read(deck, {"analysis.integrator=" + scheme, "analysis.time_step=" + std::to_string(time_step)});
    RunRequest request{problem};
    Books books;
    request.observe = [&](const Snapshot&, const LedgerRow& row) {
        books.falls = books.falls || row.dissipated_energy < books.last.dissipated_energy ||
                      row.numerical_dissipation < books.last.numerical_dissipation;
        books.last = row;
    };
    const RunSummary summary = run_analysis(request);
    INFO(scheme);
    REQUIRE(summary.status == RunStatus::complete);
    books.largest_energy = summary.totals.largest_energy;
    books.largest_error = summary.totals.largest_energy_error;
    return books;
}

}  // namespace

TEST_CASE("A damped ring that spins loses what its widening takes and no more", "[issues][damping]") {
    // At rest as seen from the ring: R² Ω keeps its value, and EA (R − 1) = ρA Ω² R, for a radius of 1. The
    // energy that is lost on the way there, with the rotary inertia:
    const double L = 1.001 * 10.0;
    double R = 1.0;
    for (int i = 0; i < 50; ++i) R = 1.0 + std::pow(L / (R * R + 1e-3), 2.0) * R / 1e4;
    const double after = 0.5 * L * L / (R * R + 1e-3) + 0.5e4 * (R - 1.0) * (R - 1.0);
    const double lost = 2.0 * M_PI * (0.5 * L * 10.0 - after);
    CHECK(lost == Approx(3.06).margin(0.03));
    for (const std::string scheme : {"newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha"}) {
        const Books books = keep_books(ring, scheme);
        INFO(scheme << ": " << books.last.dissipated_energy << ", error " << books.largest_error);
        CHECK_FALSE(books.falls);
        CHECK(books.last.dissipated_energy == Approx(lost).epsilon(0.03));
        const Books fine = keep_books(ring, scheme, 0.005);
        CHECK_FALSE(fine.falls);
        CHECK(fine.last.dissipated_energy == Approx(lost).epsilon(0.02));
        CHECK(fine.largest_error < 0.3 * books.largest_error);
    }
}

TEST_CASE("Damped rods that spin lose as much whatever the scheme", "[issues][damping]") {
    for (const std::string element : {"objective", "simo"}) {
        const std::string rod = make_rod(element);
        const double lost = keep_books(rod, "sdirk-4", 0.0025).last.dissipated_energy;
        CHECK(lost > 0.01);
        for (const std::string scheme :
             {"newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha"}) {
            INFO(element << ", " << scheme);
            const Books books = keep_books(rod, scheme);
            CHECK_FALSE(books.falls);
            CHECK(books.last.dissipated_energy == Approx(lost).epsilon(0.05));
        }
    }
}

TEST_CASE("Dissipated energy does not fall where steps resolve nothing", "[issues][damping]") {
    for (const std::string scheme : {"newmark-simplified", "generalized-alpha", "sdirk-4"}) {
        INFO(scheme);
        CHECK_FALSE(keep_books(ring, scheme, 0.05).falls);
        CHECK_FALSE(keep_books(make_rod("objective"), scheme, 0.1).falls);
    }
}

TEST_CASE("A support on a circle does the work that a drag dissipates", "[issues][damping]") {
    for (const auto& [scheme, order] : {std::pair("newmark-simplified", 2.0),
                                        {"newmark-ibrahimbegovic", 2.0},
                                        {"generalized-alpha", 2.0},
                                        {"sdirk-4", 3.0}}) {
        const Books coarse = keep_books(towed, scheme, 0.02);
        const Books fine = keep_books(towed, scheme, 0.01);
        INFO(scheme << ": errors " << coarse.largest_error << ", " << fine.largest_error << " of "
                    << fine.last.external_work);
        CHECK_FALSE(fine.falls);
        CHECK(std::log2(coarse.largest_error / fine.largest_error) > order - 0.4);
        CHECK(fine.largest_error < 1e-3 * fine.last.external_work);
    }
}

}  // namespace gxrod::test
