#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::size_t from = 0;
    while (from < text.size()) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        lines.push_back(text.substr(from, end - from));
        from = end + 1;
    }
    return lines;
}

const std::string frame = R"([section.s]
shape = { circle = { radius = 0.01 } }
material = { E = 2.1e11, nu = 0.3, density = 7850 }
[rod.a]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 2
[rod.b]
section = "s"
line = { from = [5, 0, 0], to = [5, 1, 0] }
elements = 2
[rod.c]
section = "s"
line = { from = [9, 0, 0], to = [9, 1, 0] }
elements = 2
[[support]]
at = "a.start"
fix = "all"
[[support]]
at = "b.start"
fix = "all"
[[load]]
at = "a.end"
force = [0, 1, 0]
[[load]]
at = "b.end"
force = [0, 1, 0]
[[load]]
at = "c.end"
force = [0, 1, 0]
[analysis]
kind = "static"
)";

}  // namespace

TEST_CASE("Faults of all phases come in one round", "[deck]") {
    std::string deck = frame;
    deck = replaced(deck, "to = [1, 0, 0] }\nelements", "to = [0, 0, 0] }\nelements");      // geometry
    deck = replaced(deck, "at = \"a.start\"\nfix = \"all\"", "at = \"a.start\"\nfix = 3");  // a type
    deck = replaced(deck, "at = \"b.start\"", "at = \"b.strat\"");                          // a name
    deck = replaced(
        deck, "at = \"a.end\"\nforce = [0, 1, 0]", "at = \"a.end\"\nforce = [0, \"1/q\", 0]");  // a symbol
    deck = replaced(deck, "at = \"b.end\"\nforce", "at = \"b.end\"\nforces = 1\nforce");        // a key
    deck = replaced(deck, "at = \"c.end\"\nforce", "at = \"c.end\"\nmoment = [0, 0, 0]\nforce");
    deck += "[[history]]\nname = \"h\"\nat = \"c.end\"\nquantities = [\"elongation\"]\n";  // what a thing has
    const std::vector<std::string> faults = lines_of(faults_of(deck));
    INFO(faults_of(deck));
    REQUIRE(faults.size() == 6);
    CHECK(faults[0].starts_with("x.toml:6:33: rod.a.line.to: the rod has no length"));
    CHECK(faults[1].starts_with("x.toml:18:7: support[0].fix: expected one or a list of"));
    CHECK(faults[2].starts_with("x.toml:20:6: support[1].at: "));
    CHECK(faults[3].starts_with("x.toml:24:13: load[0].force[1]: "));
    CHECK(faults[4].starts_with("x.toml:27:1: load[1].forces: unknown key"));
    CHECK(faults[5].starts_with(
        "x.toml:38:15: history[0].quantities[0]: \"elongation\": only springs have it"));
}

TEST_CASE("What follows from a fault alone is not one", "[deck]") {
    // All that refers to what is wrong is left for the next time, and lists keep their numbers.
    std::string deck = replaced(frame, "[rod.b]\nsection = \"s\"", "[rod.b]\nsection = 7");
    deck = replaced(deck, "at = \"c.end\"", "at = \"c.edn\"");
    const std::vector<std::string> faults = lines_of(faults_of(deck));
    INFO(faults_of(deck));
    REQUIRE(faults.size() == 2);
    CHECK(faults[0].starts_with("x.toml:9:11: rod.b.section: "));
    CHECK(faults[1].starts_with("x.toml:29:6: load[2].at: "));
    // A wrong parameter takes expressions with it, and an analysis that cannot be read nothing.
    deck = replaced(frame, "force = [0, 1, 0]\n[analysis]", "force = [0, \"p\", 0]\n[analysis]");
    deck = replaced(deck, "kind = \"static\"", "kind = \"statik\"\n[parameters]\np = \"1/0\"");
    deck = replaced(deck, "at = \"b.start\"", "at = \"b.strat\"");
    const std::vector<std::string> others = lines_of(faults_of(deck));
    INFO(faults_of(deck));
    REQUIRE(others.size() == 3);
    CHECK(others[0].starts_with("x.toml:20:6: support[1].at: "));
    CHECK(others[1].starts_with("x.toml:32:8: analysis.kind: "));
    CHECK(others[2].starts_with("x.toml:34:5: parameters.p: "));
    // A section that is wrong takes its rods along, and with them all there is.
    CHECK(lines_of(faults_of(replaced(replaced(frame, "radius = 0.01", "radius = -1"),
                                      "at = \"b.start\"",
                                      "at = "
                                      "\"b.strat\"")))
              .size() == 1);
}

}  // namespace gxrod::test
