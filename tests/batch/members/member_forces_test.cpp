#include "batch/members/member_forces.hpp"

#include <cmath>
#include <filesystem>

#include "batch/cases/case_run.hpp"
#include "deck/decks.hpp"
#include "deck/text/csv_reading.hpp"
#include "deck/text/text_file.hpp"
#include "run/run_to_end.hpp"
#include "tools/catch.hpp"
#include "watch/members.hpp"

namespace gxrod::test {
namespace {

// The tables leave out extension and shear, which make 2e-4 here.
constexpr double near = 5e-4;
constexpr double height = 4.0, span = 6.0, q = 1e-4, W = 2e-4;

// A portal with clamped feet, whose beam is twice as stiff as its columns: under q along the beam and W at
// its corner.
const std::string portal = R"([section.column]
stiffness = { EA = 1e7, GAy = 1e7, GAz = 1e7, GJ = 500, EIy = 1000, EIz = 300 }
[section.beam]
stiffness = { EA = 1e7, GAy = 1e7, GAz = 1e7, GJ = 500, EIy = 2000, EIz = 300 }
[rod.left]
section = "column"
line = { from = [0, 0, 0], to = [0, 0, 4] }
elements = 4
order = 3
z_axis = "up"
[rod.beam]
section = "beam"
line = { from = [0, 0, 4], to = [6, 0, 4] }
elements = 4
order = 3
z_axis = "up"
[rod.right]
section = "column"
line = { from = [6, 0, 0], to = [6, 0, 4] }
elements = 4
order = 3
z_axis = "up"
[[connect]]
points = ["left.end", "beam.start"]
[[connect]]
points = ["right.end", "beam.end"]
[[support]]
at = "left.start"
fix = "all"
[[support]]
at = "right.start"
fix = "all"
[[load]]
case = "dead"
on = "beam"
force_per_length = [0, 0, -1e-4]
[[load]]
case = "wind"
at = "left.end"
force = [2e-4, 0, 0]
[combination.G]
factors = { dead = 1 }
[combination.W]
factors = { wind = 1 }
[combination.ULS]
factors = { dead = 1.35, wind = 1.5 }
[analysis]
kind = "static"
steps = 1
)";

// A row of a table of members.
struct StationRow {
    std::string member, station;
    double s;
    Vec3 position;
    Vec6 forces;  // N, Vy, Vz, T, My, Mz
};

std::vector<StationRow> run_deck(const Problem& problem, const std::filesystem::path& file) {
    const auto write = [&](const SteppedRun& run) { write_member_forces(run, file); };
    REQUIRE(run_to_end(RunRequest{problem}, write).status == RunStatus::complete);
    const std::vector<CsvRow> rows = read_csv(read_text_file(file, "a table", 1e6), file);
    std::vector<StationRow> stations;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const auto number = [&](std::size_t column) { return std::stod(rows[i].fields.at(column)); };
        StationRow& row =
            stations.emplace_back(rows[i].fields.at(0), rows[i].fields.at(1), number(2), Vec3(), Vec6());
        row.position << number(3), number(4), number(5);
        for (std::size_t k = 0; k < 6; ++k) row.forces[static_cast<Eigen::Index>(k)] = number(6 + k);
    }
    return stations;
}

// The forces at the ends of the three members, start and end.
std::vector<Vec6> run_combination(const std::string& name, const std::filesystem::path& file) {
    std::vector<Vec6> ends;
    for (const StationRow& row : run_deck(read(portal, {"apply=" + name}), file)) {
        if (row.station == "start" || row.station == "end") ends.push_back(row.forces);
    }
    return ends;
}

}  // namespace

TEST_CASE("Forces at the ends of a portal are those of the tables", "[batch]") {
    const ScratchFile scratch("members.csv", "");
    // Kleinlogel's rigid frame with clamped feet.
    const double k = 2.0 * height / span;
    const std::vector<Vec6> dead = run_combination("G", scratch.path());
    REQUIRE(dead.size() == 6);
    const double at_foot = q * span * span / (12.0 * (k + 2.0));
    CHECK(std::abs(dead[0][4]) == Approx(at_foot).epsilon(near));
    CHECK(std::abs(dead[1][4]) == Approx(2.0 * at_foot).epsilon(near));
    CHECK(std::abs(dead[2][4]) == Approx(2.0 * at_foot).epsilon(near));
    CHECK(dead[0][0] == Approx(-q * span / 2.0).epsilon(near));
    CHECK(dead[2][0] == Approx(-q * span * span / (4.0 * height * (k + 2.0))).epsilon(near));
    CHECK(std::abs(dead[3][2]) == Approx(q * span / 2.0).epsilon(near));
    const std::vector<Vec6> wind = run_combination("W", scratch.path());
    CHECK(std::abs(wind[0][4]) == Approx(W * height / 2.0 * (3.0 * k + 1.0) / (6.0 * k + 1.0)).epsilon(near));
    CHECK(std::abs(wind[1][4]) == Approx(W * height / 2.0 * 3.0 * k / (6.0 * k + 1.0)).epsilon(near));
    // So small loads superpose.
    const std::vector<Vec6> both = run_combination("ULS", scratch.path());
    for (std::size_t i = 0; i < 6; ++i)
        CHECK((both[i] - 1.35 * dead[i] - 1.5 * wind[i]).norm() < near * both[i].norm());
}

