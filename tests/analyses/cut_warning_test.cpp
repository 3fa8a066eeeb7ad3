#include "analyses/cut_warning.hpp"

#include "deck/decks.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

std::string advise(const std::string& deck, bool is_unstable = false) {
    const Problem problem = test::read(deck);
    return advise_on_cuts(problem.model, problem.analysis(), is_unstable);
}

}  // namespace

TEST_CASE("A few cuts are not reported, more are", "[analyses]") {
    CHECK_FALSE(are_worth_telling({100, 0, 0, 0}));
    CHECK_FALSE(are_worth_telling({100, 5, 5, 0}));
    CHECK(are_worth_telling({100, 5, 6, 0}));
    CHECK(count_cuts({1000, 412, 903, 0}) == "412 of 1000 steps were cut, 903 times in all");
}

TEST_CASE("Steps chosen by their error are cut for it as a matter of course", "[analyses]") {
    CHECK_FALSE(are_worth_telling({100, 20, 20, 20}));
    CHECK(are_worth_telling({100, 21, 21, 21}));
    CHECK_FALSE(are_worth_telling({10, 4, 4, 4}));
    CHECK(are_worth_telling({100, 26, 26, 20}));
}

TEST_CASE("What is said of cuts is what the model and its settings make of them", "[analyses]") {
    const std::string mixed =
        ". Try newton.tangent = \"mixed\", which converges in longer steps, or a smaller time_step";
    const std::string newmark = ", or generalized-alpha, which damps what is too fast for the steps.";
    CHECK(advise(test::rod_deck) == mixed + newmark);
    CHECK(advise(test::rod_deck + "integrator = \"generalized-alpha\"\n") == mixed + ".");
    CHECK(advise(test::rod_deck + "integrator = \"generalized-alpha\"\nnewton.tangent = \"mixed\"\n") ==
          ". Try a smaller time_step.");
    CHECK(advise(test::rod_deck + "integrator = \"energy-momentum\"\n") ==
          mixed + ", or gauss-4 where it turns almost without vibrating.");
    CHECK(advise(test::rod_deck + "integrator = \"sdirk-4\"\nadaptive = {}\n") ==
          ". Try newton.tangent = \"mixed\", which converges in longer steps, or a smaller max_step.");
    CHECK(advise(test::replaced(test::rod_deck, "EIz = 700", "EIz = 7e4")) ==
          "; rod r is 1.4e+02 times as stiff in bending about z as in twist" + mixed + newmark);
    CHECK(advise(test::replaced(test::rod_deck, "EIz = 700", "EIz = 7e6")) ==
          "; rod r is 1.4e+04 times as stiff in bending about z as in twist. Try a smaller time_step" +
              newmark);
    CHECK(advise(test::body_deck) == ". Try a smaller time_step" + newmark);
    CHECK(advise(test::static_rod_deck) == ". Try more steps.");
    const auto touching = [](const std::string& deck) {
        return test::replaced(deck, "[rod.r]", "radius = 0.1\n[contact]\n[rod.r]");
    };
    CHECK(advise(touching(test::static_rod_deck)) == ". Try more steps, or a thicker contact.skin.");
    CHECK(advise(touching(test::static_rod_deck), true) == ". Try more steps.");
    CHECK(advise(touching(test::rod_deck)) ==
          mixed + ", or gamma = 0.6 and beta = 0.3, which damp what is too fast for the steps.");
    CHECK(advise(test::static_rod_deck + "newton.tangent = \"consistent\"\n") ==
          ". Try more steps, or newton.tangent = \"mixed\", which converges in larger ones.");
}
