#include <cmath>

#include "deck/decks.hpp"

namespace gxrod::test {

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
    CHECK(
        faults_of(
            replaced(rod_deck, "elements = 10", "elements = 2"),
            {R"(history=[{name = "a", at = "r@0.5", quantities = "position"}, {name = "b", at = "r@0.75", quantities = "position"}])"}) ==
        "x.toml:7:12: rod.r.elements: expected at least 3, one for each piece between the points that the "
        "deck names, found 2");
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

TEST_CASE("rhoJ is the sum of the other rotary inertias by default", "[deck]") {
    CHECK(read(replaced(rod_deck, "rhoJ = 20, ", "")).model.sections[0].mass(3, 3) == 21.0);
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
    CHECK(position(problem.output.histories[0].node) == Approx(7.7).epsilon(1e-15));
    CHECK(problem.output.histories[0].position_in_rod == problem.output.histories[0].node);
    CHECK(problem.output.histories[1].node == 10);
    CHECK(position(model.bodies[0].node) == Approx(9.0).epsilon(1e-15));
    CHECK(model.nodes[model.loads[0].node].name == "r@0.25");
    CHECK(model.nodes[1].name == "r node 1");
}

}  // namespace gxrod::test
