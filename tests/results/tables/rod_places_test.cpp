#include "results/tables/rod_places.hpp"

#include "results/sample.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

using Numbers = std::vector<std::int64_t>;

// A rod of two elements of order 3 from node 4 to 10, with inner nodes where they may be, beside the sample's
// rod (nodes 0, 1, 2), from whose end it branches off: node 2 comes first.
Model make_branched() {
    Model model = sample::make_model();
    for (int i = 4; i < 11; ++i) model.nodes.push_back(model.nodes.front());
    Rod branch;
    branch.name = "branch";
    branch.order = 3;
    branch.nodes = {2, 4, 5, 6, 7, 8, 9};
    set_line_elements(branch, {0.0, 0.3, 0.7, 1.0, 1.6, 2.4, 3.0}, std::vector(7, Quat::Identity()));
    model.rods.push_back(branch);
    return model;
}

}  // namespace

TEST_CASE("Cells lie on their rods at the middles of elements, bodies on no rod", "[results]") {
    const RodPlaces cells = find_cell_places(make_branched());
    CHECK(cells.rod == Numbers{0, 0, 1, 1, -1, -1});
    CHECK(cells.element == Numbers{0, 1, 0, 1, -1, -1});
    CHECK(cells.arc_length == std::vector{0.5, 1.5, 0.5, 2.0, 0.0, 0.0});
}

TEST_CASE("Points lie on the first rod there", "[results]") {
    const RodPlaces points = find_point_places(make_branched());
    CHECK(points.rod == Numbers{0, 0, 0, -1, 1, 1, 1, 1, 1, 1, -1});
    CHECK(points.element == Numbers{0, 0, 1, -1, 0, 0, 0, 1, 1, 1, -1});
    CHECK(points.arc_length == std::vector{0.0, 1.0, 2.0, 0.0, 0.3, 0.7, 1.0, 1.6, 2.4, 3.0, 0.0});
}

TEST_CASE("Where rods meet, each has its own arc length", "[results]") {
    // The two ends of an element first, as in Connectivity; then the two bodies.
    CHECK(list_arc_lengths(make_branched()) ==
          std::vector{0.0, 1.0, 1.0, 2.0, 0.0, 1.0, 0.3, 0.7, 1.0, 3.0, 1.6, 2.4, 0.0, 0.0});
}