TEST_CASE("A member has its moments at quarter points, and the largest one with its place", "[batch]") {
    // A beam between hinges under q, and −M0 at its end: M = q s (L − s)/2 + M0 s/L.
    constexpr double L = 6.0, load = 1e-4, M0 = -2e-4;
    const std::string beam = R"([section.s]
stiffness = { EA = 1e7, GAy = 1e7, GAz = 1e7, GJ = 500, EIy = 2000, EIz = 300 }
[rod.beam]
section = "s"
line = { from = [1, 0, 4], to = [7, 0, 4] }
elements = 5
order = 3
z_axis = "up"
[[support]]
at = "beam.start"
fix = ["position", "rx", "rz"]
[[support]]
at = "beam.end"
fix = ["y", "z"]
[[load]]
on = "beam"
force_per_length = [0, 0, -1e-4]
[[load]]
at = "beam.end"
moment = [0, 2e-4, 0]
[analysis]
kind = "static"
steps = 1
)";
    const ScratchFile scratch("members.csv", "");
    const std::vector<StationRow> rows = run_deck(read(beam), scratch.path());
    REQUIRE(rows.size() == 6);
    const auto moment_at = [&](double s) { return load * s * (L - s) / 2.0 + M0 * s / L; };
    for (std::size_t i = 0; i < 5; ++i) {
        const double s = L * static_cast<double>(i) / 4.0;
        CHECK(rows[i].s == Approx(s).margin(1e-12));
        CHECK(rows[i].position.x() == Approx(1.0 + s));
        CHECK(std::abs(rows[i].forces[4]) == Approx(std::abs(moment_at(s))).epsilon(1e-5).margin(1e-9));
    }
    CHECK(rows[2].station == "1/2");
    const double at = L / 2.0 + M0 / (load * L);
    CHECK(rows[5].station == "max |M|");
    CHECK(rows[5].s == Approx(at).epsilon(1e-5));
    CHECK(std::abs(rows[5].forces[4]) == Approx(moment_at(at)).epsilon(1e-5));
    CHECK(std::abs(rows[5].forces[2]) < 1e-5 * load * L);
}

TEST_CASE("The envelope names the combinations that govern", "[batch]") {
    const ScratchFile deck("portal.toml", portal);
    const std::filesystem::path folder = deck.path().parent_path();
    const std::optional<Plan> plan = plan_of_combinations(portal, deck.path());
    REQUIRE(plan);
    CHECK(varies_combinations(*plan));
    const CaseList cases(*plan);
    REQUIRE(cases.count() == 3);
    CHECK(cases.overrides(3) == std::vector<std::string>{"apply=\"ULS\""});
    std::filesystem::create_directories(folder / "cases");
    std::vector<CaseRow> rows;
    for (long number = 1; number <= 3; ++number) {
        CaseRow& row = rows.emplace_back();
        row.number = number;
        row.parameters = cases.parameters(number);
        run_combination(row.parameters.at(0), folder / member_path(number, 3));
    }
    const std::vector<MemberRange> whole = write_member_tables(folder, cases, rows);
    REQUIRE(whole.size() == 6);
    CHECK(whole[0].force == "N");
    CHECK(whole[0].least.combination == "ULS");
    CHECK(whole[0].least.member == "right");
    CHECK(whole[0].largest.combination == "W");
    const auto count = [&](const char* name) {
        const std::filesystem::path file = folder / name;
        return read_csv(read_text_file(file, "a table", 1e6), file).size();
    };
    CHECK(count("members.csv") == 1 + 3 * 3 * 6);
    CHECK(count("envelope.csv") == 1 + 3 * (5 * 6 + 1));
    CHECK(!plan_of_combinations(static_rod_deck, deck.path()));
}

TEST_CASE("Members end at corners, branches and points", "[batch]") {
    const auto names = [](const std::string& deck) {
        std::vector<std::string> all;
        for (const Member& member : list_members(read(deck).model)) all.push_back(member.name);
        return all;
    };
    CHECK(names(portal) == std::vector<std::string>{"left", "beam", "right"});
    const std::string bent = replaced(static_rod_deck,
                                      "line = { from = [0, 0, 0], to = [10, 0, 0] }",
                                      "polyline = [[0, 0, 0], [0, 0, 4], [6, 0, 4]]");
    CHECK(names(bent) == std::vector<std::string>{"r/1", "r/2"});
    CHECK(names(bent + "[[support]]\nat = \"r@0.7\"\nfix = \"all\"\n") ==
          std::vector<std::string>{"r/1", "r/2", "r/3"});
}

}  // namespace gxrod::test
