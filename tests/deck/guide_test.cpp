#include <fstream>
#include <sstream>

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// The decks of a page of the guide, one after the other.
std::string toml_of(const std::string& page) {
    std::ifstream file(GXROD_SOURCE_DIR "/docs/guide/" + page);
    std::string deck;
    bool is_toml = false;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("```")) {
            is_toml = line == "```toml";
        } else if (is_toml) {
            deck += line + "\n";
        }
    }
    return deck;
}

const std::string analysis = "[analysis]\nkind = \"dynamic\"\nend_time = 1.0\nsteps = 10\n";

}  // namespace

TEST_CASE("The sections and rods of the guide are a deck", "[deck]") {
    const std::string deck = toml_of("sections.md") + toml_of("geometry.md") + analysis;
    const Problem problem = read_problem_text(deck, GXROD_SOURCE_DIR "/guide.toml");
    CHECK(problem.model.sections.size() == 6);
    REQUIRE(problem.model.rods.size() == 8);
    CHECK(problem.model.rods[3].order == 3);
    CHECK(problem.model.rods.back().element_count() == 12);
    CHECK(problem.model.supports.size() == 1);
}

}  // namespace gxrod::test
