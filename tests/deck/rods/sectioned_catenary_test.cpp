#include <algorithm>
#include <cmath>

#include "deck/decks.hpp"
#include "tools/static_run.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

// Lines 1 to 22; text that is added begins in line 23.
const std::string line_deck = R"deck(plane = "xz"
gravity = [0, 0, -9.80665]
fluid = { density = 1025, surface = 0 }
seabed = { z = -100.07, stiffness = 1e6 }
[section.chain]
stiffness = { EA = 5e8, GAy = 2e8, GAz = 2e8, GJ = 1e4, EIy = 1e4, EIz = 1e4 }
inertia = { rhoA = 120, rhoIy = 0.2, rhoIz = 0.2 }
fluid = { outer_diameter = 0.14 }
[section.rope]
stiffness = { EA = 2e7, GAy = 1e7, GAz = 1e7, GJ = 2e3, EIy = 2e3, EIz = 2e3 }
inertia = { rhoA = 20, rhoIy = 0.02, rhoIz = 0.02 }
fluid = { outer_diameter = 0.15 }
[rod.line]
sections = [[0, "chain"], [0.5, "chain"], [0.5, "rope"], [1, "rope"]]
catenary = { from = [0, 0, -100], to = [350, 0, -5], length = 385, bed = true }
elements = 78
order = 2
[[support]]
at = "line.start"
fix = "position"
[[support]]
at = "line.end"
fix = "position"
)deck";
const std::string one_step = "[analysis]\nkind = \"static\"\nsteps = 1\n";

Vec3 place_at(const Model& model, double fraction) {
    const Rod& rod = model.rods[0];
    for (std::size_t i = 0; i < rod.arc_length.size(); ++i)
        if (std::abs(rod.arc_length[i] - fraction * rod.length) < 1e-9 * rod.length)
            return model.nodes[static_cast<std::size_t>(rod.element_nodes[i])].position;
    throw std::logic_error("no node");
}

}  // namespace

TEST_CASE("A line of two sections starts stretched, with its length free of stress", "[deck]") {
    const Model model = read(line_deck + one_step).model;
    const Rod& rod = model.rods[0];
    CHECK(rod.length == 385);
    CHECK(rod.start_stretch == 1);
    REQUIRE(rod.rest_positions.size() == rod.element_nodes.size());
    CHECK((rod.rest_positions.back() - rod.rest_positions.front()).norm() == Approx(385).epsilon(1e-14));
    const double rope = (place_at(model, 1.0) - place_at(model, 1.0 - 1.0 / 78.0)).norm();
    CHECK(rope > 385.0 / 78.0);
    CHECK(rope < 385.0 / 78.0 * (1.0 + 1e-3));
    CHECK(place_at(model, 10.0 / 78.0).z() == Approx(-100.0073).margin(1e-4));
}

TEST_CASE("Lines of sections, with buoys and weights, stand in one static step", "[deck]") {
    const std::string clump = "[body.clump]\nat = \"line@0.7\"\nmass = 3000\nfluid = { volume = 0.4 }\n";
    const std::string buoy = "[body.buoy]\nat = \"line@0.7\"\nmass = 1000\nfluid = { volume = 5 }\n";
    const std::string force = "[[load]]\nat = \"line@0.7\"\nforce = [0, 0, 2e4]\n";
    for (const std::string& more : {std::string(), clump, buoy, force}) {
        CAPTURE(more);
        const Problem problem = read(line_deck + more + one_step);
        const tools::StaticRun run =
            tools::run_static(problem.model, std::get<StaticSettings>(problem.analysis()));
        CHECK(run.steps == 1);
        CHECK(run.iterations <= 7);
    }
}

