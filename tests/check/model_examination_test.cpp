#include "check/model_examination.hpp"

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

std::vector<std::string> examine(const std::string& deck) {
    const Problem problem = read(deck);
    std::vector<std::string> lines;
    for (const Finding& finding : examine_model(problem.model, problem.analysis()))
        lines.push_back(describe(finding));
    return lines;
}

using Lines = std::vector<std::string>;

const std::string load = "[[load]]\nat = \"r.end\"\nforce = [0, 0, 1]\n";
const std::string clamp = "[[support]]\nat = \"r.start\"\nfix = \"all\"\n";

}  // namespace

TEST_CASE("A part that can drift in a static analysis is an error that names the motion", "[check]") {
    CHECK(examine(static_rod_deck + load + clamp).empty());
    CHECK(examine(static_rod_deck + load) ==
          Lines{"error: rod r can move and turn in every direction; a static analysis needs supports that "
                "prevent it"});
    CHECK(examine(static_rod_deck + load + "[[support]]\nat = \"r.start\"\nfix = \"position\"\n" +
                  "[[support]]\nat = \"r@0.5\"\nfix = [\"y\", \"z\"]\n") ==
          Lines{"error: rod r can twist about its axis; a static analysis needs supports that prevent it"});
    CHECK(examine(static_rod_deck + load +
                  "[[support]]\nat = \"r.start\"\nfix = [\"y\", \"z\", \"rotation\"]\n") ==
          Lines{"error: rod r can move along x; a static analysis needs supports that prevent it"});
    CHECK(has_error({{Severity::warning, ""}, {Severity::error, ""}}));
    CHECK_FALSE(has_error({{Severity::warning, ""}, {Severity::note, ""}}));
}

TEST_CASE("Round-off that hides soft parts is warned of where stiffnesses are solved with", "[check]") {
    const auto stiffened = [](const std::string& deck) {
        return replaced(deck, "EA = 1e4", "EA = 1e18") + load + clamp;
    };
    const Lines warning{
        "warning: rod r is too stiff compared with what bends it for numbers of 16 digits: round-off of its "
        "forces "
        "is about 2.2e+03, a force that bends it about 6; expected EA, GAy and GAz up to 8e-06 of what they "
        "are, or longer elements"};
    CHECK(examine(stiffened(static_rod_deck)) == warning);
    CHECK(examine(stiffened(rod_deck)) == warning);
    CHECK(examine(stiffened(rod_deck + "integrator = \"runge-kutta-4\"\n")).empty());
}

TEST_CASE("A part can drift in a dynamic analysis", "[check]") { CHECK(examine(rod_deck + load).empty()); }

TEST_CASE("Each part is examined, and parts are listed", "[check]") {
    const std::string other =
        "[rod.q]\nsection = \"s\"\nline = { from = [0, 5, 0], to = [5, 5, 0] }\nelements = 4\nelement = "
        "\"simo\"\n[[support]]\nat = \"q.end\"\nfix = [\"position\", \"rx\", \"ry\"]\n";
    CHECK(
        examine(static_rod_deck + load + clamp + other) ==
        Lines{
            "error: rod q can turn about an axis along z through (5, 5, 0); a static analysis needs supports "
            "that prevent it",
            "note: nothing connects these 2 parts: rod r; rod q"});
}

TEST_CASE("Suspicious models are warned of", "[check]") {
    CHECK(examine(static_rod_deck + clamp) ==
          Lines{"warning: nothing loads the model: it has no load, gravity or move"});
    CHECK(examine(rod_deck + clamp) ==
          Lines{"warning: nothing sets the model in motion: it has no load, gravity, move or velocity"});
    CHECK(examine(rod_deck + "[[initial]]\non = \"r\"\nvelocity = [0, 0, 1]\n").empty());
    CHECK(examine(rod_deck + "[[support]]\nat = \"r.start\"\nmove = { x = \"t^2\" }\n").empty());
    CHECK(examine(rod_deck + "[[load]]\non = \"r\"\nforce_per_length = [0, 0, 1]\n").empty());
    CHECK(examine("gravity = [0, 0, -1]\n" + rod_deck).empty());
    CHECK(
        examine(rod_deck + load + "[[load]]\nat = \"r.start\"\nforce = [0, 0, 1]\n" + clamp) ==
        Lines{"warning: load[1] acts at r.start, where a support holds all that it drives; only the reaction "
              "feels it"});
    CHECK(examine(rod_deck + load + "[[load]]\nat = \"r.start\"\nmoment = [0, 0, 1]\n" +
                  "[[support]]\nat = \"r.start\"\nfix = \"position\"\n")
              .empty());
    const Problem massless = read("gravity = [0, 0, -1]\n[body.b]\n[analysis]\nkind = \"static\"\n");
    const std::vector<Finding> findings = examine_model(massless.model, massless.analysis());
    REQUIRE(findings.size() == 2);
    CHECK(describe(findings[1]) == "warning: gravity acts on nothing: the model has no mass");
}

TEST_CASE("Ends at one place that nothing connects are warned of", "[check]") {
    CHECK(examine(rod_deck + load + "[body.b]\nmass = 1\ninertia = [1, 1, 1]\nat = [10, 0, 0]\n") ==
          Lines{"warning: r.end and b are at one place and not connected; to fix body.b there write at = "
                "\"r.end\"",
                "note: nothing connects these 2 parts: rod r; body b"});
}

}  // namespace gxrod::test
