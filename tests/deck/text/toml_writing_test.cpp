#include "deck/text/toml_writing.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "tools/catch.hpp"

namespace gxrod {
namespace {

// A tree without places, as text, to compare two.
std::string written_again(const std::string& toml) { return write_toml(read_toml(toml, "")); }

double number_after_round_trip(double number) {
    const DeckNode deck{DeckNode::Table{{"x", {}, {number, {}}}}, {}};
    return std::get<double>(read_toml(write_toml(deck), "").find("x")->node.value);
}

}  // namespace

TEST_CASE("Decks are written with a table a header", "[deck]") {
    CHECK(written_again("a.b = 1\ntop = [1, [2.0, 'x']]\n[rod.'my rod']\nl = {f = [0], t = {}}\n[[load]]\n"
                        "at = 'x'\n[[load]]\n[empty]\n[analysis]\nnewton.tolerance = 1e-8\nkind = \"d\"\n") ==
          R"(top = [1, [2.0, "x"]]

[a]
b = 1

[rod."my rod"]
l = { f = [0], t = {} }

[[load]]
at = "x"

[[load]]

[empty]

[analysis]
newton = { tolerance = 1e-08 }
kind = "d"
)");
}

TEST_CASE("A deck that is written reads the same", "[deck]") {
    const std::string toml =
        "t = \"a\\\"b\\\\c\\n\\t\\ré\"\nb = [true, false]\nd = 1979-05-27T07:32:00Z\n"
        "big = 9223372036854775807\nempty = []\nnone = ''\n[s.'a.b']\nx = -0.0\n";
    const std::string once = written_again(toml);
    CHECK(written_again(once) == once);
    const DeckNode deck = read_toml(once, "");
    CHECK(*deck.find("t")->node.text() == "a\"b\\c\n\t\ré");
    CHECK(std::get<std::int64_t>(deck.find("big")->node.value) == std::numeric_limits<std::int64_t>::max());
    CHECK(std::get<DeckDate>(deck.find("d")->node.value).text == "1979-05-27T07:32:00Z");
    CHECK(std::signbit(std::get<double>(deck.find("s")->node.find("a.b")->node.find("x")->node.value)));
}

TEST_CASE("Numbers are written to the last bit", "[deck]") {
    std::mt19937_64 random(3);
    for (int i = 0; i < 20000; ++i) {
        const double number = std::bit_cast<double>(random());
        if (!std::isfinite(number)) continue;
        REQUIRE(std::bit_cast<std::uint64_t>(number_after_round_trip(number)) ==
                std::bit_cast<std::uint64_t>(number));
    }
    for (const double number : {0.1, 1.0, 1e22, 1e23, 5e-324, 1.7976931348623157e308, 123456789012345680.0}) {
        CHECK(number_after_round_trip(number) == number);
    }
}

}  // namespace gxrod
