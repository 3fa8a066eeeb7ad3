#include "deck/sections/section_files.hpp"

#include <fmt/format.h>

#include "deck/decks.hpp"
#include "machine/file_error.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

const std::string header = "fraction,twist,K11,K22,K33,K44,K55,K66,K56,M11,M22,M33,M44,M55,M66,M26\n";
const std::string plain = header +
                          "0,   0.2, 200,80,80,5,6,7,1, 3,3,3,0.3,0.1,0.2,0\n"
                          "# half\n"
                          "0.5, 0.1, 100,40,40,2,3,4,0, 1,1,1,0.3,0.1,0.2,0\n"
                          "0.5, 0.1, 300,40,40,2,3,4,0, 1,1,1,0.3,0.1,0.2,0\n"
                          "1,   0.0, 400,40,40,2,3,4,0, 2,2,2,0.3,0.1,0.2,0\n";

SectionFile read_rows(const std::string& text) { return read_section_file(text, "blade.csv"); }

std::string with(const std::string& old_text, const std::string& new_text) {
    return replaced(plain, old_text, new_text);
}

// A deck next to blade.csv.
struct Beside {
    ScratchFile table;
    std::filesystem::path deck;

    explicit Beside(const std::string& csv)
        : table("blade.csv", csv), deck(table.path().parent_path() / "d.toml") {}

    Problem read(const std::string& text) const { return read_problem_text(text, deck.string()); }
};

const std::string blade_deck = R"deck([rod.r]
sections = { file = "blade.csv", damping = { kelvin_voigt = 0.01 } }
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 2
order = 1
[[support]]
at = "r.start"
fix = "all"
[analysis]
kind = "dynamic"
end_time = 1
steps = 10
)deck";

}  // namespace

TEST_CASE("a file has a section for each station", "[deck][sections]") {
    const SectionFile file = read_rows("\xEF\xBB\xBF" + plain);
    REQUIRE(file.rows.size() == 4);
    CHECK(file.rows[1].fraction == 0.5);
    CHECK(file.rows[2].fraction == 0.5);
    const Mat6& K = file.rows[0].section.stiffness;
    CHECK(K(0, 0) == 200.0);
    CHECK(K(4, 5) == 1.0);
    CHECK(K(5, 4) == 1.0);
    CHECK(K(0, 5) == 0.0);
    CHECK(file.rows[3].section.mass(2, 2) == 2.0);
    const std::vector<std::pair<double, double>> twist{{0.0, 0.2}, {0.5, 0.1}, {1.0, 0.0}};
    CHECK(file.twist == twist);
    // The order of columns is free.
    const std::string turned = "K11,K22,K33,K44,K55,K66,fraction\n1,2,3,4,5,6,0\n1,2,3,4,5,6,1\n";
    CHECK(read_rows(turned).rows[0].section.stiffness(5, 5) == 6.0);
    CHECK(read_rows(turned).rows[0].section.mass.isZero(0.0));
    CHECK(read_rows(turned).twist.empty());
}

TEST_CASE("every entry of a file of sections has its place", "[deck][sections]") {
    std::string names = "fraction";
    std::string numbers;
    for (int i = 1; i <= 6; ++i) {
        for (int j = i; j <= 6; ++j) {
            names += fmt::format(",K{}{}", i, j);
            numbers += fmt::format(",{}", i == j ? 100.0 * i : i + 0.1 * j);
        }
    }
    const SectionFile file = read_rows(names + "\n0" + numbers + "\n1" + numbers + "\n");
    const Mat6& K = file.rows[1].section.stiffness;
    CHECK(K.isApprox(K.transpose(), 0.0));
    for (int i = 1; i <= 6; ++i) {
        for (int j = i; j <= 6; ++j) CHECK(K(i - 1, j - 1) == Approx(i == j ? 100.0 * i : i + 0.1 * j));
    }
}

TEST_CASE("what is wrong with a file of sections is said with its place", "[deck][sections]") {
    const auto refused = [](const std::string& text, const std::string& message) {
        CHECK_THROWS_WITH(read_rows(text), Contains(message));
    };
    refused(with("100,40", "100,x40"), "blade.csv:4:4: expected a finite number, found \"x40\"");
    refused(with("400,40,40,2,3,4,0,", "400,40,40,2,3,4,"), "blade.csv:6:16: expected 16 fields");
    refused(with("K56", "K65"), "blade.csv:1:9: unknown column \"K65\"; entries stand on and above");
    refused(with("twist", "twits"), "blade.csv:1:2: unknown column \"twits\"; did you mean \"twist\"?");
    refused(with("K56", "K11"), "blade.csv:1:9: a column K11 is there already");
    refused(with(",K44", ",K45"), "blade.csv:1:1: there is no column K44");
    refused(with(",M44", ",M45"), "there is no column M44");
    refused(with("fraction", "K12"), "there is no column fraction");
    refused(with("0,   0.2", "0.1, 0.2"), "blade.csv:2:1: expected the fraction 0 here, found 0.1");
    refused(with("1,   0.0", "0.9, 0.0"),
            "blade.csv:6:1: expected the fraction 1 in the last row, found 0.9");
    refused(with("1,   0.0", "1.9, 0.0"), "blade.csv:6:1: expected at most 1, found 1.9");
    refused(with("1,   0.0", "0.2, 0.0"), "0.2 follows 0.5");
    refused(with("0.1, 300", "0.2, 300"), "blade.csv:5:2: expected the twist 0.1 of the row before");
    refused(with("5,6,7,1", "5,6,7,9"), "blade.csv:2:3: K: expected a positive definite matrix");
    refused(with("5,6,7,1", "-5,6,7,1"), "blade.csv:2:6: K44: expected a number greater than 0");
    refused(with("0.1,0.2,0\n#", "0.1,0.2,0.1\n#"), "blade.csv:2:16: M26: expected 0");
    refused(with("3,3,3", "3,4,3"), "blade.csv:2:11: M22: expected 3");
    refused(header, "blade.csv:1:1: expected rows from the fraction 0 to 1");
    refused("", "expected a line with the names of the columns");
    refused("0,1,2\n", "blade.csv:1:1: expected a line with the names");
}

