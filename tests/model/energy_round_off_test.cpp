#include "model/energy_round_off.hpp"

#include "analyses/static.hpp"
#include "deck/decks.hpp"
#include "tools/catch.hpp"
#include "tools/static_run.hpp"

using namespace gxrod;

TEST_CASE("Energies of a rod that is turned and bears nothing are round-off", "[model]") {
    const Problem problem = test::read(test::static_rod_deck + R"([[support]]
at = "r.start"
fix = ["position", "rx", "ry"]
move = { rz = 30 }
)");
    const double round_off = compute_energy_round_off(problem.model);
    const tools::StaticRun run =
        tools::run_static(problem.model, std::get<StaticSettings>(problem.analysis()));
    CHECK(run.ledger.strain_energy > 0.0);
    CHECK(run.ledger.strain_energy < round_off);
    CHECK(std::abs(run.ledger.energy_error) < round_off);
    // Far below the energy of a load that anyone would notice: a force of 1e-2 at the end.
    const double noticed = 0.5 * 1e-4 * 1e3 / (3.0 * 700.0);
    CHECK(round_off < 1e-4 * noticed);
    CHECK(compute_energy_round_off(test::read(test::static_rod_deck).model) < 1e-10 * round_off);
}

TEST_CASE("The round-off of energy goes by the model's units as energy does", "[model]") {
    const auto energy_of = [](const std::string& text) {
        return compute_energy_round_off(test::read(text).model);
    };
    const double once = energy_of(test::static_rod_deck);
    const std::string stiffer =
        test::replaced(test::static_rod_deck,
                       "EA = 1e4, GAy = 2e4, GAz = 3e4, GJ = 500, EIy = 600, EIz = 700",
                       "EA = 1e10, GAy = 2e10, GAz = 3e10, GJ = 500e6, EIy = 600e6, EIz = 700e6");
    CHECK(energy_of(stiffer) == Approx(1e6 * once).epsilon(1e-12));
    // Millimetres for metres, with EA in N and EI in N mm².
    const std::string millimetres = test::replaced(
        test::replaced(
            test::static_rod_deck, "GJ = 500, EIy = 600, EIz = 700", "GJ = 500e6, EIy = 600e6, EIz = 700e6"),
        "[10, 0, 0]",
        "[10000, 0, 0]");
    CHECK(energy_of(millimetres) == Approx(1e3 * once).epsilon(1e-12));
}
