#include <cmath>
#include <fstream>

#include "deck/surroundings/rao_file.hpp"
#include "deck/surroundings/surroundings_decks.hpp"
#include "machine/file_error.hpp"
#include "machine/temporary_folder.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

const std::string header = "period, heading, heave, heave_phase, pitch, pitch_phase\n";
const std::string grid =
    header + "5, 0, 0.5, 20, 1, 90\n20, 0, 1, 0, 0.2, 90\n5, 180, 0.5, 20, 1, 90\n20, 180, 1, 0, 0.2, 90\n";

const std::string vessel_deck = R"deck(gravity = [0, 0, -9.81]
fluid = { density = 1025, surface = 0, ramp = 10 }
[section.s]
stiffness = { EA = 1e6, GAy = 4e5, GAz = 4e5, GJ = 1e3, EIy = 1e3, EIz = 1e3 }
inertia = { rhoA = 40, rhoIy = 0.01, rhoIz = 0.01 }
fluid = { outer_diameter = 0.1 }
[rod.r]
section = "s"
catenary = { from = [-60, 0, -50], to = [10, 0, -2], length = 95 }
elements = 20
[[wave]]
airy = { height = 4, period = 10 }
[vessel.ship]
rao = "raos.csv"
at = [0, 0, 0]
phases = "lag"
offset = [3, 0, 0]
[[support]]
at = "r.start"
fix = "position"
[[support]]
at = "r.end"
vessel = "ship"
[[stage]]
name = "hang"
kind = "static"
[[stage]]
name = "waves"
kind = "dynamic"
end_time = 30
steps = 300
)deck";

// The fault of a file, or of a deck with a file.
std::string fault_of(const std::string& bytes) {
    try {
        read_raos(bytes, "raos.csv");
    } catch (const FileError& error) {
        return error.what();
    }
    return "";
}

class Folder {
  public:
    explicit Folder(const std::string& raos) { write("raos.csv", raos); }
    Problem read(const std::string& deck) const {
        write("deck.toml", deck);
        return read_problem(folder_.path() / "deck.toml");
    }
    std::string faults(const std::string& deck) const {
        try {
            read(deck);
        } catch (const DeckError& error) {
            return error.what();
        }
        return "";
    }

  private:
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_.path() / name) << text;
    }
    TemporaryFolder folder_{"vessel_test"};
};

}  // namespace

TEST_CASE("The end of a line on a vessel moves as its response says", "[deck]") {
    const Folder folder(grid);
    const Problem problem = folder.read(vessel_deck);
    const Support& hanging = problem.model.supports.at(1);
    CHECK(hanging.moved == std::array<bool, 6>{true, true, true, false, false, false});
    CHECK(hanging.motion[0](1.0) == 3.0);
    CHECK(hanging.motion[0](0.5) == 1.5);
    CHECK(hanging.motion[2](1.0) == 0.0);
    const Support& moving = problem.stages.at(1).actions.supports.at(1);
    // ω between those of 20 and 5 s: complex numbers by a third.
    const std::complex<double> heave = 2.0 / 3.0 * 1.0 + 1.0 / 3.0 * std::polar(0.5, -20.0 * M_PI / 180.0);
    const double degree = M_PI / 180.0;
    const std::complex<double> pitch = std::polar((2.0 / 3.0 * 0.2 + 1.0 / 3.0) * degree, -90.0 * degree);
    const double omega = 2.0 * M_PI / 10.0, number = omega * omega / 9.81;
    for (const double t : {12.0, 17.3, 29.0}) {
        const std::complex<double> here = std::polar(2.0, omega * t - number * 3.0);
        const double angle = (pitch * here).real(), z = (heave * here).real();
        // Turned about y with the arm (10, 0, −2).
        CHECK(moving.motion[0](t) ==
              Approx(3.0 + 10.0 * (std::cos(angle) - 1.0) - 2.0 * std::sin(angle)).epsilon(1e-9));
        CHECK(moving.motion[2](t) ==
              Approx(z - 10.0 * std::sin(angle) - 2.0 * (std::cos(angle) - 1.0)).epsilon(1e-9));
        CHECK(moving.motion[1](t) == Approx(0.0).margin(1e-12));
    }
    CHECK(moving.motion[2](0.0) == 0.0);
    const Problem led = folder.read(replaced(vessel_deck, "\"lag\"", "\"lead\""));
    const double t = 29.0;
    const double angle = (std::conj(pitch) * std::polar(2.0, omega * t - number * 3.0)).real();
    CHECK(led.stages.at(1).actions.supports.at(1).motion[0](t) ==
          Approx(3.0 + 10.0 * (std::cos(angle) - 1.0) - 2.0 * std::sin(angle)).epsilon(1e-9));
}

