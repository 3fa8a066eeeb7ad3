#include "report/model/drawn_cells.hpp"

#include "results/results_file.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

DrawnCell make_cell(int start, int end, int source) {
    DrawnCell cell;
    cell.nodes = {start, end};
    cell.axes = {Quat::Identity(), Quat::Identity()};
    cell.radii.assign(2, {0.1, 0.1});
    cell.source = source;
    return cell;
}

// A line of straight elements, node i to i + 1.
std::vector<DrawnCell> make_line(int elements) {
    std::vector<DrawnCell> cells;
    for (int i = 0; i < elements; ++i) {
        cells.push_back(make_cell(i, i + 1, i));
    }
    return cells;
}

std::vector<std::pair<int, int>> ends_of(const std::vector<DrawnCell>& cells) {
    std::vector<std::pair<int, int>> ends;
    for (const DrawnCell& cell : cells) ends.emplace_back(cell.nodes[0], cell.nodes[1]);
    return ends;
}

using Ends = std::vector<std::pair<int, int>>;

}  // namespace

TEST_CASE("Elements in a line are joined, with the data of the middle one", "[report]") {
    const std::vector<DrawnCell> joined = join_cells(make_line(10), 4, std::vector<bool>(11, false));
    CHECK(ends_of(joined) == Ends{{0, 4}, {4, 8}, {8, 10}});
    CHECK(joined[0].source == 1);
    CHECK(join_cells(make_line(10), 1, std::vector<bool>(11, false)).size() == 10);
}

TEST_CASE("Joined elements keep their places along the rod, and end with it", "[report]") {
    std::vector<DrawnCell> cells = make_line(6);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const double s = i < 4 ? 0.5 * static_cast<double>(i) : 0.5 * static_cast<double>(i - 4);
        cells[i].rod = i < 4 ? 0 : 1;
        cells[i].arc_length = {s, s + 0.5};
        cells[i].middle = s + 0.25;
    }
    const std::vector<DrawnCell> joined = join_cells(cells, 3, std::vector<bool>(7, false));
    CHECK(ends_of(joined) == Ends{{0, 3}, {3, 4}, {4, 6}});
    CHECK(joined[0].arc_length == std::vector{0.0, 1.5});
    CHECK(joined[0].middle == 0.75);
    CHECK(joined[2].rod == 1);
    CHECK(joined[2].arc_length == std::vector{0.0, 1.0});
}

TEST_CASE("Nodes to keep, corners, other radii and branches end a piece", "[report]") {
    std::vector<bool> kept(12, false);
    std::vector<DrawnCell> cells = make_line(10);
    kept[2] = true;
    cells[3].axes[1] = Quat(Eigen::AngleAxisd(0.5, Vec3::UnitZ()));     // at node 4
    for (std::size_t i : {6, 7}) cells[i].radii.assign(2, {0.2, 0.1});  // from node 6 to 8
    cells.push_back(make_cell(9, 11, 10));
    CHECK(ends_of(join_cells(cells, 100, kept)) ==
          Ends{{0, 2}, {2, 4}, {4, 6}, {6, 8}, {8, 9}, {9, 10}, {9, 11}});
}

TEST_CASE("Sampled cells are evenly chosen", "[report]") {
    CHECK(ends_of(sample_cells(make_line(10), 5)) == Ends{{0, 1}, {2, 3}, {4, 5}, {6, 7}, {8, 9}});
    CHECK(sample_cells(make_line(10), 10).size() == 10);
}

TEST_CASE("Cells come from the file and, by its model, get true axes and sections", "[report]") {
    const sample::ScratchFolder folder;
    Model model = sample::make_model();
    const sample::Motion motion(0.0);
    {
        ResultsFile file({folder / "a.vtkhdf"}, sample::make_deck(), model, OutputSettings{});
        file.write_frame(motion.snapshot());
        file.close(RunStatus::complete, "");
    }
    FrameTopology topology = read_topology(Hdf5Reader(folder / "a.vtkhdf"));
    CHECK(topology.nodes == 4);
    CHECK(topology.cells == 4);
    CHECK(ends_of(topology.rod_cells) == Ends{{0, 1}, {1, 2}});
    CHECK(topology.body_nodes == std::vector<int>{2, 3});
    const std::array<double, 2> round = topology.rod_cells[0].radii[0];
    CHECK(round[0] == round[1]);

    Mat6& stiffness = model.sections[0].stiffness;
    stiffness(0, 0) = 100.0;
    stiffness(4, 4) = 4.0;  // about y: 2 √(4/100) along z
    stiffness(5, 5) = 1.0;
    REQUIRE(refine_cells(model, topology));
    REQUIRE(topology.rod_cells[1].radii.size() == 2);
    CHECK(topology.rod_cells[1].radii[1][0] == Approx(0.2));
    CHECK(topology.rod_cells[1].radii[1][1] == Approx(0.4));
    CHECK(topology.rod_cells[1].axes[1].angularDistance(model.rods[0].triads.back()) < 1e-12);

    model.bodies.pop_back();
    CHECK_FALSE(refine_cells(model, topology));
}

TEST_CASE("Cells of another mesh stay as they are", "[report]") {
    const Model model = sample::make_model();
    FrameTopology topology;
    topology.nodes = 4;
    topology.cells = 4;
    topology.rod_cells = make_line(2);
    topology.rod_cells[1].nodes = {1, 2, 3};
    topology.body_nodes = {2, 3};
    CHECK_FALSE(refine_cells(model, topology));
    CHECK(topology.rod_cells[0].radii[0][0] == 0.1);
    CHECK(topology.rod_cells[0].axes[0].angularDistance(Quat::Identity()) == 0.0);
}
