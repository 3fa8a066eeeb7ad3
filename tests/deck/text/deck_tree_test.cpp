#include "deck/text/deck_tree.hpp"

#include "tools/catch.hpp"

namespace gxrod {
namespace {

std::vector<std::string> keys_of(const DeckNode& node) {
    std::vector<std::string> keys;
    for (const DeckEntry& entry : *node.table()) keys.push_back(entry.key);
    return keys;
}

}  // namespace

TEST_CASE("Keys are in the order of the text", "[deck]") {
    const DeckNode deck =
        read_toml("title = \"x\"\n[rod.z]\nb = 1\na = 2\n[body.q]\n[rod.a]\n[[load]]\n[[load]]\n", "");
    CHECK(keys_of(deck) == std::vector<std::string>{"title", "rod", "body", "load"});
    CHECK(keys_of(deck.find("rod")->node) == std::vector<std::string>{"z", "a"});
    CHECK(keys_of(deck.find("rod")->node.find("z")->node) == std::vector<std::string>{"b", "a"});
    CHECK(deck.find("load")->node.array()->size() == 2);
    CHECK(deck.find("nothing") == nullptr);
}

TEST_CASE("Keys and values know their line and column, in characters", "[deck]") {
    const DeckNode deck = read_toml("[a]\n\"ü\" = { s = \"größe\", v = [1,\n  2.5] }\n", "");
    const DeckEntry& entry = deck.find("a")->node.table()->front();
    CHECK(entry.place == Place{-1, 2, 1});
    CHECK(entry.node.place == Place{-1, 2, 7});
    const DeckEntry& vector = *entry.node.find("v");
    CHECK(vector.place == Place{-1, 2, 22});
    CHECK((*vector.node.array())[1].place == Place{-1, 3, 3});
    CHECK(deck.find("a")->node.place == Place{-1, 1, 1});
}

TEST_CASE("Values have their types", "[deck]") {
    const DeckNode deck =
        read_toml("i = 3\nf = 3.0\nh = 0x10\nb = true\nd = 2020-01-02\ns = 'x'\nn = nan", "");
    CHECK(std::get<std::int64_t>(deck.find("i")->node.value) == 3);
    CHECK(std::get<double>(deck.find("f")->node.value) == 3.0);
    CHECK(std::get<std::int64_t>(deck.find("h")->node.value) == 16);
    CHECK(std::get<bool>(deck.find("b")->node.value));
    CHECK(std::get<DeckDate>(deck.find("d")->node.value).text == "2020-01-02");
    CHECK(*deck.find("s")->node.text() == "x");
    CHECK(std::holds_alternative<double>(deck.find("n")->node.value));
}

TEST_CASE("A deck can have Windows line ends and a byte order mark", "[deck]") {
    const DeckNode deck = read_toml("\xEF\xBB\xBFtitle = \"x\"\r\n[a]\r\nb = 1\r\n", "");
    CHECK(keys_of(deck) == std::vector<std::string>{"title", "a"});
    CHECK(deck.find("a")->node.find("b")->node.place == Place{-1, 3, 5});
}

}  // namespace gxrod
