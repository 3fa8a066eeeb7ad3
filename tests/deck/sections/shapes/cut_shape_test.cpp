#include "deck/sections/shapes/cut_shape.hpp"

#include "deck/decks.hpp"
#include "model/sections/section_centres.hpp"
#include "run/stepped_run.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

// A cantilever of 1 m along x in mm and N, its section in line 2. Forces point down, along −z.
const std::string channel_deck = R"deck(units = "mm, N"
shape = 0
[section.s]
shape = { profile = "UPN 140", origin = "given" }
material = { E = 210e3, nu = 0.3, yield_stress = 235 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [1000, 0, 0] }
y_axis = [0, 1, 0]
elements = 2
order = 3
[[support]]
at = "r.start"
fix = "all"
[[load]]
at = "r.end"
force = [0, 0, -1]
[analysis]
kind = "static"
)deck";

std::string channel(const std::string& from = "", const std::string& to = "") {
    const std::string deck = replaced(channel_deck, "shape = 0\n", "\n");
    return from.empty() ? deck : replaced(deck, from, to);
}

struct Tip {
    Vec3 displacement;
    double twist;
};

Tip run_to_end(const Problem& problem) {
    RunRequest request{problem};
    SteppedRun simulation(request);
    while (simulation.step()) {
    }
    REQUIRE(simulation.summary().reason.empty());
    const auto last = static_cast<std::size_t>(problem.model.rods[0].nodes.back());
    const Snapshot snapshot = simulation.take_snapshot();
    const Quat turn = snapshot.nodes[last].Lambda;
    return {snapshot.nodes[last].r - problem.model.nodes[last].position, 2.0 * turn.x()};
}

const CrossSection& shape_of(const Problem& problem) {
    REQUIRE(problem.model.sections[0].shape);
    return *problem.model.sections[0].shape;
}

double compare(const Mat6& matrix, const Mat6& with) {
    const Vec6 scale = with.diagonal().cwiseSqrt();
    return ((matrix - with).array() / (scale * scale.transpose()).array()).abs().maxCoeff();
}

}  // namespace

TEST_CASE("a channel loaded at its shear centre does not twist, benchmark X33", "[deck][sections]") {
    const Problem given = read(channel());
    const SectionCentres centres(given.model.sections[0].stiffness, given.model.sections[0].mass);
    CHECK(centres.shear_centre().x() == Approx(-15.49477).epsilon(1e-4));
    CHECK(centres.tension_centre().x() == Approx(17.55426).epsilon(1e-6));
    const Tip at_web = run_to_end(given);
    CHECK(std::abs(at_web.twist) > 1e-7);
    const Problem shifted = read(channel("\"given\"", "\"shear centre\""));
    const Tip tip = run_to_end(shifted);
    CHECK(std::abs(tip.twist) < 1e-9 * std::abs(at_web.twist));
    CHECK(tip.displacement.z() == Approx(-2.76356e-4).epsilon(2e-5));
    const Problem centred = read(channel(", origin = \"given\"", ""));
    CHECK(SectionCentres(centred.model.sections[0].stiffness, Mat6::Zero()).tension_centre().norm() < 1e-5);
}

TEST_CASE("the stiffness of a shape and its stresses are in the axes of the rod", "[deck][sections]") {
    const Problem moved = read(channel("material", "at = [3, -2]\nturn = 0.4\nmaterial"));
    const Section& section = moved.model.sections[0];
    CHECK(compare(section.shape->properties.stiffness, section.stiffness) < 1e-12);
    // Resultants at the centroid without a moment there: an even stress.
    const PlanePoint centroid = section.shape->properties.centroid;
    Vec6 resultants;
    resultants << 1.0, 0.0, 0.0, 0.0, centroid.y(), -centroid.x();
    for (const StressPoint& point : section.shape->stresses.points) {
        const Vec6 stress = point.stress_operator * resultants;
        REQUIRE(stress[0] == Approx(1.0 / section.shape->properties.area).epsilon(1e-6));
    }
}

TEST_CASE("the yield stress of a shape on cells is a limit, not a law", "[deck][sections]") {
    const Problem problem = read(channel());
    CHECK(problem.model.sections[0].law == nullptr);
    CHECK(shape_of(problem).materials[0].yield_stress == 235.0);
}

TEST_CASE("equal shapes are computed once", "[deck][sections]") {
    CHECK(read(channel()).model.sections[0].shape == read(channel()).model.sections[0].shape);
    CHECK(read(channel()).model.sections[0].shape != read(channel("210e3", "211e3")).model.sections[0].shape);
}

TEST_CASE("a shape that varies is right between the stations at which it is computed", "[deck][sections]") {
    const std::string haunch =
        channel("profile = \"UPN 140\", origin = \"given\"",
                "I = { height = \"400 - 0.3*s\", width = 150, web = 7, flange = 11, fillet = 15 }");
    const Problem problem = read(haunch);
    const Rod& rod = problem.model.rods[0];
    REQUIRE(rod.varying.at_forces.size() == 6);
    const std::vector<double> places = list_force_points(rod);
    for (const std::size_t i : {0, 2, 4}) {
        const double height = 400.0 - 0.3 * places[i];
        const Problem there = read(replaced(haunch, "\"400 - 0.3*s\"", fmt::format("{:.17g}", height)));
        CHECK(compare(rod.varying.at_forces[i].stiffness, there.model.sections[0].stiffness) < 3e-5);
    }
    const auto is_note = [](const std::string& note) {
        return note.find("computed at 9 stations") != note.npos;
    };
    CHECK(std::ranges::count_if(problem.notes, is_note) == 1);
}

TEST_CASE("keys that a shape on cells does not have are refused", "[deck][sections]") {
    CHECK_THAT(
        faults_of(channel("yield_stress = 235", "shear_factor = 0.5")),
        Contains("x.toml:5:50: section.s.material.shear_factor: goes with a circle, a tube or a rectangle"));
    CHECK_THAT(
        faults_of(channel("nu = 0.3", "nu = 0.5")),
        Contains("x.toml:5:30: section.s.material.nu: nu = 0.5; expected more than -1 and at most 0.4999"));
    CHECK_THAT(faults_of(channel("nu = 0.3", "G = 50e3")),
               Contains("section.s.material.G: it means nu = 1.1; expected more than -1 and at most 0.4999"));
    const std::string steep =
        channel("profile = \"UPN 140\", origin = \"given\"",
                "I = { height = \"30 + 400*exp(-s/10)\", width = 150, web = 7, flange = 11 }");
    CHECK_THAT(faults_of(steep), Contains("varies too much along rod.r: the stiffness between 9 stations"));
}

}  // namespace gxrod::test
