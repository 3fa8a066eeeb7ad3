#include "check/summaries/rod_summary.hpp"

#include <cmath>

#include "check/summaries/rod_lines.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/sample_law.hpp"

using namespace gxrod;

namespace {

Section make_section() {
    Section section{.name = "tube"};
    section.stiffness.diagonal() << 1e6, 4e5, 4e5, 50, 80, 100;
    section.mass.diagonal() << 2, 2, 2, 0.3, 0.1, 0.2;
    return section;
}

// A helix of radius 1 and pitch 2 about z, carried axes twisted by an angle from start to end.
Model make_helix(int elements, double turns, double twist) {
    Model model;
    model.sections = {make_section()};
    Rod rod;
    rod.name = "spring";
    const double p = 1.0 / M_PI;
    const double angle = 2.0 * M_PI * turns;
    const double length = angle * std::sqrt(1.0 + p * p);
    const Vec3 t0 = Vec3(0, 1, p).normalized();
    Mat3 start;
    start << t0, -Vec3::UnitX(), t0.cross(-Vec3::UnitX());
    std::vector<double> arc_length;
    std::vector<Quat> triads;
    for (int i = 0; i <= elements; ++i) {
        const double fraction = static_cast<double>(i) / elements;
        const double phi = fraction * angle;
        rod.nodes.push_back(i);
        Node node;
        node.position = Vec3(std::cos(phi), std::sin(phi), p * phi);
        model.nodes.push_back(node);
        arc_length.push_back(fraction * length);
        // The curve's own frame turns about the tangent by torsion × length more than carried axes do.
        const double torsion_angle = p / (1.0 + p * p) * fraction * length;
        triads.push_back(exp_quaternion({0, 0, phi}) * Quat(start) *
                         exp_quaternion({twist * fraction - torsion_angle, 0, 0}));
    }
    set_line_elements(rod, arc_length, triads);
    model.rods = {rod};
    return model;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("The twist of a curved rod is that beyond carrying its axes along", "[check]") {
    for (const double twist : {0.0, 0.8, -5.0}) {
        const Model fine = make_helix(60, 3.0, twist);
        CHECK(compute_twist(fine, fine.rods[0]) == Approx(twist).margin(1e-4));
    }
    // Of fourth order in the distance of the nodes.
    const auto error = [](int elements) {
        const Model model = make_helix(elements, 3.0, 0.0);
        return std::abs(compute_twist(model, model.rods[0]));
    };
    CHECK(std::log2(error(30) / error(60)) == Approx(4.0).margin(0.2));
}

TEST_CASE("The largest turn of the tangent in an element is an angle between its ends", "[check]") {
    const Model model = make_helix(24, 3.0, 0.0);
    // Tangents of a helix that climbs at an angle α, φ apart: cos(turn) = cos²α cos φ + sin²α.
    const double slope = 1.0 / M_PI;
    const double cosine = (std::cos(M_PI / 4.0) + slope * slope) / (1.0 + slope * slope);
    CHECK(compute_largest_turn(model.rods[0]) == Approx(std::acos(cosine)).epsilon(1e-12));
}

TEST_CASE("A corner between elements is not a turn in an element, nor a twist", "[check]") {
    Model model;
    model.nodes.resize(3);
    model.nodes[1].position = Vec3(1, 0, 0);
    model.nodes[2].position = Vec3(1, 1, 0);
    Rod rod;
    rod.element_nodes = {0, 1, 1, 2};
    const Quat turned = exp_quaternion({0, 0, M_PI / 2});
    rod.triads = {Quat::Identity(), Quat::Identity(), turned, turned};
    CHECK(compute_largest_turn(rod) == 0.0);
    CHECK(std::abs(compute_twist(model, rod)) < 1e-15);
}

TEST_CASE("A coarse mesh of a curve is warned of", "[check]") {
    const Model fine = make_helix(24, 2.0, 0.0);
    const std::string text = describe_rod(fine, fine.rods[0]);
    CHECK(has(text,
              "rod spring: length 13.1876, mass 26.3753, 24 objective elements of order 1, section tube\n"));
    CHECK(has(text, "  from (1, 0, 0) to (1, 0, 4)\n"));
    CHECK(has(text,
              "  axes at the start: x (0, 0.952891, 0.303314), y (-1, 0, 0), z (0, -0.303314, 0.952891)\n"));
    CHECK(has(text, "  axes at the end: "));
    CHECK(has(text, "  slenderness L √(EA/EI): 1474\n"));
    CHECK(has(text, "  largest turn of the tangent in an element: 28.6°\n"));
    CHECK(describe_coarse_rods(fine).empty());
    CHECK_FALSE(has(text, "twist"));
    const Model coarse = make_helix(12, 2.0, 1.0);
    const std::string warned = describe_rod(coarse, coarse.rods[0]);
    CHECK(describe_coarse_rods(coarse) ==
          "rod spring is bent by up to 56.9° in one element; more elements, or a higher order, would follow "
          "the "
          "curve");
    CHECK(has(warned, "  twist: "));
}

TEST_CASE("A section is described by its constants, or in full where they couple", "[check]") {
    Section section = make_section();
    CHECK(describe_section(section) ==
          "section tube:\n"
          "  stiffness: EA 1e+06, GAy 400000, GAz 400000, GJ 50, EIy 80, EIz 100\n"
          "  inertia per length: rhoA 2, rhoJ 0.3, rhoIy 0.1, rhoIz 0.2\n");
    section.stiffness(3, 4) = section.stiffness(4, 3) = 10.0;
    section.mass.setZero();
    section.kelvin_voigt = 1e-3;
    CHECK(describe_section(section) ==
          "section tube:\n"
          "  stiffness (x y z rx ry rz):\n"
          "           1e+06            0            0            0            0            0\n"
          "               0       400000            0            0            0            0\n"
          "               0            0       400000            0            0            0\n"
          "               0            0            0           50           10            0\n"
          "               0            0            0           10           80            0\n"
          "               0            0            0            0            0          100\n"
          "  inertia per length: none\n"
          "  bending stiffness 78 and 100 about y and z\n"  // 80 − 10²/50, free to twist
          "  damping: kelvin_voigt 0.001, mass_proportional 0\n");
}

TEST_CASE("A rod thicker than long is warned of", "[check]") {
    Model model = make_helix(24, 2.0, 0.0);
    CHECK(describe_thick_rods(model).empty());
    model.sections[0].stiffness.diagonal().tail<3>().setConstant(model.sections[0].stiffness(0, 0) * 100.0);
    CHECK(describe_thick_rods(model) == "rod spring is thicker than long; are all lengths in one unit?");
}

TEST_CASE("The law of a section is named, and damping by components", "[check]") {
    Section section = make_section();
    section.law = std::make_shared<const tools::SampleLaw>(section.stiffness, 0.0, 0.0);
    CHECK_THAT(describe_section(section), Catch::Contains("\n  law: a sample\n"));
    section.kelvin_voigt = 0.6;
    section.kelvin_voigt_components.emplace() << 0.1, 0.2, 0.3, 0.4, 0.5, 0.6;
    CHECK_THAT(describe_section(section), Catch::Contains("kelvin_voigt [0.1, 0.2, 0.3, 0.4, 0.5, 0.6],"));
}
