#include <fstream>
#include <sstream>

#include "check/model_examination.hpp"
#include "check/motions/free_parts.hpp"
#include "deck/decks.hpp"
#include "tools/catch.hpp"
#include "tools/mechanism_decks.hpp"

namespace gxrod::test {
namespace {

// Without histories.
std::string deck_of(const std::string& name) {
    const std::ifstream file(tools::find_mechanism_deck(name));
    std::ostringstream text;
    text << file.rdbuf();
    return text.str().substr(0, text.str().find("[[history]]"));
}

std::vector<FreeMechanism> find_free(const std::string& deck) {
    return find_free_mechanisms(read(deck).model);
}

FreeMechanism only(const std::vector<FreeMechanism>& found) {
    REQUIRE(found.size() == 1);
    return found.front();
}

}  // namespace

TEST_CASE("Structures on joints that can stand have no free motion", "[check][joint]") {
    for (const char* name :
         {"gerber_beam", "three_hinged_arch", "hinged_frame", "sprung_hinge", "askew_four_bar"}) {
        INFO(name);
        const Problem problem = read(deck_of(name));
        CHECK(find_free_mechanisms(problem.model).empty());
        CHECK(find_free_parts(problem.model).empty());
        CHECK_FALSE(has_error(examine_model(problem.model, problem.analysis())));
    }
}

TEST_CASE("What no joint, support, spring or motor holds is free", "[check][joint]") {
    const std::string roller = "[[support]]\nat = \"second.end\"\nfix = \"y\"\n";
    const FreeMechanism beam = only(find_free(replaced(deck_of("gerber_beam"), roller, "")));
    CHECK(beam.motions == 1);
    CHECK(beam.joints == std::vector{0});
    const std::string loose = replaced(deck_of("sprung_hinge"), "spring = { stiffness = \"k\" }", "");
    CHECK(only(find_free(loose)).motions == 1);
    const std::string moved = replaced(deck_of("sprung_hinge"), "spring = { stiffness = \"k\" }", "move = 0");
    CHECK(find_free(moved).empty());
    const auto with_bushing = [&](const std::string& axis) {
        return loose + "[bushing.b]\nbetween = [\"first.end\", \"second.start\"]\nstiffness = { " + axis +
               " = 2 }\n";
    };
    CHECK(find_free(with_bushing("rz")).empty());
    CHECK(only(find_free(with_bushing("rx"))).motions == 1);
    const FreeMechanism chain = only(find_free(deck_of("rubber_chain")));
    CHECK(chain.motions == 9);
    CHECK(chain.joints == std::vector{0, 1, 2});
    CHECK(chain.whole.rods == std::vector{0, 1, 2});
    CHECK(only(find_free(deck_of("bricard"))).motions == 1);
    CHECK(count_free_motions(read(deck_of("bricard")).model) == 1);
    CHECK(count_free_motions(read(deck_of("rubber_chain")).model) == 9);
}

TEST_CASE("A gear leaves one motion of two joints", "[check][joint][gear]") {
    const std::string bodies =
        "[body.a]\nmass = 1\ninertia = [1, 1, 1]\n[body.b]\nmass = 1\ninertia = [1, 1, 1]\nat = [1, 0, 0]\n"
        "[analysis]\nkind = \"static\"\n"
        "[joint.p]\ntype = \"hinge\"\nbetween = [\"ground\", \"a\"]\naxis = [0, 0, 1]\n"
        "[joint.q]\ntype = \"slider\"\nbetween = [\"ground\", \"b\"]\naxis = [0, 1, 1]\n";
    const std::string gear = "[gear.g]\njoints = [\"p\", \"q\"]\nratio = 3\n";
    CHECK(find_free(bodies).size() == 2);
    const FreeMechanism geared = only(find_free(bodies + gear));
    CHECK(geared.motions == 1);
    CHECK(geared.joints == std::vector{0, 1});
    CHECK(
        find_free(replaced(bodies, "axis = [0, 0, 1]", "axis = [0, 0, 1]\nspring = { stiffness = 1 }") + gear)
            .empty());
}

TEST_CASE("A free joint holds what its motors and springs do", "[check][joint]") {
    const std::string body = "[body.a]\nmass = 1\ninertia = [1, 1, 1]\n[analysis]\nkind = \"static\"\n";
    const std::string free = "[joint.p]\ntype = \"free\"\nbetween = [\"ground\", \"a\"]\naxis = [0, 0, 1]\n";
    CHECK(only(find_free(body + free + "drive = { turn = 1 }\n")).motions == 6);
    CHECK(only(find_free(body + free + "move = { turn = 0 }\nspring = { slide = { stiffness = 1 } }\n"))
              .motions == 4);
}

TEST_CASE("Free joints of statics are a warning that names them", "[check][joint]") {
    const Problem loose =
        read(replaced(deck_of("sprung_hinge"), "spring = { stiffness = \"k\" }", "spring = { damping = 1 }"));
    const std::vector<Finding> findings = examine_model(loose.model, loose.analysis());
    CHECK_FALSE(has_error(findings));
    const auto is_named = [](const Finding& finding) {
        return finding.message ==
               "the part with rods first and second has 1 free motion at t = 0: joint hinge can move; a "
               "static "
               "analysis needs supports, springs or motors that prevent it, or loads that hold it";
    };
    CHECK(std::any_of(findings.begin(), findings.end(), is_named));
}

}  // namespace gxrod::test
