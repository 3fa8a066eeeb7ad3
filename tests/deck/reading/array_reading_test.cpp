
#include "deck/decks.hpp"

#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// rod_deck with a polyline that begins in line 6.
std::string with_polyline(const std::string& value) {
    return replaced(rod_deck, "line = { from = [0, 0, 0], to = [10, 0, 0] }", "polyline = " + value);
}

// rod_deck with a stiffness matrix that begins in line 2.
std::string with_matrix(const std::string& value) {
    return replaced(rod_deck,
                    "stiffness = { EA = 1e4, GAy = 2e4, GAz = 3e4, GJ = 500, EIy = 600, EIz = 700 }",
                    "stiffness_matrix = " + value);
}

}  // namespace

TEST_CASE("Lists of vectors are of two or more, with three numbers each", "[deck]") {
    const std::string expected =
        "expected an array of 2 vectors or more, each of 3 numbers or expressions, found ";
    CHECK(faults_of(with_polyline("5")) == "x.toml:6:12: rod.r.polyline: " + expected + "5");
    CHECK(faults_of(with_polyline("[[1, 2, 3]]")) ==
          "x.toml:6:12: rod.r.polyline: " + expected + "an array of 1");
    CHECK(faults_of(with_polyline("[0, 1, 2]")) ==
          R"(x.toml:6:13: rod.r.polyline[0]: expected an array of 3 numbers or expressions, found 0
x.toml:6:16: rod.r.polyline[1]: expected an array of 3 numbers or expressions, found 1
x.toml:6:19: rod.r.polyline[2]: expected an array of 3 numbers or expressions, found 2)");
    CHECK(faults_of(with_polyline("[[0, 0, 0],\n [1, 2], [3, true, \"q\"]]")) ==
          R"(x.toml:7:2: rod.r.polyline[1]: expected an array of 3 numbers or expressions, found an array of 2
x.toml:7:14: rod.r.polyline[2][1]: expected a number or an expression, found a boolean
x.toml:7:20: rod.r.polyline[2][2]: "q": unknown name "q"; available: pi)");
}

TEST_CASE("Matrices of sections have six rows of six", "[deck]") {
    CHECK(faults_of(with_matrix("[1, 2, 3]")) ==
          "x.toml:2:20: section.s.stiffness_matrix: expected an array of 6 rows of 6 numbers or "
          "expressions, found an array of 3");
    const std::string row = "[1, 1, 1, 1, 1, 1],";
    CHECK(
        faults_of(with_matrix("[" + row + "\n[1, 2]," + row + row + row + "\n[0, 0, inf, 0, 0, 0]]")) ==
        R"(x.toml:3:1: section.s.stiffness_matrix[1]: expected an array of 6 numbers or expressions, found an array of 2
x.toml:4:8: section.s.stiffness_matrix[5][2]: expected a finite number, found inf)");
}

}  // namespace gxrod::test
