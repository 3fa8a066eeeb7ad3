
#include "deck/decks.hpp"
#include "deck/schema/choices.hpp"
#include "deck/schema/suggestion.hpp"
#include "tools/catch.hpp"
#include "watch/quantities.hpp"
#include "watch/quantity_tables.hpp"

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
          R"(x.toml:9:8: history[0].name: "time" is taken: a column of all histories has it)");
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

TEST_CASE("Quantities of motion can be relative to a point", "[deck]") {
    const auto history = [](const std::string& reference, const std::string& quantities) {
        return rod_deck +
               "[body.b]\nmass = 1\nat = \"r.end\"\nrotation_vector = [1, 0, 0]\n[[history]]\nname = "
               "\"a\"\nat = \"r@0.5\"\nrelative_to = \"" +
               reference + "\"\nquantities = " + quantities + "\n";
    };
    const HistoryRequest to_rod =
        read(
            history("r.start", R"(["position", "displacement", "velocity", "acceleration", "angular_velocity",
"rotation_vector", "quaternion", "orientation"])"))
            .output.histories[0];
    CHECK(to_rod.relative_to == "r.start");
    CHECK(to_rod.relative_node == 0);
    CHECK(to_rod.relative_axes.isApprox(Quat::Identity()));
    CHECK(to_rod.quantities.size() == 8);
    const HistoryRequest to_body = read(history("b", "\"position\"")).output.histories[0];
    CHECK(to_body.relative_node == 10);
    CHECK((to_body.relative_axes * Vec3::UnitX()).isApprox(Vec3::UnitX()));
    CHECK((to_body.relative_axes * Vec3::UnitY()).isApprox(Vec3(0, std::cos(1.0), std::sin(1.0))));
    CHECK(
        faults_of(history("r.start", R"(["position", "force_spatial", "angular_velocity_material"])")) ==
        R"(x.toml:21:27: history[0].quantities[1]: "force_spatial": cannot be relative to a point; write another history for it
x.toml:21:44: history[0].quantities[2]: "angular_velocity_material": cannot be relative to a point; write another history for it)");
    CHECK(faults_of(history("s.start", "\"position\"")) ==
          R"(x.toml:20:15: history[0].relative_to: no point "s.start"; did you mean "r.start"?)");
}

TEST_CASE("A moved support has reactions", "[deck]") {
    CHECK(faults_of(rod_deck +
                    "[[support]]\nat = \"r.end\"\nmove = { x = \"t\" }\n[[history]]\nname = \"a\"\nat = "
                    "\"r.end\"\nquantities = [\"reaction_force\", \"reaction_moment\"]\n")
              .empty());
}

TEST_CASE("Every quantity has its word, and points have those that they can", "[deck]") {
    const std::string supports = "[[support]]\nat = \"r.end\"\nfix = \"x\"\n";
    std::vector<std::string> of_rods = list_quantity_words();
    std::erase(of_rods, "centre_of_mass");
    std::erase_if(of_rods, is_stress_quantity);  // those need a shape
    // After these come the quantities of springs and joints.
    of_rods.erase(std::ranges::find(of_rods, "reaction_moment") + 1, of_rods.end());
    const Problem problem =
        read(rod_deck + supports + "[[history]]\nname = \"all\"\nat = \"r.end\"\nquantities = [" +
             quoted_list(of_rods) + "]\n");
    CHECK(of_rods.size() > 17);
    CHECK(problem.output.histories[0].quantities == of_rods);
    const Problem body =
        read(body_deck + "[[history]]\nname = \"a\"\nat = \"top\"\nquantities = \"centre_of_mass\"\n");
    CHECK(body.output.histories[0].quantities == std::vector<std::string>{"centre_of_mass"});
}

}  // namespace gxrod::test
