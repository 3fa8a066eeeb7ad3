#include "results/frame_mesh.hpp"

#include <catch2/catch.hpp>

#include "results/sample.hpp"

using namespace gxrod;

namespace {

// One rod through five nodes, as elements of an order.
Model make_curve(int order) {
    Model model = sample::make_model();
    model.bodies.clear();
    model.nodes.resize(5, model.nodes[0]);
    Rod rod;
    rod.order = order;
    rod.nodes = {0, 1, 2, 3, 4};
    set_line_elements(rod, {0.0, 1.0, 2.0, 3.0, 4.0}, std::vector<Quat>(5, Quat::Identity()));
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
    FrameMesh mesh = make_frame_mesh(make_curve(2));
    CHECK(mesh.connectivity == std::vector<std::int64_t>{0, 2, 1, 2, 4, 3});
    CHECK(mesh.types == std::vector<std::uint8_t>{21, 21});
    mesh = make_frame_mesh(make_curve(4));
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

TEST_CASE("The equivalent radius of a solid circle is its radius", "[results]") {
    const double radius = 0.02, E = 2e11, area = M_PI * radius * radius,
                 second_moment = area * radius * radius / 4;
    Section section{"circle", Mat6::Zero(), Mat6::Zero()};
    section.stiffness.diagonal() << E * area, 1, 1, 1, E * second_moment, E * second_moment;
    CHECK(equivalent_radius(section) == Approx(radius).epsilon(1e-14));
    section.stiffness(0, 0) = 0.0;
    CHECK(equivalent_radius(section) == 0.0);
}
