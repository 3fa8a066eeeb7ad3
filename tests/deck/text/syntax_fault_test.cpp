
#include "deck/decks.hpp"

#include "tools/catch.hpp"

namespace gxrod::test {

TEST_CASE("Numbers without a digit next to the point are explained", "[deck]") {
    CHECK(faults_of(replaced(body_deck, "mass = 1.0", "mass = 1.")) ==
          "x.toml:2:8: TOML does not read 1., a number with no digit next to its point: write 1.0");
    CHECK(faults_of(replaced(body_deck, "mass = 1.0", "mass = .5")) ==
          "x.toml:2:8: TOML does not read .5, a number with no digit next to its point: write 0.5");
    CHECK(faults_of(replaced(body_deck, "mass = 1.0", "mass = -.5e3")) ==
          "x.toml:2:8: TOML does not read -.5e3, a number with no digit next to its point: write -0.5e3");
    CHECK(faults_of(replaced(body_deck, "[1, 1, 1]", "[1, 1., 1]")) ==
          "x.toml:3:15: TOML does not read 1., a number with no digit next to its point: write 1.0");
    CHECK(faults_of(replaced(body_deck, "[1, 1, 1]", "[1, 1.e5, 1]")) ==
          "x.toml:3:15: TOML does not read 1.e5, a number with no digit next to its point: write 1.0e5");
}

TEST_CASE("Unquoted text and other syntax errors have their place", "[deck]") {
    CHECK(faults_of(replaced(body_deck, "mass = 1.0", "mass = pi/2 # half")) ==
          R"(x.toml:2:8: pi/2 is no TOML value: text and expressions stand in quotes, "pi/2")");
    CHECK(faults_of(replaced(body_deck, "[1, 1, 1]", "[1 1, 1]")) ==
          "x.toml:3:14: not TOML: expected comma or closing ']', saw '1'");
    CHECK(faults_of(replaced(body_deck, "[body.top]", "[body.top")) ==
          R"(x.toml:1:10: not TOML: expected ']', saw '\n')");
    CHECK(faults_of(replaced(body_deck, "mass = 1.0", R"(mass = 1.0
mass = 2.0)")) == "x.toml:3:8: not TOML: cannot redefine existing floating-point 'mass'");
    CHECK(faults_of(body_deck + "[body.top]") ==
          "x.toml:8:1: not TOML: cannot redefine existing table 'body.top'");
    CHECK(faults_of(replaced(body_deck, "mass = 1.0", "mass = 1e400")) ==
          "x.toml:2:8: 1e400 is out of the range of numbers");
    CHECK(faults_of(replaced(body_deck, R"("dynamic")", "\"dynamic")) ==
          "x.toml:5:16: text without its closing quote");
    CHECK(faults_of(replaced(body_deck, "mass = 1.0", R"(mass = "größe" + .5)")) ==
          "x.toml:2:16: not TOML: expected a comment or whitespace, saw '+'");
}

}  // namespace gxrod::test
