// Runs of rods whose sections have laws.
#include <cmath>

#include "deck/decks.hpp"
#include "run/stepped_run.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// A cantilever that is swung to and fro.
std::string swing(const std::string& law, const std::string& analysis) {
    return R"deck([section.s]
stiffness = { EA = 1e3, GAy = 1e3, GAz = 1e3, GJ = 5, EIy = 6, EIz = 7 }
inertia = { rhoA = 1.0, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
)deck" + law +
           R"deck(
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 3
order = 2
[[support]]
at = "r.start"
fix = "all"
[[load]]
at = "r.end"
force = [0, "2*sin(3*t)", "3*sin(2*t)"]
[analysis]
newton = { tolerance = 1e-12 }
end_time = 2.0
)deck" + analysis;
}

const std::string layers = "law = { layers = [{ on = \"bending\", stiffness = 5, limit = 0.8 }] }";
const std::string plastic = "law = { plastic = { yield = { My = 2, Mz = 2, T = 0.3 }, kinematic = 0.2 } }";
const std::string creep = "law = { viscoelastic = { prony = [[0.5, 0.1], [0.2, 2]] } }";
const std::string elastic = "law = { moment_curvature = { table = [[0, 0], [0.1, 1], [1, 5]] } }";

struct Books {
    double energy_error = 0.0;  // the largest
    double dissipated = 0.0;
    bool is_monotone = true;
};

Books run(const std::string& deck) {
    const Problem problem = read(deck);
    RunRequest request{problem};
    SteppedRun simulation(std::move(request));
    REQUIRE(simulation.start());
    Books books;
    while (simulation.step()) {
        const LedgerRow row = simulation.analysis().ledger_row();
        books.is_monotone = books.is_monotone && row.dissipated_energy >= books.dissipated;
        books.dissipated = row.dissipated_energy;
        books.energy_error = std::max(books.energy_error, std::abs(row.energy_error));
    }
    REQUIRE(simulation.summary().reason.empty());
    return books;
}

}  // namespace

TEST_CASE("the books of rods that yield, slip and relax balance to the order of the step", "[analyses]") {
    for (const std::string& law : {layers, plastic, creep, elastic}) {
        for (const std::string scheme : {"kind = \"dynamic\"", "kind = \"quasi-static\""}) {
            CAPTURE(law, scheme);
            const Books coarse = run(swing(law, scheme + "\ntime_step = 0.02\n"));
            const Books fine = run(swing(law, scheme + "\ntime_step = 0.005\n"));
            CHECK(coarse.is_monotone);
            CHECK(fine.is_monotone);
            CHECK((fine.dissipated > 0.02) == (law != elastic));
            CHECK(fine.energy_error < coarse.energy_error / 8.0);
            CHECK(fine.energy_error < 0.02 * std::max(fine.dissipated, 1.0));
        }
    }
}

TEST_CASE("a law that does nothing leaves the linear rod", "[analyses]") {
    const auto end_of = [](const std::string& law) {
        const Problem problem = read(swing(law, "kind = \"dynamic\"\ntime_step = 0.02\n"));
        SteppedRun simulation(RunRequest{problem});
        while (simulation.step()) {
        }
        REQUIRE(simulation.summary().reason.empty());
        return simulation.analysis().state().trial.back().r;
    };
    const Vec3 linear = end_of("");
    for (const std::string law :
         {"law = { moment_curvature = { y = [[0, 0], [1, 6]], z = [[0, 0], [1, 7]] } }",
          "law = { plastic = { yield = { My = 1e9, Mz = 1e9 } } }",
          "law = { viscoelastic = { prony = [[0, 1]] } }"}) {
        CAPTURE(law);
        CHECK((end_of(law) - linear).norm() < 1e-11);
    }
}

}  // namespace gxrod::test
