
#include "deck/decks.hpp"
#include "deck/schema/choices.hpp"
#include "deck/schema/suggestion.hpp"
#include "tools/catch.hpp"
#include "watch/quantities.hpp"

namespace gxrod::test {

TEST_CASE("Words are among the choices", "[deck]") {
    CHECK(
        faults_of(replaced(rod_deck, R"(element = "simo")", R"(element = "simmo")")) ==
        R"(x.toml:8:11: rod.r.element: expected one of "objective", "simo", found the text "simmo"; did you mean "simo"?)");
    CHECK(faults_of(replaced(rod_deck, R"(element = "simo")", "element = 1")) ==
          R"(x.toml:8:11: rod.r.element: expected one of "objective", "simo", found 1)");
    CHECK(
        faults_of(replaced(body_deck, R"("dynamic")", R"("statics")")) ==
        R"(x.toml:5:8: analysis.kind: expected one of "dynamic", "static", "quasi-static", "path", "steady", "modes", "buckling", "eigenvalues", "response", found the text "statics"; did you mean "static"?)");
    CHECK(faults_of(body_deck + R"(integrator = "sdirk4")") ==
          "x.toml:8:14: analysis.integrator: expected one of " + quoted_list(words_of(scheme_choices)) +
              R"(, found the text "sdirk4"; did you mean "sdirk-4"?)");
    CHECK(faults_of(body_deck + R"(integrator = "euler")") ==
          "x.toml:8:14: analysis.integrator: expected one of " + quoted_list(words_of(scheme_choices)) +
              R"(, found the text "euler")");
    CHECK(
        faults_of(body_deck + R"(newton = { tangent = "precise" })") ==
        R"(x.toml:8:22: analysis.newton.tangent: expected one of "automatic", "mixed", "consistent", "kept", "paper", "difference", found the text "precise")");
    CHECK(
        faults_of(body_deck + R"(linear_solver = "mumps")") ==
        R"(x.toml:8:17: analysis.linear_solver: expected one of "auto", "chains", "klu", "umfpack", found the text "mumps")");
    CHECK(
        faults_of(body_deck + R"([[load]]
at = "top"
force = [0, 0, 1]
frame = "boddy")") ==
        R"(x.toml:11:9: load[0].frame: expected one of "spatial", "follower", "body", found the text "boddy"; did you mean "body"?)");
}

TEST_CASE("Lists of words have one at least and valid ones only", "[deck]") {
    CHECK(
        faults_of(body_deck + R"([[support]]
at = "top"
fix = "rxx")") ==
        R"(x.toml:10:7: support[0].fix: expected one of "x", "y", "z", "rx", "ry", "rz", "all", "position", "rotation", found the text "rxx"; did you mean "rx"?)");
    CHECK(
        faults_of(body_deck + R"([[support]]
at = "top"
fix = [])") ==
        R"(x.toml:10:7: support[0].fix: expected one or a list of "x", "y", "z", "rx", "ry", "rz", "all", "position", "rotation", found an empty array)");
    CHECK(
        faults_of(body_deck + R"([[support]]
at = "top"
fix = ["x", 2])") ==
        R"(x.toml:10:13: support[0].fix[1]: expected one of "x", "y", "z", "rx", "ry", "rz", "all", "position", "rotation", found 2)");
    CHECK(faults_of(body_deck + R"([[history]]
name = "h"
at = "top"
quantities = ["positon", "swiftness"])") == "x.toml:11:15: history[0].quantities[0]: expected one of " +
                                                quoted_list(list_quantity_words("body")) +
                                                R"(, found the text "positon"; did you mean "position"?
x.toml:11:26: history[0].quantities[1]: expected one of )" +
                                                quoted_list(list_quantity_words("body")) +
                                                R"(, found the text "swiftness")");
}

TEST_CASE("Text is text", "[deck]") {
    CHECK(faults_of(replaced(rod_deck, R"(section = "s")", "section = 3")) ==
          "x.toml:5:11: rod.r.section: expected the name of a section, found 3");
    CHECK(faults_of(R"(title = 1
units = ["m"]
[body.top]
mass = 1.0
inertia = [1, 1, 1]
[analysis]
kind = "dynamic"
end_time = 1.0
steps = 10
)") ==
          R"(x.toml:1:9: title: expected text, found 1
x.toml:2:9: units: expected text, found an array of 1)");
    CHECK(
        faults_of(body_deck + R"([[load]]
at = 3
force = [0, 0, 0])") ==
        R"(x.toml:9:6: load[0].at: expected a point, such as "rod.end", "rod@0.25" or "body", with * for any letters, or an array of points, found 3)");
    CHECK(faults_of(body_deck + R"([[history]]
name = 3
at = "top"
quantities = "position")") == "x.toml:9:8: history[0].name: expected text, found 3");
}

}  // namespace gxrod::test
