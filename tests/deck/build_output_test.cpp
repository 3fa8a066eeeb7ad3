#include "deck/choices.hpp"
#include "deck/decks.hpp"
#include "deck/suggestion.hpp"

namespace gxrod::test {

TEST_CASE("Histories have names that a results file can hold", "[deck]") {
    CHECK(faults_of(body_deck + R"([[history]]
name = "a b"
at = "top"
quantities = "position")") ==
          R"(x.toml:9:8: history[0].name: expected a name of letters, digits, _ and -, found "a b")");
    CHECK(faults_of(body_deck + R"([[history]]
name = "time"
at = "top"
quantities = "position")") ==
          R"(x.toml:9:8: history[0].name: "time" is taken by the times of all histories)");
    CHECK(faults_of(body_deck + R"([[history]]
name = "a"
at = "top"
quantities = "position"
[[history]]
name = "a"
at = "top"
quantities = "position")") == R"(x.toml:13:8: history[1].name: an earlier history is named "a" too)");
    CHECK(faults_of(body_deck + R"([[history]]
name = ""
at = "top"
quantities = "position")") ==
          R"(x.toml:9:8: history[0].name: expected a name of letters, digits, _ and -, found "")");
}

TEST_CASE("Quantities are those that the point has", "[deck]") {
    CHECK(faults_of(body_deck + R"([[history]]
name = "a"
at = "top"
quantities = ["position", "force", "reaction_force", "position"])") ==
          R"(x.toml:11:27: history[0].quantities[1]: "force": only points of rods have it; this one is a body
x.toml:11:36: history[0].quantities[2]: "reaction_force": only a supported point has it; no [[support]] is at this one
x.toml:11:54: history[0].quantities[3]: "position" is listed twice)");
    CHECK(
        faults_of(rod_deck + R"([[history]]
name = "a"
at = "r.end"
quantities = ["centre_of_mass"])") ==
        R"(x.toml:16:15: history[0].quantities[0]: "centre_of_mass": only bodies have it; this is a point of a rod)");
    CHECK(
        faults_of(rod_deck + R"([[history]]
name = "a"
at = "r.end"
quantities = ["reaction_force", "reaction_moment"])") ==
        R"(x.toml:16:15: history[0].quantities[0]: "reaction_force": only a supported point has it; no [[support]] is at this one
x.toml:16:33: history[0].quantities[1]: "reaction_moment": only a supported point has it; no [[support]] is at this one)");
}

TEST_CASE("Every quantity has its word, and points have those that they can", "[deck]") {
    const std::string supports = "[[support]]\nat = \"r.end\"\nfix = \"x\"\n";
    std::vector<std::string> of_rods = words_of(quantity_choices);
    std::erase(of_rods, "centre_of_mass");
    const Problem problem =
        read(rod_deck + supports + "[[history]]\nname = \"all\"\nat = \"r.end\"\nquantities = [" +
             quoted_list(of_rods) + "]\n");
    CHECK(problem.output.histories[0].quantities.size() == 17);
    CHECK(problem.output.histories[0].quantities.back() == Quantity::reaction_moment);
    const Problem body =
        read(body_deck + "[[history]]\nname = \"a\"\nat = \"top\"\nquantities = \"centre_of_mass\"\n");
    CHECK(body.output.histories[0].quantities == std::vector{Quantity::centre_of_mass});
}

}  // namespace gxrod::test
