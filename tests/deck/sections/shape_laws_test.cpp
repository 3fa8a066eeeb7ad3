#include "deck/sections/shape_laws.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "deck/decks.hpp"
#include "laws/fibre_law.hpp"
#include "laws/law_path.hpp"
#include "laws/plastic_law.hpp"
#include "tools/catch.hpp"

// Laws by the yield stress of shapes that are cut into cells.
namespace gxrod::test {
namespace {

using Catch::Contains;

const std::string rest = R"deck([rod.r]
section = "s"
line = { from = [0, 0, 0], to = [2000, 0, 0] }
elements = 2
[[support]]
at = "r.start"
fix = "all"
[analysis]
kind = "static"
)deck";

std::string deck(const std::string& shape, const std::string& material, const std::string& law = "") {
    return "units = \"mm, N\"\n[section.s]\nshape = { " + shape + " }\nmaterial = { E = 210e3, nu = 0.3, " +
           material + " }\n" + law + rest;
}

const std::string ipe = "profile = \"IPE 200\"";
const std::string fibres = "yield_stress = 235, interaction = true";
constexpr double forever = std::numeric_limits<double>::infinity();

const SectionLaw& law_of(const Problem& problem) {
    REQUIRE(problem.model.sections[0].law);
    return *problem.model.sections[0].law;
}

// The resultants after a curvature from nothing, the axial force held.
Vec6 bend_under(const SectionLaw& law, double force, double curvature, int entry) {
    const LawPath path(law);
    double low = -5.0, high = 5.0;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        Vec6 strain = strain_along(entry, curvature);
        strain[0] = middle;
        (path.look(strain, forever).resultants[0] < force ? low : high) = middle;
    }
    Vec6 strain = strain_along(entry, curvature);
    strain[0] = high;
    return path.look(strain, forever).resultants;
}

}  // namespace

TEST_CASE("Fibres of an IPE 200 have its stiffness and its plastic moments", "[deck][sections]") {
    const Problem elastic = read(deck(ipe, "yield_stress = 235")), yields = read(deck(ipe, fibres));
    CHECK(!elastic.model.sections[0].law);
    const Mat6 &C = elastic.model.sections[0].stiffness, &of_fibres = yields.model.sections[0].stiffness;
    const Vec6 scale = C.diagonal().cwiseSqrt();
    CHECK(((C - of_fibres).array() / (scale * scale.transpose()).array()).abs().maxCoeff() < 1e-9);
    const SectionLaw& law = law_of(yields);
    CHECK(law.describe() == "yields, fibres: 512");
    CHECK(bend_under(law, 0.0, 0.1, 4)[4] == Approx(220638.65 * 235.0).epsilon(1e-3));
    CHECK(bend_under(law, 0.0, 0.1, 5)[5] == Approx(44612.0 * 235.0).epsilon(2e-3));
    CHECK(LawPath(law).look(strain_along(0, 0.1), forever).resultants[0] ==
          Approx(2848.4107 * 235.0).epsilon(1e-5));
}

TEST_CASE("Fibres of a rectangle of cells yield by axial force and moment, and unload elastically",
          "[deck][sections]") {
    const std::string outer = "polygon = { outer = [[-20, -50], [20, -50], [20, 50], [-20, 50]] }";
    const Problem problem = read(deck(outer, fibres));
    const SectionLaw& law = law_of(problem);
    const double Np = 40.0 * 100.0 * 235.0, Mp = 0.25 * 40.0 * 1e4 * 235.0;
    for (const double part : {0.0, 0.2, 0.5, 0.8}) {
        const Vec6 found = bend_under(law, part * Np, 0.05, 4);
        CHECK(found[4] / Mp == Approx(1.0 - part * part).margin(3e-3));
    }
    LawPath path(law);
    Vec6 bent = strain_along(4, 1e-3);
    bent[0] = 1e-4;
    const Vec6 before = path.go(bent, forever).resultants;
    const Vec6 back = -1e-4 * bent;
    const Vec6 after = path.look(bent + back, forever).resultants;
    CHECK((after - before - problem.model.sections[0].stiffness * back).norm() < 1e-9 * before.norm());
}

