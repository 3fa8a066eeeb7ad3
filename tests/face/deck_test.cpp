#include "face/deck.hpp"

#include "deck/decks.hpp"
#include "machine/file_error.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

const std::string bob = R"([parameters]
m = 2.0
[body.bob]
mass = "m"
inertia = [1, 1, 1]
at = [0, 0, 0]
[[load]]
at = "bob"
force = [0, 0, 1]
[analysis]
kind = "dynamic"
end_time = 1.0
steps = 10
)";

}  // namespace

TEST_CASE("a deck is built with the values that were set last", "[face]") {
    Deck deck = Deck::from_text(bob);
    deck.set("parameters.m", 3.5).set("analysis.steps", 7).set("load[0].force", {1.0, 0.5, -2.0});
    deck.set("analysis.steps", 8).set("title", "falls").set("analysis.start", "project");
    const Problem problem = deck.build();
    CHECK(problem.model.bodies[0].mass == 3.5);
    CHECK(std::get<DynamicSettings>(problem.analysis()).steps == 8);
    CHECK(problem.model.loads[0].force[2](0.0) == -2.0);
    CHECK(problem.record.title == "falls");
    CHECK(deck.overrides().size() == 5);
    CHECK(Deck::from_text(bob).build().model.bodies[0].mass == 2.0);
}

TEST_CASE("the points of a rod can be computed", "[face]") {
    Deck deck = Deck::from_text(replaced(rod_deck, "line = { from = [0, 0, 0], to = [10, 0, 0] }", ""));
    deck.set("rod.r.polyline", {Vec3(0, 0, 0), Vec3(0.1, 0, 0), Vec3(0.1, 0, 1.0 / 3.0)});
    CHECK(deck.build().model.nodes.back().position == Vec3(0.1, 0, 1.0 / 3.0));
}

TEST_CASE("errors of a deck have their line and column", "[face]") {
    std::vector<DeckFault> faults;
    try {
        Deck::from_text(replaced(bob, "at = \"bob\"", "at = \"bop\""), "some.toml").build();
    } catch (const DeckError& error) {
        faults = error.faults;
    }
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].file == "some.toml");
    CHECK(faults[0].line == 8);
    CHECK(faults[0].column == 6);
    CHECK_THROWS_WITH(Deck::from_text(bob).set("parameters.n", 1.0).build(),
                      Contains("the deck has no parameter \"n\""));
    CHECK_THROWS_WITH(Deck::from_text(bob).set("body.bob.mass", -1.0).build(), Contains("--set"));
    CHECK_THROWS_AS(Deck::from_text("a = "), DeckError);
    CHECK_THROWS_AS(Deck("nowhere.toml"), FileError);
}

TEST_CASE("a problem is checked as gxrod check does", "[face]") {
    CHECK(check(Deck::from_text(bob).build()).empty());
    const std::string loose = static_rod_deck + "[[load]]\nat = \"r.end\"\nforce = [0, 0, 1]\n";
    const std::vector<std::string> found = check(Deck::from_text(loose).build());
    REQUIRE(!found.empty());
    CHECK_THAT(found.front(), Catch::StartsWith("error: "));
}

}  // namespace gxrod::test
