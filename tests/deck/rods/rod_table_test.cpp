#include <algorithm>
#include <cmath>

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {

namespace {

// The place of the point of a history.
const RodPlace& place_of(const Problem& problem, std::size_t history) {
    return std::get<WatchedPoint>(problem.output.histories.at(history).target).place;
}

}  // namespace

TEST_CASE("A rod needs a section that exists, a length and a y axis across it", "[deck]") {
    CHECK(faults_of(replaced(rod_deck, R"("s")", R"("ss")")) ==
          R"(x.toml:5:11: rod.r.section: no section "ss"; the deck has s)");
    CHECK(faults_of(replaced(rod_deck, R"("s")", R"("tube")")) ==
          R"(x.toml:5:11: rod.r.section: no section "tube"; the deck has s)");
    CHECK(faults_of(R"([rod.r]
section = "s"
line = { from = [0, 0, 0], to = [10, 0, 0] }
elements = 10
element = "simo"
[analysis]
kind = "dynamic"
end_time = 1.0
steps = 10
)") == R"(x.toml:2:11: rod.r.section: no section "s"; the deck has no section)");
    CHECK(faults_of(replaced(rod_deck, "[10, 0, 0]", "[0, 0, 0]")) ==
          "x.toml:6:33: rod.r.line.to: the rod has no length; expected an end away from its start");
    CHECK(faults_of(replaced(rod_deck, R"(element = "simo")", R"(element = "simo"
y_axis = [0, 0, 0])")) == "x.toml:9:10: rod.r.y_axis: expected a direction, found a vector of zero length");
    CHECK(faults_of(replaced(rod_deck, R"(element = "simo")", R"(element = "simo"
y_axis = [-2, 0, 0])")) ==
          "x.toml:9:10: rod.r.y_axis: parallel to the rod, so that section y is not defined; expected "
          "another direction");
    CHECK(faults_of(replaced(rod_deck, R"(element = "simo")", R"(element = "simo"
y_axis = [1, 1e-7, 0])")) ==
          "x.toml:9:10: rod.r.y_axis: parallel to the rod, so that section y is not defined; expected "
          "another direction");
}

TEST_CASE("A rod needs an element for each piece between its points", "[deck]") {
    CHECK(faults_of(replaced(rod_deck, "elements = 10", "elements = 2"),
                    {R"(load=[{at = "r@0.5", force = [1, 0, 0]}, {at = "r@0.75", force = [1, 0, 0]}])"}) ==
          "x.toml:7:12: rod.r.elements: expected at least 3, one for each piece between the points that the "
          "deck names, found 2");
}

TEST_CASE("Elements follow the spacing of their rod", "[deck]") {
    const auto rod_of = [](const std::string& lines, const std::vector<std::string>& overrides = {}) {
        return read(replaced(rod_deck, "elements = 10", "elements = 10\n" + lines), overrides).model.rods[0];
    };
    // h = 1 + 3x: the element ends at (4^(k/10) − 1)/3 of the length 10, here with inner nodes.
    const Rod rod = rod_of("spacing = [[0, 1], [1, 4]]\norder = 2");
    REQUIRE(rod.element_count() == 10);
    for (int k = 0; k < 10; ++k) {
        const auto at = [](int i) { return 10.0 * (std::pow(4.0, i / 10.0) - 1.0) / 3.0; };
        CHECK(rod.arc_length[3 * k] == Approx(at(k)).epsilon(0).margin(1e-14));
        CHECK(rod.arc_length[3 * k + 1] == Approx(0.5 * (at(k) + at(k + 1))).epsilon(0).margin(1e-14));
    }
    // A point has a node, which is where it was asked for.
    const Rod loaded = rod_of("spacing = [[0, 1], [1, 4]]", {"load=[{at = \"r@0.3\", force = [1, 0, 0]}]"});
    CHECK(std::ranges::find(loaded.arc_length, 3.0) != loaded.arc_length.end());
    // Sizes can jump.
    CHECK(rod_of("spacing = [[0, \"1 + 1\"], [0.5, 2], [0.5, 1], [1, 1]]").arc_length[1] > 1.4);
}

TEST_CASE("What is wrong with a spacing is said where it stands", "[deck]") {
    const auto faults = [](const std::string& spacing) {
        return faults_of(replaced(rod_deck, "elements = 10", "elements = 10\nspacing = " + spacing));
    };
    CHECK(faults("2") ==
          "x.toml:8:11: rod.r.spacing: expected an array of rows [fraction, number greater than 0], two at "
          "least, from 0 to 1, found 2");
    CHECK_THAT(faults("[[0, 1]]"), Catch::Contains("two at least"));
    CHECK(faults("[[0, 1], [1, 0]]") ==
          "x.toml:8:24: rod.r.spacing[1][1]: expected a number greater than 0, found 0");
    CHECK_THAT(faults("[[0, 1], [0.9, 2]]"),
               Catch::Contains("rod.r.spacing[1]: expected the fraction 1 here"));
    CHECK_THAT(faults("[[0, 1], [0.9, 2], [0.8, 2], [1, 1]]"), Catch::Contains("must not fall"));
    CHECK_THAT(faults("[[0, 1e-12], [1, 1]]"),
               Catch::Contains("rod.r.spacing: the shortest of 10 elements has"));
    CHECK_THAT(faults_of(replaced(rod_deck, "elements = 10", "elements = 10\nspacings = [[0, 1], [1, 2]]")),
               Catch::Contains("spacing"));
}

TEST_CASE("A rod needs elements that are bent and twisted by less than half a turn from their middle",
          "[deck]") {
    const auto circle = [](const std::string& angle, const std::string& elements) {
        return replaced(replaced(rod_deck,
                                 "line = { from = [0, 0, 0], to = [10, 0, 0] }",
                                 "arc = { centre = [0, 0, 0], axis = [0, 0, 1], from = [5, 0, 0], angle = " +
                                     angle + " }"),
                        "elements = 10",
                        elements);
    };
    CHECK(faults_of(circle("\"2*pi\"", "elements = 1")) ==
          "x.toml:7:12: rod.r.elements: the rod is bent and twisted by 360° within one element of order 1; "
          "expected less than 180°: more elements");
    CHECK(faults_of(circle("\"2*pi\"", "elements = 1\norder = 4")) ==
          "x.toml:7:12: rod.r.elements: the rod is bent and twisted by 360° within one element of order 4; "
          "expected less than 360°: more elements");
    CHECK(faults_of(circle("\"-pi\"", "elements = 1")) ==
          "x.toml:7:12: rod.r.elements: the rod is bent and twisted by 180° within one element of order 1; "
          "expected less than 180°: more elements");
    CHECK(faults_of(circle("\"0.99*pi\"", "elements = 1")).empty());
    CHECK(faults_of(circle("\"1.99*pi\"", "elements = 1\norder = 2")).empty());
    CHECK(faults_of(circle("\"2*pi\"", "elements = 3")).empty());
    // A whole turn would be none for the element, two would be none for both.
    const std::string straight = replaced(rod_deck, "elements = 10", "elements = 2");
    CHECK(faults_of(straight, {"rod.r.twist=\"4*pi\""}) ==
          "x.toml:7:12: rod.r.elements: the rod is bent and twisted by 360° within one element of order 1; "
          "expected less than 180°: more elements");
    CHECK(faults_of(straight, {"rod.r.twist=\"1.99*pi\""}).empty());
    // A helix of little radius hardly bends, a spline here bends by a right angle twice.
    const std::string helix = replaced(rod_deck,
                                       "line = { from = [0, 0, 0], to = [10, 0, 0] }",
                                       "helix = { centre = [0, 0, 0], axis = [0, 0, 1], from = [1e-3, 0, 0], "
                                       "turns = 3, pitch = 10 }");
    CHECK(faults_of(helix, {"rod.r.elements=1"}).empty());
    const std::string spline = replaced(rod_deck,
                                        "line = { from = [0, 0, 0], to = [10, 0, 0] }",
                                        "spline = [[0, 0, 0], [3, 5, 0], [5, 5.5, 0], [7, 5, 0], [4, 0, 0]]");
    CHECK_THAT(faults_of(spline, {"rod.r.elements=1"}), Catch::Contains("within one element of order 1"));
    CHECK(faults_of(spline, {"rod.r.elements=2"}).empty());
}

TEST_CASE("Section axes are right-handed, x along the rod, y as given", "[deck]") {
    const auto triad = [](const std::string& to, const std::string& y_axis) {
        const std::string line = y_axis.empty() ? "" : "\ny_axis = " + y_axis;
        return read(replaced(replaced(rod_deck, "[10, 0, 0]", to), "\"simo\"", "\"simo\"" + line))
            .model.rods[0]
            .triads[0]
            .toRotationMatrix()
            .eval();
    };
    Mat3 expected;
    expected << 1, 0, 0, 0, 1, 0, 0, 0, 1;
    CHECK(triad("[10, 0, 0]", "").isApprox(expected, 1e-15));
    expected << 0, 0, 1, 1, 0, 0, 0, 1, 0;
    CHECK(triad("[0, 10, 0]", "").isApprox(expected, 1e-15));
    expected << 0, 0, -1, 0, 1, 0, 1, 0, 0;
    CHECK(triad("[0, 0, 10]", "").isApprox(expected, 1e-15));
    expected << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    CHECK(triad("[10, 0, 0]", "[3, 0, 2]").isApprox(expected, 1e-15));
    expected << -1, 0, 0, 0, -1, 0, 0, 0, 1;
    CHECK(triad("[-10, 0, 0]", "[0, -1, 0]").isApprox(expected, 1e-15));
    CHECK(triad("[1e-200, 0, 0]", "[0, 1e-200, 0]").isApprox(Mat3::Identity(), 1e-15));
    const Mat3 oblique = triad("[1, 2, 3]", "[0.3, -1, 2]");
    CHECK((oblique.transpose() * oblique - Mat3::Identity()).norm() < 1e-15);
    CHECK(oblique.determinant() == Approx(1.0));
    CHECK(oblique.col(0).isApprox(Vec3(1, 2, 3).normalized(), 1e-15));
    CHECK(oblique.col(1).dot(Vec3(0.3, -1, 2)) > 0.0);
    CHECK(std::abs(oblique.col(2).dot(Vec3(0.3, -1, 2))) < 1e-15);
}

TEST_CASE("A y axis that the reader chose is in the notes", "[deck]") {
    CHECK(read(rod_deck).notes ==
          std::vector<std::string>{
              "rod.r.y_axis: not given; section y at the start is [0, 1, 0], from global y"});
    CHECK(read(replaced(rod_deck, "[10, 0, 0]", "[-6, 8, 0]")).notes ==
          std::vector<std::string>{
              "rod.r.y_axis: not given; section y at the start is [0, 0, 1], from global z"});
    CHECK(read(replaced(rod_deck, "[10, 0, 0]", "[1, 1, 1]")).notes ==
          std::vector<std::string>{"rod.r.y_axis: not given; section y at the start is [-0.408248, 0.816497, "
                                   "-0.408248], from global y"});
    CHECK(read(replaced(rod_deck, "\"simo\"", "\"simo\"\ny_axis = [0, 1, 0]")).notes.empty());
}

TEST_CASE("Points that loads, supports, histories and bodies name get a node", "[deck]") {
    const Problem problem = read(rod_deck +
                                 "[[load]]\nat = \"r@0.25\"\nforce = [0, 0, 1]\n"
                                 "[[support]]\nat = \"r@0.31\"\nfix = \"x\"\n"
                                 "[[history]]\nname = \"h\"\nat = \"r@0.77\"\nquantities = \"strain\"\n"
                                 "[[history]]\nname = \"e\"\nat = \"r@1\"\nquantities = \"strain\"\n"
                                 "[body.b]\nmass = 1\ninertia = [1, 1, 1]\nat = \"r@9e-1\"\n");
    const Model& model = problem.model;
    REQUIRE(model.nodes.size() == 11);
    const auto position = [&](int node) { return model.nodes[node].position[0]; };
    CHECK(position(model.loads[0].node) == Approx(2.5).epsilon(1e-15));
    CHECK(position(model.supports[0].node) == Approx(3.1).epsilon(1e-15));
    // A history needs no node.
    CHECK(node_of(problem.output.histories[0].target) == -1);
    CHECK(place_of(problem, 0).element == 7);
    CHECK(node_of(problem.output.histories[1].target) == 10);
    CHECK(position(model.bodies[0].node) == Approx(9.0).epsilon(1e-15));
    CHECK(model.nodes[model.loads[0].node].name == "r@0.25");
    CHECK(model.nodes[1].name == "r node 1");
}

TEST_CASE("Inner nodes of elements are at the Gauss-Lobatto points of their length", "[deck]") {
    const std::vector<std::vector<double>> expected{
        {0.0, 1.0},
        {0.0, 0.5, 1.0},
        {0.0, 0.5 * (1.0 - std::sqrt(0.2)), 0.5 * (1.0 + std::sqrt(0.2)), 1.0},
        {0.0, 0.5 * (1.0 - std::sqrt(3.0 / 7.0)), 0.5, 0.5 * (1.0 + std::sqrt(3.0 / 7.0)), 1.0}};
    // A half circle of length 10.
    const std::string arc =
        "arc = { centre = [0, 0, 0], axis = [0, 0, 1], from = [\"10/pi\", 0, 0], angle = \"pi\" }";
    const std::string deck = replaced(rod_deck, "line = { from = [0, 0, 0], to = [10, 0, 0] }", arc);
    for (std::size_t order = 1; order <= 4; ++order) {
        const Model model = read(deck, {"rod.r.order=" + std::to_string(order)}).model;
        const Rod& rod = model.rods[0];
        CHECK(rod.order == static_cast<int>(order));
        CHECK(rod.element_count() == 10);
        REQUIRE(rod.nodes.size() == 10 * order + 1);
        CHECK(rod.length == Approx(10.0).epsilon(1e-15));
        for (std::size_t e = 0; e < 10; ++e) {
            for (std::size_t i = 0; i <= order; ++i) {
                const std::size_t entry = e * (order + 1) + i;
                CHECK(rod.element_nodes[entry] == static_cast<int>(e * order + i));
                const double s = static_cast<double>(e) + expected[order - 1][i];
                CHECK(rod.arc_length[entry] == Approx(s).epsilon(1e-14));
                const double angle = M_PI * s / 10.0;
                const Vec3& position =
                    model.nodes[static_cast<std::size_t>(rod.element_nodes[entry])].position;
                CHECK((position - 10.0 / M_PI * Vec3(std::cos(angle), std::sin(angle), 0)).norm() < 1e-14);
                const Vec3 tangent = rod.triads[entry] * Vec3::UnitX();
                CHECK((tangent - Vec3(-std::sin(angle), std::cos(angle), 0)).norm() < 1e-14);
            }
        }
    }
}

TEST_CASE("A corner of a polyline has one node and two triads", "[deck]") {
    const std::string deck = replaced(rod_deck,
                                      "line = { from = [0, 0, 0], to = [10, 0, 0] }",
                                      "polyline = [[0, 0, 0], [0, 0, 3], [1, 0, 3]]");
    const Problem problem =
        read(deck + "[[history]]\nname = \"c\"\nat = \"r@0.75\"\nquantities = \"position\"\n",
             {"rod.r.order=2", "rod.r.elements=4"});
    const Rod& rod = problem.model.rods[0];
    REQUIRE(rod.element_count() == 4);
    CHECK(problem.model.nodes.size() == 9);
    // Elements share the pieces by length: three and one.
    const int corner = rod.element_nodes[8];
    CHECK(corner == rod.element_nodes[9]);
    CHECK(problem.model.nodes[static_cast<std::size_t>(corner)].position == Vec3(0, 0, 3));
    CHECK(node_of(problem.output.histories[0].target) == corner);
    CHECK(place_of(problem, 0).element == 2);
    CHECK(place_of(problem, 0).xi == 1.0);
    CHECK((rod.triads[8] * Vec3::UnitX() - Vec3(0, 0, 1)).norm() < 1e-15);
    CHECK((rod.triads[9] * Vec3::UnitX() - Vec3(1, 0, 0)).norm() < 1e-15);
    // Section y, along global y, is across both legs and does not turn.
    for (const Quat& triad : rod.triads) CHECK((triad * Vec3::UnitY() - Vec3(0, 1, 0)).norm() < 1e-15);
    CHECK(rod.length == 4.0);
    CHECK(rod.arc_length[9] == 3.0);
}

TEST_CASE("Corners of a polyline are nodes, also where equal elements would almost have one", "[deck]") {
    const std::string deck = replaced(rod_deck,
                                      "line = { from = [0, 0, 0], to = [10, 0, 0] }",
                                      "polyline = [[0, 0, 0], [4.999999998, 0, 0], [10, 0.001, 0]]");
    const Model model = read(deck).model;
    CHECK(model.nodes.size() == 11);
    CHECK(model.nodes[5].position == Vec3(4.999999998, 0, 0));
}

TEST_CASE("Section axes are carried along a helix without twisting, and then twisted evenly", "[deck]") {
    const std::string deck = replaced(rod_deck,
                                      "line = { from = [0, 0, 0], to = [10, 0, 0] }",
                                      "helix = { centre = [0, 0, 0], axis = [0, 0, 1], from = [2, 0, 0], "
                                      "turns = 1.5, pitch = 3 }\ny_axis = [-1, 0, 0]");
    // Section y starts along the normal of the curve. Carried along, it lags the normal by the
    // torsion times the length.
    const double p = 3.0 / (2.0 * M_PI);
    const double torsion = p / (4.0 + p * p);
    for (const double twist : {0.0, 0.7, -20.0}) {
        const Model model = read(deck, {"rod.r.order=3", "rod.r.twist=" + std::to_string(twist)}).model;
        const Rod& rod = model.rods[0];
        for (std::size_t i = 0; i < rod.triads.size(); ++i) {
            const double s = rod.arc_length[i];
            const double phi = 3.0 * M_PI * s / rod.length;
            const Vec3 normal(-std::cos(phi), -std::sin(phi), 0);
            const Vec3 x = rod.triads[i] * Vec3::UnitX();
            const double ahead = twist * s / rod.length - torsion * s;
            const Vec3 y = std::cos(ahead) * normal + std::sin(ahead) * x.cross(normal);
            CHECK((rod.triads[i] * Vec3::UnitY() - y).norm() < 1e-13);
        }
    }
}

TEST_CASE("Elements of a rod are objective by default", "[deck]") {
    CHECK(read(rod_deck).model.rods[0].kind == ElementKind::simo);
    CHECK(read(replaced(rod_deck, "element = \"simo\"\n", "")).model.rods[0].kind == ElementKind::objective);
    CHECK(read(replaced(rod_deck, "\"simo\"", "\"objective\"")).model.rods[0].kind == ElementKind::objective);
}

}  // namespace gxrod::test
