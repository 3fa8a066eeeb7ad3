
#include "batch/plans.hpp"
#include "check/static_scale.hpp"
#include "deck/decks.hpp"
#include "machine/file_error.hpp"
#include "tools/catch.hpp"

// What goes wrong with somebody's first decks and plans, and is explained in one round.

namespace gxrod::test {
namespace {

// The text with two bytes a letter.
std::string widened(const std::string& text, bool low_first) {
    std::string wide;
    for (const char letter : text) {
        if (!low_first) wide += '\0';
        wide += letter;
        if (low_first) wide += '\0';
    }
    return wide;
}

std::string why_unreadable(const std::string& text) {
    const ScratchFile file("deck.toml", text);
    try {
        read_problem(file.path());
    } catch (const FileError& error) {
        return error.what();
    } catch (const DeckError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("A deck in UTF-16 is distinguished from one that is not TOML", "[issues]") {
    const std::string hint =
        "is in UTF-16 or UTF-32, expected a deck in UTF-8 (save it with the encoding UTF-8, or convert it: "
        "iconv -f "
        "UTF-16 -t UTF-8 FILE > NEW";
    CHECK_THAT(why_unreadable("\xff\xfe" + widened(body_deck, true)), Catch::Contains(hint));
    CHECK_THAT(why_unreadable("\xfe\xff" + widened(body_deck, false)), Catch::Contains(hint));
    CHECK_THAT(why_unreadable(widened(body_deck, true)), Catch::Contains(hint));
    CHECK_THAT(why_unreadable(widened(body_deck, false)), Catch::Contains(hint));
    // A mark of UTF-8 is not one of another encoding.
    CHECK(why_unreadable("\xef\xbb\xbf" + body_deck).empty());
    CHECK(why_unreadable(body_deck).empty());
}

TEST_CASE("A modulus in another unit than the lengths shows in the static strains", "[issues]") {
    const auto described = [](const std::string& E, const std::string& rest) {
        const Problem problem = read(
            "gravity = [0, 0, -9.81]\n[section.s]\nshape = { circle = { radius = 5e-3 } }\n"
            "material = { E = " +
            E +
            ", nu = 0.5, density = 1100 }\n"
            "[rod.r]\nsection = \"s\"\nline = { from = [0, 0, 0], to = [1, 0, 0] }\nelements = 4\n"
            "order = 2\n" +
            rest);
        return describe_static_scale(problem.model, problem.analysis());
    };
    const std::string clamp = "[[support]]\nat = \"r.start\"\nfix = \"all\"\n";
    const std::string statics = "[analysis]\nkind = \"static\"\n";
    const std::string dynamics = "[analysis]\nkind = \"dynamic\"\nend_time = 1\nsteps = 100\n";
    const std::string question = "are moduli, masses and lengths in one set of units (pascals with metres)?";
    // Rubber of 5 MPa is soft, and right; 5 was meant as MPa.
    CHECK(described("5e6", clamp + statics).empty());
    CHECK(described("5e6", clamp + dynamics).empty());
    CHECK_THAT(described("5", clamp + statics),
               Catch::StartsWith("at t = 1 gravity and loads would strain rod r by "));
    CHECK_THAT(described("5", clamp + dynamics), Catch::EndsWith(question));
    // Steel in MPa, with loads in newtons; in GPa it is 1000 times worse.
    const std::string pull = "[[load]]\nat = \"r.end\"\nforce = [1e3, 0, 0]\n";
    CHECK(described("2.1e11", clamp + pull + statics).empty());
    CHECK_THAT(described("2.1e5", clamp + pull + statics), Catch::Contains("would strain rod r by 6"));
    // At the time at which the load is largest.
    const std::string pulse = "[[load]]\nat = \"r.end\"\nforce = [\"1e3*sin(pi*t)\", 0, 0]\n";
    CHECK_THAT(described("2.1e5", clamp + pulse + dynamics), Catch::StartsWith("at t = 0.5 "));
    // Unsupported models have no static answer, and unloaded ones an answer of zero.
    CHECK(described("5", dynamics).empty());
    CHECK(described("5", "[[support]]\nat = \"r.start\"\nfix = \"position\"\n" + dynamics).empty());
}

TEST_CASE("The linear static answer is that of a cantilever", "[issues]") {
    const Model model = read(static_rod_deck +
                             "[[support]]\nat = \"r.start\"\nfix = \"all\"\n"
                             "[[load]]\nat = \"r.end\"\nforce = [0, 0, 3]\n")
                            .model;
    const std::optional<StaticScale> scale = find_static_scale(model, StaticSettings{});
    REQUIRE(scale.has_value());
    // F L³/(3 EIy) + F L/GAz, of a length of 10; the curvature at the clamp F L/EIy times the radius of
    // gyration.
    CHECK(scale->displacement == Approx((3.0 * 1000.0 / 1800.0 + 30.0 / 3e4) / 10.0).epsilon(5e-3));
    CHECK(scale->strain == Approx(30.0 / 600.0 * std::sqrt(600.0 / 1e4)).epsilon(0.06));
    CHECK(scale->node == model.rods[0].nodes.back());
    CHECK(scale->time == 1.0);
}

TEST_CASE("A plan in UTF-16 is reported, and so is its table", "[issues]") {
    PlanFiles files("deck = \"deck.toml\"\ncombine = \"table\"\ntable = \"cases.csv\"\n");
    files.write("cases.csv", "\xff\xfe" + widened("parameters.EI\n1\n", true));
    CHECK_THROWS_WITH(files.read(), Catch::Contains("is in UTF-16 or UTF-32, expected a table in UTF-8"));
    files.write("plan.toml", "\xff\xfe" + widened("deck = \"deck.toml\"\n", true));
    CHECK_THROWS_WITH(files.read(), Catch::Contains("expected a plan or a deck in UTF-8"));
}

TEST_CASE("All faults of a plan come in one round", "[issues]") {
    // A misplaced key, a wrong word, no such parameter, no such key of the deck, no such history.
    const PlanFiles files(R"(deck = "deck.toml"
[vary]
"parameters.EJ" = [1.0, 2.0]
"rod.r.elemets" = [2, 4]
time_limit = 600
[collect]
tip = { history = "tipp", quantity = "position", component = "z", take = "max" }
top = { history = "tip", quantity = "position", component = "z", take = "highest" }
)");
    CHECK(files.faults() ==
          "plan.toml:5:1: vary.\"time_limit\": time_limit is a key of the top level and must come before the "
          "first "
          "[table]; here it belongs to [vary]\n"
          "plan.toml:8:73: collect.top.take: expected one of \"min\", \"max\", \"mean\", \"rms\", \"final\", "
          "\"max_abs\", found the text \"highest\"\n"
          "plan.toml:3:1: vary.\"parameters.EJ\": the deck has no parameter \"EJ\"; it has EI, load\n"
          "plan.toml:7:7: collect.tip.history: the deck has no history \"tipp\"; did you mean \"tip\"?\n"
          "plan.toml:4:1: vary.\"rod.r.elemets\": unknown key; did you mean \"elements\"?");
}

TEST_CASE("What is wrong with single cases of a faulty plan comes with the rest", "[issues]") {
    const PlanFiles files(R"(deck = "deck.toml"
time_limit = -1
[vary]
"rod.r.elements" = [2, 0, 4]
"section.s.stiffness.EA" = { uniform = { from = -1, to = 2 } }
[collect]
tip = { history = "tip", quantity = "position", component = "z", take = "max" }
)");
    const std::string faults = files.faults();
    CHECK_THAT(faults, Catch::Contains("time_limit: expected a number greater than 0"));
    CHECK_THAT(faults,
               Catch::Contains("a distribution is drawn from with combine = \"latin-hypercube\" only"));
    CHECK_THAT(faults, Catch::Contains("expected an integer from 1 to 10000000, found 0 [case 2"));
}

TEST_CASE("A faulty plan with a faulty deck reports both, and a missing deck is reported", "[issues]") {
    const std::string plan = "deck = \"deck.toml\"\nsweep = 1\n[vary]\n\"parameters.EI\" = [1.0]\n";
    const PlanFiles wrong(plan, replaced(cantilever_deck, "elements", "elemets"));
    CHECK_THAT(wrong.faults(), Catch::Contains("sweep: unknown key; did you mean \"vary\"?"));
    CHECK_THAT(wrong.faults(), Catch::Contains("elemets: unknown key; did you mean \"elements\"?"));
    const PlanFiles missing(replaced(plan, "deck.toml", "duck.toml"));
    CHECK_THAT(missing.faults(), Catch::Contains("sweep: unknown key"));
    CHECK_THAT(missing.faults(), Catch::Contains("there is no file"));
}

}  // namespace gxrod::test