TEST_CASE("a rod takes its sections from a file next to the deck", "[deck][sections]") {
    const Beside beside(plain);
    const Problem problem = beside.read(blade_deck);
    const Rod& rod = problem.model.rods[0];
    REQUIRE(rod.varying.at_nodes.size() == 4);
    CHECK(rod.varying.at_forces[0].stiffness(0, 0) == Approx(150.0).epsilon(1e-15));
    CHECK(rod.varying.at_forces[0].stiffness(4, 5) == Approx(0.5).epsilon(1e-15));
    CHECK(rod.varying.at_forces[1].stiffness(0, 0) == Approx(350.0).epsilon(1e-15));
    CHECK(rod.varying.at_nodes[1].stiffness(0, 0) == 100.0);
    CHECK(rod.varying.at_nodes[2].stiffness(0, 0) == 300.0);
    const Section& mean = problem.model.sections.at(static_cast<std::size_t>(rod.section));
    CHECK(mean.name == "blade.csv along r");
    CHECK(mean.kelvin_voigt == 0.01);
    CHECK(mean.mass(0, 0) == Approx(0.5 * 2.0 + 0.5 * 1.5).epsilon(1e-14));
    // Twist is right-handed about the tangent.
    const Vec3 y = rod.triads.front() * Vec3::UnitY();
    CHECK(y.isApprox(Vec3(0.0, std::cos(0.2), std::sin(0.2)), 1e-14));
    CHECK((rod.triads.back() * Vec3::UnitY()).isApprox(Vec3::UnitY(), 1e-14));
    const Problem trapeze = beside.read(replaced(blade_deck, "damping =", "trapeze = true, damping ="));
    for (const Section& section : trapeze.model.rods[0].varying.at_forces)
        CHECK(section.law->describe() == "linear; shortens as it twists");
    // Kept, and read again from there.
    REQUIRE(problem.record.meshes.size() == 1);
    CHECK(problem.record.meshes[0].file == "blade.csv");
    CHECK(problem.record.meshes[0].bytes == plain);
    const Problem again = rebuild_problem(problem.record);
    CHECK(again.model.rods[0].varying.at_forces[1].stiffness == rod.varying.at_forces[1].stiffness);
}

TEST_CASE("what a deck cannot do with a file of sections is said", "[deck][sections]") {
    const Beside beside(plain);
    CHECK_THROWS_WITH(beside.read(replaced(blade_deck, "blade.csv", "wing.csv")),
                      Contains("rod.r.sections.file") && Contains("wing.csv"));
    CHECK_THROWS_WITH(beside.read(replaced(blade_deck, "order = 1", "order = 1\ntwist = 0.3")),
                      Contains("rod.r.twist: the file of its sections has a column twist"));
    CHECK_THROWS_WITH(beside.read(replaced(blade_deck, "file = \"blade.csv\", ", "")),
                      Contains("rod.r.sections.file: missing"));
    CHECK_THROWS_WITH(beside.read(replaced(blade_deck, "kelvin_voigt", "kelvin_voight")),
                      Contains("rod.r.sections.damping.kelvin_voight: unknown key"));
    CHECK_THROWS_WITH(beside.read(replaced(blade_deck, "sections = {", "section = \"x\"\nsections = {")),
                      Contains("only one of them can be"));
    const Beside light("fraction,K11,K22,K33,K44,K55,K66\n0,1,1,1,1,1,1\n1,1,1,1,1,1,1\n");
    CHECK_THROWS_WITH(light.read(blade_deck), Contains("has no columns M11 … M66"));
    CHECK_NOTHROW(light.read(
        replaced(blade_deck, "kind = \"dynamic\"\nend_time = 1\nsteps = 10", "kind = \"static\"")));
    const std::string bad = with("100,40", "100,x40");
    CHECK_THROWS_WITH(Beside(bad).read(blade_deck), Contains("2:21: rod.r.sections.file: blade.csv:4:4: "));
}

}  // namespace gxrod::test