TEST_CASE("What fix names follows the vessel", "[deck]") {
    const Folder folder(grid);
    const std::string at_vessel = "vessel = \"ship\"\n";
    const Problem clamped = folder.read(replaced(vessel_deck, at_vessel, at_vessel + "fix = \"all\"\n"));
    CHECK(clamped.model.supports.at(1).moved == std::array<bool, 6>{true, true, true, true, true, true});
    const Problem plane = folder.read("plane = \"xz\"\n" + vessel_deck);
    CHECK(plane.model.supports.at(1).moved == std::array<bool, 6>{true, false, true, false, false, false});
    CHECK(plane.model.supports.at(1).fixed == std::array<bool, 6>{false, true, false, true, false, true});
}

TEST_CASE("What is wrong with a vessel is said where it stands", "[deck]") {
    const Folder folder(grid);
    CHECK_THAT(folder.faults(replaced(vessel_deck, "\"ship\"", "\"boat\"")),
               Contains("deck.toml:23") && Contains("no vessel \"boat\"") && Contains("ship"));
    CHECK_THAT(folder.faults(replaced(vessel_deck, ", ramp = 10", "")),
               Contains("vessel.ship.rao") && Contains("ramp"));
    CHECK_THAT(folder.faults(replaced(vessel_deck, "period = 10", "period = 4")),
               Contains("period of 4") && Contains("from 5 to 20"));
    CHECK_THAT(folder.faults(replaced(vessel_deck, "phases = \"lag\"\n", "")), Contains("phases"));
    CHECK_THAT(folder.faults(replaced(vessel_deck, "[[stage]]\nname = \"hang\"\nkind = \"static\"\n", "")),
               Contains("vessel.ship.offset") && Contains("static stage"));
    CHECK_THAT(
        folder.faults(replaced(vessel_deck, "vessel = \"ship\"", "vessel = \"ship\"\nmove = { x = 0 }")),
        Contains("vessel") && Contains("move"));
    const Folder rolling(replaced(replaced(grid, "pitch,", "roll,"), "pitch_phase", "roll_phase"));
    CHECK_THAT(rolling.faults("plane = \"xz\"\n" + vessel_deck),
               Contains("leaves the plane") && Contains("rx"));
}

TEST_CASE("Files of responses that are not whole are refused", "[deck]") {
    CHECK(fault_of(grid).empty());
    CHECK(read_raos(grid, "raos.csv").size() == 4);
    CHECK(read_raos(grid, "raos.csv").front().frequency == Approx(2.0 * M_PI / 20.0));
    CHECK_THAT(fault_of("5, 0, 1, 0\n"), Contains("raos.csv:1") && Contains("names the columns"));
    CHECK_THAT(fault_of("period, heading, heaf, heaf_phase\n5, 0, 1, 0\n"), Contains("no column \"heaf\""));
    CHECK_THAT(fault_of("period, heading, heave\n5, 0, 1\n"), Contains("heave_phase"));
    CHECK_THAT(fault_of("heading, heave, heave_phase\n5, 0, 1\n"), Contains("period or frequency"));
    CHECK_THAT(fault_of(header + "5, 0, 1, 0, 1\n"), Contains("raos.csv:2") && Contains("6 columns"));
    CHECK_THAT(fault_of(header + "0, 0, 1, 0, 1, 0\n"), Contains("raos.csv:2") && Contains("positive"));
    CHECK_THAT(fault_of(grid + "7, 180, 1, 0, 1, 0\n"), Contains("each period once for each heading"));
    CHECK_THAT(fault_of(grid + "5, 0, 1, 0, 1, 0\n"), Contains("each period once for each heading"));
}

}  // namespace gxrod::test