TEST_CASE("Fibres of a section that varies have its stiffness everywhere", "[deck][sections]") {
    const std::string box =
        "box = { height = \"200 - 0.04*s\", width = 100, wall = 8, outer_radius = 12, inner_radius = 4 }";
    const Problem elastic = read(deck(box, "yield_stress = 235")), yields = read(deck(box, fibres));
    const auto &a = elastic.model.rods[0].varying.at_forces, &b = yields.model.rods[0].varying.at_forces;
    REQUIRE(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Vec6 scale = a[i].stiffness.diagonal().cwiseSqrt();
        const Mat6 difference = a[i].stiffness - b[i].stiffness;
        CHECK((difference.array() / (scale * scale.transpose()).array()).abs().maxCoeff() < 1e-9);
        CHECK(b[i].law->describe() == "yields, fibres: 512");
    }
}

TEST_CASE("A plastic law takes its limits from a shape", "[deck][sections]") {
    const std::string law = "law = { plastic = { yield = \"shape\" } }\n";
    const auto limits = [&](const std::string& text) {
        return dynamic_cast<const PlasticLaw&>(law_of(read(text))).yield().limits;
    };
    const auto ipe_limits = limits(deck(ipe, "yield_stress = 235", law));
    REQUIRE(ipe_limits.size() == 3);
    CHECK(ipe_limits[0].second == Approx(2848.4107 * 235.0).epsilon(1e-5));
    CHECK(ipe_limits[1].first == 4);
    CHECK(ipe_limits[1].second == Approx(220638.65 * 235.0).epsilon(1e-5));
    CHECK(ipe_limits[2].second == Approx(44612.0 * 235.0).epsilon(1e-3));
    const auto circle = limits(deck("circle = { radius = 30 }", "yield_stress = 235", law));
    CHECK(circle[1].second == Approx(4.0 / 3.0 * 27e3 * 235.0));
    const auto tube =
        limits(deck("tube = { outer_radius = 30, inner_radius = 20 }", "yield_stress = 235", law));
    CHECK(tube[0].second == Approx(M_PI * 500.0 * 235.0));
    const auto rectangle =
        limits(deck("rectangle = { width_y = 20, height_z = 60 }", "yield_stress = 235", law));
    CHECK(rectangle[1].second == Approx(0.25 * 20.0 * 3600.0 * 235.0));
    CHECK(rectangle[2].second == Approx(0.25 * 60.0 * 400.0 * 235.0));
}

TEST_CASE("A plastic law by a shape is about the point where its axial force acts", "[deck][sections]") {
    const std::string angle = "angle = { height = 100, width = 100, wall = 10 }, origin = \"given\"";
    const Problem problem =
        read(deck(angle, "yield_stress = 235", "law = { plastic = { yield = \"shape\" } }\n"));
    const SectionLaw& law = law_of(problem);
    // Stretched without bending about its middle it carries the whole axial force.
    const Vec6 found = LawPath(law).look(strain_along(0, 1.0), forever).resultants;
    CHECK(found[0] == Approx(1900.0 * 235.0).epsilon(1e-3));
    CHECK(found[4] == Approx(found[0] * 28.6842).epsilon(1e-3));
}

TEST_CASE("What is wrong with a law by a shape is said with its place", "[deck][sections]") {
    const std::string law = "law = { plastic = { yield = \"shape\" } }\n";
    CHECK_THAT(
        faults_of(deck(ipe, "density = 1e-9", law)),
        Contains("section.s.law.plastic.yield: \"shape\" needs yield_stress of what the section is made of"));
    CHECK_THAT(faults_of(deck(ipe, fibres, law)),
               Contains("section.s.law: interaction of the material is given too; only one of them can be"));
    CHECK_THAT(
        faults_of(deck(
            "circle = { radius = 3 }", "yield_stress = 235", "law = { plastic = { yield = { N = 1 } } }\n")),
        Contains("section.s.law: yield_stress of the material is given too; only one of them can be"));
    CHECK_THAT(faults_of(deck(
                   "box = { height = \"200 - s/50\", width = 100, wall = 8 }", "yield_stress = 235", law)),
               Contains("\"shape\" goes with a shape that is the same along the rod"));
    CHECK_THAT(faults_of(deck(ipe, "yield_stress = 235", "law = { plastic = { yield = \"shapes\" } }\n")),
               Contains("section.s.law.plastic.yield: expected "));
    CHECK_THAT(faults_of(replaced(rod_deck, "inertia = { rhoA", law + "inertia = { rhoA")),
               Contains("\"shape\" goes with a section that has a shape; expected limits"));
}

}  // namespace gxrod::test
