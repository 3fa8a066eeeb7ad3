#include "results/tables/frame_mesh.hpp"

#include <numeric>

#include "results/sample.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

// One rod of elements of an order through 0, 1, … nodes − 1.
Model make_curve(int order, std::size_t nodes) {
    Model model = sample::make_model();
    model.bodies.clear();
    model.nodes.resize(nodes, model.nodes[0]);
    Rod rod;
    rod.order = order;
    rod.nodes.resize(nodes);
    std::iota(rod.nodes.begin(), rod.nodes.end(), 0);
    set_line_elements(rod, {rod.nodes.begin(), rod.nodes.end()}, std::vector<Quat>(nodes, Quat::Identity()));
    model.rods = {rod};
    return model;
}

}  // namespace

TEST_CASE("Frames have a line for each element and a vertex for each body", "[results]") {
    const FrameMesh mesh = make_frame_mesh(sample::make_model());
    CHECK(mesh.connectivity == std::vector<std::int64_t>{0, 1, 1, 2, 2, 3});
    CHECK(mesh.offsets == std::vector<std::int64_t>{0, 2, 4, 5, 6});
    CHECK(mesh.types == std::vector<std::uint8_t>{3, 3, 1, 1});
}

TEST_CASE("Elements of higher order become VTK's curves, the ends first", "[results]") {
    FrameMesh mesh = make_frame_mesh(make_curve(2, 5));
    CHECK(mesh.connectivity == std::vector<std::int64_t>{0, 2, 1, 2, 4, 3});
    CHECK(mesh.types == std::vector<std::uint8_t>{21, 21});
    mesh = make_frame_mesh(make_curve(3, 4));
    CHECK(mesh.connectivity == std::vector<std::int64_t>{0, 3, 1, 2});
    CHECK(mesh.types == std::vector<std::uint8_t>{68});
    mesh = make_frame_mesh(make_curve(4, 5));
    CHECK(mesh.connectivity == std::vector<std::int64_t>{0, 4, 1, 2, 3});
    CHECK(mesh.offsets == std::vector<std::int64_t>{0, 5});
    CHECK(mesh.types == std::vector<std::uint8_t>{68});
}

TEST_CASE("A node carries the axes of its first rod, else those of its body", "[results]") {
    const Model model = sample::make_model();
    const FrameMesh mesh = make_frame_mesh(model);
    CHECK(mesh.triads[2].coeffs() == model.rods[0].triad_at(2).coeffs());
    CHECK(mesh.triads[3].coeffs() == model.bodies[1].attitude.coeffs());
}

TEST_CASE("Cells and nodes of rods carry a radius, bodies do not", "[results]") {
    Model model = sample::make_model();
    model.sections.push_back(model.sections[0]);
    model.sections[1].stiffness(0, 0) *= 4.0;
    model.rods.push_back(model.rods[0]);  // where two rods meet, the first counts
    model.rods[1].section = 1;
    const FrameMesh mesh = make_frame_mesh(model);
    const double radius = equivalent_radius(model.sections[0]);
    CHECK(mesh.cell_radius == std::vector<double>{radius, radius, radius / 2, radius / 2, 0, 0});
    CHECK(mesh.point_radius == std::vector<double>{radius, radius, radius, 0});
}

TEST_CASE("The equivalent radius of a solid circle is its radius", "[results]") {
    const double radius = 0.02, E = 2e11, area = M_PI * radius * radius,
                 second_moment = area * radius * radius / 4;
    Section section{"circle", Mat6::Zero(), Mat6::Zero()};
    section.stiffness.diagonal() << E * area, 1, 1, 1, E * second_moment, E * second_moment;
    CHECK(equivalent_radius(section) == Approx(radius).epsilon(1e-14));
    section.stiffness(0, 0) = 0.0;
    CHECK(equivalent_radius(section) == 0.0);
}
