#include <fstream>
#include <sstream>

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// The decks of a page of the guide.
std::vector<std::string> decks_of(const std::string& page) {
    std::ifstream file(GXROD_SOURCE_DIR "/docs/guide/" + page);
    std::vector<std::string> decks;
    bool is_toml = false;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("```")) {
            is_toml = line == "```toml";
            if (is_toml) decks.emplace_back();
        } else if (is_toml) {
            decks.back() += line + "\n";
        }
    }
    return decks;
}

// One after the other.
std::string toml_of(const std::string& page) {
    std::string all;
    for (const std::string& deck : decks_of(page)) all += deck;
    return all;
}

const char* const one_triangle =
    "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
    "endsolid s\n";
const std::string analysis = "[analysis]\nkind = \"dynamic\"\nend_time = 1.0\nsteps = 10\n";

}  // namespace

TEST_CASE("The sections and rods of the guide are a deck", "[deck]") {
    const std::string deck = toml_of("sections.md") + toml_of("geometry.md") + analysis;
    const Problem problem = read_problem_text(deck, GXROD_SOURCE_DIR "/guide.toml");
    CHECK(problem.model.sections.size() == 21);  // with the mean of those along the wing
    REQUIRE(problem.model.rods.size() == 13);
    CHECK(problem.model.rods[0].has_varying_sections());
    CHECK(problem.model.rods[4].order == 3);
    CHECK(problem.model.rods.back().element_count() == 12);
    CHECK(problem.model.supports.size() == 1);
}

TEST_CASE("The materials of the guide are sections with laws", "[deck]") {
    const std::string rod =
        "[rod.r]\nsection = \"strand\"\nline = { from = [0, 0, 0], to = [1, 0, 0] }\nelements = 1\n";
    const Problem problem = read(toml_of("materials.md") + rod + analysis);
    REQUIRE(problem.model.sections.size() == 9);
    for (const Section& section : problem.model.sections) CHECK(section.law != nullptr);
}

TEST_CASE("The tendons and muscles of the guide are a deck", "[deck]") {
    const Model model = read(toml_of("tendons.md")).model;
    REQUIRE(model.tendons.size() == 6);
    CHECK(model.tendons[5].tension(0.5) == Approx(-1.5));  // of the chamber
    CHECK(model.tendons[3].friction->coefficient == 0.2);
    CHECK(model.tendons[4].winch->shortening(0.5) == 1e-3);
    CHECK(model.tendons[1].to == Approx(0.375));
    CHECK(model.actuations.size() == 2);
    CHECK(model.distributed_loads.at(0).field);
    CHECK(model.sections.at(0).expansion == 1.2e-5);
}

TEST_CASE("The riser and the mooring of the guide are decks", "[deck]") {
    const std::vector<std::string> decks = decks_of("water.md");
    REQUIRE(decks.size() == 2);
    const Problem riser = read(decks[0]);
    CHECK(riser.model.sections.at(0).fluid->diameter == 0.5);
    CHECK(riser.stages.at(1).actions.surroundings.water->waves.size() == 200);
    CHECK(riser.model.surroundings.air);
    const Problem mooring = read(decks[1]);
    // The anchor is as high as the chain lies next to it.
    CHECK(mooring.model.nodes.at(0).position.z() == Approx(-99.954));
    CHECK(mooring.model.nodes.at(20).position.z() == Approx(-99.954).margin(1e-3));
    CHECK(mooring.model.surroundings.seabed->friction_stiffness == 3e5);
}

TEST_CASE("The portal of the guide has two combinations on supports that yield", "[deck]") {
    const std::string deck = decks_of("frames.md").back();
    const Problem snow = read(deck);
    REQUIRE(snow.model.bushings.size() == 2);
    CHECK(snow.model.bushings[1].name == "support[0] at right.start");
    CHECK(snow.model.distributed_loads.size() == 2);
    CHECK(snow.model.gravity(1.0).z() == Approx(-1.35 * 9.81));
    CHECK(read(deck, {"apply=ULS_wind"}).model.distributed_loads.size() == 1);
}

TEST_CASE("The mechanisms of the guide are decks", "[deck][joint]") {
    const std::vector<std::string> decks = decks_of("mechanisms.md");
    REQUIRE(decks.size() == 14);
    const Model crank = read(decks[0]).model;
    REQUIRE(crank.joints.size() == 4);
    CHECK(crank.joints[1].a.anchor.arm == Vec3(0.15, 0, 0));
    CHECK(crank.joints[0].turn.motion);
    CHECK(read(decks[2]).model.joints.at(0).pulls_only);
    const Model shaft = read(decks[3]).model;
    CHECK(shaft.joints.at(1).kind == JointKind::free);
    const std::string wire = replaced(replaced(decks[4], "\"frame\"", "\"ground\""), "bead\"]", "top\"]");
    CHECK(read(body_deck + wire).model.joints[0].held == std::array{false, true, true, false, false, false});
    const std::string wrist = replaced(replaced(decks[6], "\"slider\"", "\"ground\""), "rod\"]", "top\"]");
    CHECK(read(body_deck + wrist).model.joints[0].clearance->contact.exponent == 1.5);
    CHECK(read(decks[7]).model.sleeves.at(0).place == Approx(0.25));
    CHECK(read(decks[8]).model.gears.at(0).ratio == 5.0);
    const std::string shafts = decks[8].substr(0, decks[8].find("[gear.reduction]"));
    const std::string ending = decks[8].substr(decks[8].find("[analysis]"));
    CHECK(read(shafts + decks[9] + ending).model.gears.at(0).teeth->upper == 0.005);
    CHECK(read(decks[10]).model.joints.size() == 4);
    const std::string hinge =
        "[joint.j]\ntype = \"hinge\"\nbetween = [\"ground\", \"top\"]\naxis = [0, 0, 1]\n";
    const std::string actions = replaced(decks[1], "drive    =", "# drive =");
    CHECK(read(body_deck + hinge + actions).model.joints[0].turn.friction.force == 0.3);
    const ScratchFile triangle("crank.stl", one_triangle);
    CHECK(read(decks[11]).model.joints.at(2).cam->roller == 0.01);
    const std::string looks = replaced(decks[12], "crank.stl", triangle.path().string());
    const BodyOutline outline = read(looks + "mass = 1\ninertia = [1, 1, 1]\n" + analysis).outlines.at(0);
    CHECK(outline.points.back().isApprox(Vec3(0, 1e-3, 0)));
    const std::string until = replaced(decks[5], "stages =", "# stages =");
    CHECK(read(body_deck + hinge + until).model.joints[0].strength.moment == 20.0);
}

}  // namespace gxrod::test
