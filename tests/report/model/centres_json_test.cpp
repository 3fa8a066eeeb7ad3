#include "report/model/centres_json.hpp"

#include <nlohmann/json.hpp>

#include "deck/problem.hpp"
#include "report/model/drawn_cells.hpp"
#include "tools/catch.hpp"

using namespace gxrod;
using Json = nlohmann::json;

namespace {

// Two rods: one with its section about the line, one with another key of the rod for its section.
Model make_model(const std::string& other_section) {
    const std::string deck = R"(
[section.plain]
stiffness = { EA = 100, GAy = 40, GAz = 30, GJ = 5, EIy = 6, EIz = 7 }
[section.moved]
stiffness = { EA = 100, GAy = 40, GAz = 30, GJ = 5, EIy = 6, EIz = 7 }
inertia = { rhoA = 2, rhoJ = 0.3, rhoIy = 0.1, rhoIz = 0.2 }
at = [0.7, -0.3]
turn = 0.2
[section.root]
shape = { rectangle = { width_y = 0.2, height_z = 0.4 } }
material = { E = 1e6, nu = 0.3, density = 1000 }
[section.tip]
shape = { rectangle = { width_y = 0.1, height_z = 0.1 } }
material = { E = 1e6, nu = 0.3, density = 1000 }
at = [0, 0.1]
[rod.a]
section = "plain"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 2
[rod.b]
)" + other_section +
                             R"(
line = { from = [0, 1, 0], to = [2, 1, 0] }
elements = 2
order = 2
[analysis]
kind = "static"
)";
    return read_problem_text(deck, "x.toml").model;
}

void check_point(const Json& point, double y, double z) {
    CHECK(point.at(0).get<double>() == Approx(y).margin(1e-12));
    CHECK(point.at(1).get<double>() == Approx(z).margin(1e-12));
}

}  // namespace

TEST_CASE("Centres of sections are described where they are off the line", "[report]") {
    CHECK(describe_centres_along(make_model("section = \"plain\"")).empty());
    const Model model = make_model("section = \"moved\"");
    const Json rods = describe_centres_along(model);
    REQUIRE(rods.size() == 1);
    CHECK(rods[0]["rod"] == 1);
    REQUIRE(rods[0]["stations"].size() == 1);
    const Json& station = rods[0]["stations"][0];
    for (const char* centre : {"shear", "tension", "mass"}) check_point(station[centre], 0.7, -0.3);
    CHECK(station["turn"].get<double>() == Approx(0.2));

    const Json table = describe_centre_table(model);
    REQUIRE(table["rows"].size() == 2);  // and tip, which no rod has
    CHECK(table["rows"][0][0] == "moved");
    CHECK(table["rows"][0][1] == "(0.7, -0.3)");
    CHECK(table["rows"][0][4].get<double>() == Approx(0.2 * 180.0 / M_PI));
    CHECK(table["rows"][0][5].get<double>() == Approx(6.0));
    CHECK(table["rows"][0].size() == table["columns"].size());
}

TEST_CASE("Centres of a section that varies are described along the rod", "[report]") {
    const Model model = make_model("sections = [[0, \"root\"], [1, \"tip\"]]");
    const Json rods = describe_centres_along(model);
    REQUIRE(rods.size() == 1);
    const Json& stations = rods[0]["stations"];
    REQUIRE(stations.size() == 6);
    check_point(stations[0]["tension"], 0.0, 0.0);
    check_point(stations[5]["tension"], 0.0, 0.1);
    CHECK(stations[5]["s"] == 2.0);
    // Linear matrices: EA z of the middle over EA, 0.08 and 0.01 of E.
    CHECK(stations[2]["s"] == 1.0);
    check_point(stations[2]["tension"], 0.0, 0.1 * 0.01 / 0.09);
    const Json table = describe_centre_table(model);
    REQUIRE(table["rows"].size() == 3);  // tip, too, is a section of the model
    CHECK(table["rows"][1][0] == "tip");
    CHECK(table["rows"][2][0] == "b.end");
}

TEST_CASE("Cells of a rod whose section varies have the radii of their nodes", "[report]") {
    const Model model = make_model("sections = [[0, \"root\"], [1, \"tip\"]]");
    FrameTopology topology;
    topology.nodes = 8;
    topology.cells = 4;
    for (const std::vector<int>& nodes : {std::vector{0, 1}, {1, 2}, {3, 5, 4}, {5, 7, 6}}) {
        DrawnCell& cell = topology.rod_cells.emplace_back();
        cell.nodes = nodes;
        cell.radii.assign(nodes.size(), {1.0, 1.0});
    }
    REQUIRE(refine_cells(model, topology));
    // 2 √(EI/EA) of a rectangle: a side over √3. The ends come first.
    const auto& first = topology.rod_cells[2];
    const auto& last = topology.rod_cells[3];
    REQUIRE(last.radii.size() == 3);
    CHECK(first.radii[0][0] == Approx(0.2 / std::sqrt(3.0)));
    CHECK(first.radii[0][1] == Approx(0.4 / std::sqrt(3.0)));
    CHECK(last.radii[1][0] == Approx(0.1 / std::sqrt(3.0)));
    CHECK(first.radii[1] == last.radii[0]);
    CHECK(first.radii[2][0] < first.radii[0][0]);
    CHECK(first.radii[2][0] > first.radii[1][0]);
    // Joined pieces keep the taper.
    const std::vector<DrawnCell> joined = join_cells(topology.rod_cells, 2, std::vector<bool>(8, false));
    REQUIRE(joined.size() == 2);
    CHECK(joined[1].radii.front() == first.radii[0]);
    CHECK(joined[1].radii.back() == last.radii[1]);
}