TEST_CASE("A line of one section hangs as one of two equal ones", "[deck]") {
    const std::string sections =
        "sections = [[0, \"chain\"], [0.5, \"chain\"], [0.5, \"rope\"], [1, \"rope\"]]";
    const std::string one = replaced(line_deck, sections, "section = \"rope\"") + one_step;
    const std::string two =
        replaced(line_deck, sections, "sections = [[0, \"rope\"], [1, \"rope\"]]") + one_step;
    const Problem problem = read(one);
    const Model equal = read(two).model;
    REQUIRE(problem.model.nodes.size() == equal.nodes.size());
    for (std::size_t i = 0; i < equal.nodes.size(); ++i)
        CHECK(problem.model.nodes[i].position == equal.nodes[i].position);
    CHECK(problem.model.rods[0].start_stretch == 1);
    const tools::StaticRun run =
        tools::run_static(problem.model, std::get<StaticSettings>(problem.analysis()));
    CHECK(run.steps == 1);
    CHECK(run.iterations <= 5);
}

TEST_CASE("Without weight along -z, or with a rest shape, a line of one section keeps its length", "[deck]") {
    const std::string sections =
        "sections = [[0, \"chain\"], [0.5, \"chain\"], [0.5, \"rope\"], [1, \"rope\"]]";
    const std::string one = replaced(line_deck, sections, "section = \"rope\"") + one_step;
    const std::string rest = "rest = { line = { from = [0, 0, 0], to = [385, 0, 0] } }\nelements = 78";
    for (const std::string& deck :
         {replaced(replaced(one, "gravity = [0, 0, -9.80665]", ""), ", surface = 0", ""),
          replaced(one, "rhoA = 20", "rhoA = 2"),
          replaced(one, "elements = 78", rest)}) {
        CAPTURE(deck);
        const Model model = read(deck).model;
        double along = 0.0;
        for (int i = 1; i <= 78; ++i)
            along += (place_at(model, i / 78.0) - place_at(model, (i - 1) / 78.0)).norm();
        CHECK(along < 385);
    }
}

TEST_CASE("A line straight up of the length of its distance stands straight", "[deck]") {
    const std::string one =
        replaced(line_deck,
                 "sections = [[0, \"chain\"], [0.5, \"chain\"], [0.5, \"rope\"], [1, \"rope\"]]",
                 "section = \"rope\"") +
        one_step;
    const std::string upright =
        replaced(one, "to = [350, 0, -5], length = 385, bed = true", "to = [0, 0, -5], length = 95");
    const Model model = read(upright).model;
    CHECK((place_at(model, 0.5) - Vec3(0, 0, -52.5)).norm() < 1e-12);
    // Without a section there is its fault alone.
    CHECK_THAT(faults_of(replaced(one, "section = \"rope\"", "section = \"robe\"")), Contains("robe"));
}

TEST_CASE("A line hangs by the gravity of the combination that acts", "[deck]") {
    const std::string twice = replaced(line_deck, "-9.80665", "-19.6133") + one_step;
    const std::string factors = "[combination.twice]\nfactors = { gravity = 2 }\n";
    const Model wanted = read(twice).model;
    const Model found = read(line_deck + factors + one_step).model;
    for (std::size_t i = 0; i < wanted.nodes.size(); ++i)
        CHECK((found.nodes[i].position - wanted.nodes[i].position).norm() < 1e-9);
    const Model once = read(line_deck + one_step).model;
    CHECK((found.nodes[100].position - once.nodes[100].position).norm() > 1e-3);
}

TEST_CASE("Without gravity, and beyond the surface, a line of sections is refused", "[deck]") {
    CHECK_THAT(faults_of(replaced(line_deck, "gravity = [0, 0, -9.80665]", "") + one_step),
               Contains("x.toml:15") && Contains("rod.line.catenary") && Contains("gravity"));
    CHECK_THAT(faults_of(replaced(line_deck, "length = 385", "length = 460") + one_step),
               Contains("x.toml:15") && Contains("rod.line.catenary.length") && Contains("460"));
    CHECK_THAT(faults_of(replaced(line_deck, "rhoA = 20", "rhoA = 2") + one_step),
               Contains("rod.line.catenary.length") && Contains("float on the surface"));
}

}  // namespace gxrod::test
