#include "report/report_plan.hpp"

#include <stdexcept>

#include "report/base64.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

DrawnCell make_cell(int start, int end, int source) {
    DrawnCell cell;
    cell.nodes = {start, end};
    cell.axes = {Quat::Identity(), Quat::Identity()};
    cell.radii.assign(cell.nodes.size(), {0.1, 0.1});
    cell.source = source;
    return cell;
}

FrameTopology make_line(int elements) {
    FrameTopology topology;
    topology.nodes = elements + 1;
    topology.cells = elements;
    for (int i = 0; i < elements; ++i) {
        topology.rod_cells.push_back(make_cell(i, i + 1, i));
    }
    return topology;
}

// Elements that cannot be joined: each has its own nodes.
FrameTopology make_heap(int elements) {
    FrameTopology topology;
    topology.nodes = 2 * elements;
    topology.cells = elements;
    for (int i = 0; i < elements; ++i) {
        topology.rod_cells.push_back(make_cell(2 * i, 2 * i + 1, i));
    }
    return topology;
}

ReportContent make_content(const FrameTopology& topology, std::size_t frames, std::size_t steps) {
    ReportContent content;
    content.topology = &topology;
    content.frames = frames;
    content.steps = steps;
    content.columns = 30;
    content.arrows = 2;
    return content;
}

constexpr std::size_t megabyte = 1'000'000;

}  // namespace

TEST_CASE("What fits is kept whole, and nothing is said", "[report]") {
    const FrameTopology topology = make_line(20);
    const ReportPlan plan = plan_report(make_content(topology, 101, 1001), 19 * megabyte);
    CHECK(plan.frame_stride == 1);
    CHECK(plan.steps.keeps_all());
    CHECK(plan.cells.size() == 20);
    CHECK(plan.nodes.size() == 21);
    CHECK(plan.left_out.empty());
}

TEST_CASE("A plan never takes more than its bytes, and keeps the first and last frame", "[report]") {
    for (const int elements : {1, 20, 40000}) {
        const FrameTopology line = make_line(elements);
        const FrameTopology heap = make_heap(elements);
        for (const FrameTopology* topology : {&line, &heap}) {
            for (const std::size_t frames : {1, 2, 101, 20000}) {
                for (const std::size_t steps : {0, 2000000}) {
                    for (const std::size_t bytes : {megabyte / 4, 2 * megabyte, 19 * megabyte}) {
                        const ReportContent content = make_content(*topology, frames, steps);
                        const ReportPlan plan = plan_report(content, bytes);
                        INFO(elements << " elements, " << frames << " frames, " << steps << " steps, "
                                      << bytes);
                        CHECK(count_bytes(plan, content) <= bytes);
                        CHECK(plan.frames(frames).front() == 0);
                        CHECK(plan.frames(frames).back() == frames - 1);
                        CHECK(plan.cells.size() <= 30000);
                    }
                }
            }
        }
    }
}

TEST_CASE("Bodies that are not drawn take no room", "[report]") {
    FrameTopology heap = make_heap(10);
    heap.nodes = 1000000;
    for (int node = 20; node < heap.nodes; ++node) heap.body_nodes.push_back(node);
    ReportContent content = make_content(heap, 100, 100);
    content.marked_nodes = {500, 600};
    CHECK(plan_report(content, megabyte).nodes.size() == 22);
}

TEST_CASE("What touches, and obstacles that move, have their room", "[report][touch]") {
    const FrameTopology line = make_line(20);
    ReportContent content = make_content(line, 20000, 100);
    const std::size_t without = plan_report(content, megabyte).frames(20000).size();
    content.touches = 400;
    content.moved_obstacles = 2;
    const ReportPlan plan = plan_report(content, megabyte);
    CHECK(count_bytes(plan, content) <= megabyte);
    CHECK(plan.frames(20000).size() < without / 2);
    // Of a frame: at most 400 rows, and 2 motions, of seven numbers.
    CHECK(count_bytes(plan, content) > plan.frames(20000).size() * 402 * 7 * sizeof(float) * 4 / 3);
}

