#include <fstream>
#include <sstream>

#include <set>

#include "deck/decks.hpp"
#include "deck/schema/schema.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

void add_examples(const TableSpec& table, std::string& deck) {
    deck += table.example + "\n";
    for (const KeySpec& key : table.keys) {
        if (key.table != nullptr) add_examples(*key.table, deck);
    }
}

std::string read_file(const std::string& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace

TEST_CASE("The page docs/deck.md is what the schema says", "[deck]") {
    const bool is_current = read_file(GXROD_SOURCE_DIR "/docs/deck.md") == deck_reference() + "\n";
    INFO("Regenerate it: gxrod schema --markdown > docs/deck.md");
    CHECK(is_current);
}

TEST_CASE("The reference has every key and every example", "[deck]") {
    const std::string reference = deck_reference();
    for (const KeySpec& key : deck_schema().keys) {
        if (key.shape == KeyShape::value) {
            CHECK(reference.find("| `" + key.name + "` |") != std::string::npos);
            continue;
        }
        CHECK(reference.find("## " + key.table->heading) != std::string::npos);
        // Their pages have the examples: the deck here has an [analysis] without them.
        const std::set<std::string> others{"stage", "rotation", "imperfection", "vessel"};
        const bool excludes_others = others.contains(key.name);
        CHECK(key.table->example.empty() == excludes_others);
        CHECK(reference.find(key.table->example) != std::string::npos);
        for (const KeySpec& inner : key.table->keys) {
            CHECK(reference.find("| `" + inner.name + "` |") != std::string::npos);
        }
    }
    CHECK(reference.find("| `stiffness.GAz` |") != std::string::npos);
}

TEST_CASE("The examples of the reference, one after the other, are a deck", "[deck]") {
    std::string deck;
    add_examples(deck_schema(), deck);
    CHECK(faults_of(deck).empty());
    const Problem problem = read(deck);
    CHECK(problem.model.rods.size() == 5);
    CHECK(problem.model.bodies.size() == 1);
    CHECK(problem.model.loads.size() == 2);
    CHECK(problem.model.distributed_loads.size() == 2);  // one of them magnetic
    CHECK(problem.model.tendons.size() == 2);            // one is a chamber
    CHECK(problem.model.actuations.size() == 1);
    CHECK(problem.model.supports.size() == 2);
    CHECK(problem.output.histories.size() == 1);
}

}  // namespace gxrod::test
