#include "model/settings/newton_choice.hpp"

#include "deck/decks.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

std::string make_deck(const std::string& EIz, const std::string& analysis) {
    return R"([section.s]
stiffness = { EA = 300.0, GAy = 100.0, GAz = 100.0, GJ = 8e-3, EIy = 4e-3, EIz = )" +
           EIz + R"( }
inertia = { rhoA = 0.08, rhoIy = 5e-7, rhoIz = 5e-7 }
[rod.b]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 4
[[support]]
at = "b.start"
fix = "all"
[analysis]
)" + analysis;
}

TangentChoice choose(const std::string& EIz, const std::string& analysis) {
    const Problem problem = test::read(make_deck(EIz, analysis));
    return choose_tangent(problem.model, problem.analysis());
}

double tolerance_of(const std::string& lines) {
    const std::string analysis = "kind = \"dynamic\"\nend_time = 1.0\nsteps = 10\nintegrator = \"sdirk-4\"\n";
    return choose_newton_tolerance(test::read(make_deck("4e-3", analysis + lines)).analysis());
}

const std::string dynamic = "kind = \"dynamic\"\nend_time = 1.0\nsteps = 10\n";

}  // namespace

TEST_CASE("Motions take the mixed tangent from a ratio of stiffnesses on", "[model]") {
    CHECK(choose("1.19", dynamic).tangent == TangentKind::consistent);
    const TangentChoice choice = choose("1.21", dynamic);
    CHECK(choice.tangent == TangentKind::mixed);
    REQUIRE(choice.reason);
    CHECK(choice.reason->ratio == Approx(302.5));
    CHECK(choose("4e-3", dynamic + "newton.tangent = \"automatic\"\n").tangent == TangentKind::consistent);
}

TEST_CASE("Equilibria take the mixed tangent whatever the ratio", "[model]") {
    const TangentChoice choice = choose("4e-3", "kind = \"static\"\n");
    CHECK(choice.tangent == TangentKind::mixed);
    CHECK_FALSE(choice.reason);
}

TEST_CASE("A tangent that the deck gives is taken", "[model]") {
    CHECK(choose("40", dynamic + "newton.tangent = \"consistent\"\n").tangent == TangentKind::consistent);
    CHECK_FALSE(choose("40", dynamic + "newton.tangent = \"mixed\"\n").reason);
    CHECK(choose("40", "kind = \"static\"\nnewton.tangent = \"consistent\"\n").tangent ==
          TangentKind::consistent);
}

TEST_CASE("Newton's tolerance is a hundredth of that of steps chosen by their error", "[model]") {
    CHECK(tolerance_of("") == 1e-8);
    CHECK(tolerance_of("adaptive = { tolerance = 1e-4 }\n") == 1e-8);
    CHECK(tolerance_of("adaptive = { tolerance = 1e-6 }\n") == 1e-8);
    CHECK(tolerance_of("adaptive = { tolerance = 1e-7 }\n") == Approx(1e-9));
    CHECK(tolerance_of("adaptive = { tolerance = 1e-11 }\n") == Approx(1e-13));
    CHECK(tolerance_of("adaptive = { tolerance = 1e-11 }\nnewton.tolerance = 1e-5\n") == 1e-5);
    CHECK(tolerance_of("adaptive = { tolerance = 1e-11 }\nnewton = { max_iterations = 7 }\n") ==
          Approx(1e-13));
}