TEST_CASE("Shapes that stages have found have their room", "[report]") {
    const FrameTopology line = make_line(5000);
    ReportContent content = make_content(line, 20, 100);
    const ReportPlan without = plan_report(content, 19 * megabyte);
    REQUIRE(without.nodes.size() == 5001);
    const std::size_t bytes = count_bytes(without, content);
    content.shape_vectors = 7;
    // Each takes three numbers of four bytes a node, as base64.
    CHECK(count_bytes(without, content) == bytes + 7 * base64_length(without.nodes.size() * 12));
    content.shape_vectors = 200;
    const ReportPlan with = plan_report(content, 19 * megabyte);
    CHECK(count_bytes(with, content) <= 19 * megabyte);
    CHECK(with.nodes.size() < without.nodes.size());
}

TEST_CASE("Every thinning is reported", "[report]") {
    const FrameTopology small = make_line(20);
    ReportPlan plan = plan_report(make_content(small, 100000, 0), 10 * megabyte);
    REQUIRE(plan.left_out.size() == 1);
    CHECK_THAT(plan.left_out[0], Catch::StartsWith("Of 100000 frames, one in "));

    plan = plan_report(make_content(small, 2, 1000000), 10 * megabyte);
    REQUIRE(plan.left_out.size() == 1);
    CHECK_THAT(plan.left_out[0], Catch::Contains("of 1000000 steps"));

    const FrameTopology line = make_line(100000);
    plan = plan_report(make_content(line, 100, 100), 19 * megabyte);
    CHECK_THAT(plan.left_out.back(), Catch::Contains("100000 elements are drawn as"));
    CHECK(plan.frames(100).size() >= 50);

    const FrameTopology heap = make_heap(100000);
    plan = plan_report(make_content(heap, 100, 100), 19 * megabyte);
    const std::string all = plan.left_out[1] + plan.left_out.back();
    CHECK_THAT(all, Catch::Contains("Of 100000 elements, 30000 pieces"));
    CHECK_THAT(all,
               Catch::Contains("Left out altogether: velocity, angular_velocity, force, moment, strain"));
}

TEST_CASE("Marked nodes stay, statics have no velocities, and too little room is refused", "[report]") {
    const FrameTopology line = make_line(100000);
    ReportContent content = make_content(line, 100, 100);
    content.marked_nodes = {12345, 77777};
    content.is_static = true;
    const ReportPlan plan = plan_report(content, 19 * megabyte);
    CHECK(std::count(plan.nodes.begin(), plan.nodes.end(), 12345) == 1);
    CHECK(std::count(plan.nodes.begin(), plan.nodes.end(), 77777) == 1);
    CHECK(plan.node_data == std::vector<std::string>{"displacement", "rotation_vector"});
    CHECK_THROWS_AS(plan_report(content, 500), std::length_error);
}

TEST_CASE("Stresses of elements are counted, and go with the section forces", "[report]") {
    const FrameTopology topology = make_line(1000);
    ReportContent content = make_content(topology, 101, 101);
    const ReportPlan without = plan_report(content, 19 * megabyte);
    content.cell_scalars = {"von_mises", "exposure"};
    content.has_sections = true;
    const ReportPlan with = plan_report(content, 19 * megabyte);
    CHECK(with.cell_scalars == content.cell_scalars);
    const std::size_t more = 2 * base64_length(101 * 1000 * sizeof(float)) + base64_length(1000 * 4);
    CHECK(count_bytes(with, content) == count_bytes(without, make_content(topology, 101, 101)) + more);
    const std::size_t least = count_bytes(with, content) / 60;
    const ReportPlan small = plan_report(content, least);
    CHECK(count_bytes(small, content) <= least);
    if (small.cell_data.empty()) CHECK(small.cell_scalars.empty());
}
