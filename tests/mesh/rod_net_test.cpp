#include "mesh/rod_net.hpp"

#include <cmath>

#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// Points of y = x² at equal distances of x from 0 to 1, elements of an order through them.
LineMesh make_parabola(int order, int elements) {
    LineMesh mesh;
    const int steps = order * elements;
    for (int i = 0; i <= steps; ++i) {
        const double x = static_cast<double>(i) / steps;
        mesh.positions.emplace_back(x, x * x, 0.0);
    }
    MeshLines lines{1, "curve", {order}, {}};
    for (int e = 0; e < elements; ++e) {
        for (int i = 0; i <= order; ++i) lines.nodes.push_back(static_cast<std::size_t>(e * order + i));
    }
    mesh.lines = {lines};
    return mesh;
}

RodNet net_of(const LineMesh& mesh) { return make_rod_net(mesh, mesh.lines[0]); }

double parabola_length(double x) {
    const double slope = 2.0 * x;
    return 0.25 * (slope * std::sqrt(1.0 + slope * slope) + std::asinh(slope));
}

}  // namespace

TEST_CASE("A net has the nodes of its elements once, in the order of its chains", "[mesh]") {
    LineMesh mesh;
    mesh.positions = {Vec3(9, 9, 9), Vec3(2, 0, 0), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0)};
    // A T: from 2 over 3 to 1, and from 3 up to 4. Position 0 is of no element.
    mesh.lines = {{1, "", {1}, {2, 3, 3, 1, 3, 4}}};
    const RodNet net = net_of(mesh);
    CHECK(net.order == 1);
    CHECK(net.mesh_nodes == std::vector<std::size_t>{2, 3, 1, 4});
    REQUIRE(net.positions.size() == 4);
    CHECK(net.positions[2] == Vec3(2, 0, 0));
    REQUIRE(net.chains.size() == 3);
    CHECK(net.length() == Approx(3.0).epsilon(1e-15));
    CHECK_FALSE(net.is_line());
    // From its free end to the branch.
    CHECK(net.chains[1].elements[0].nodes == std::vector<int>{2, 1});
    CHECK(net.chains[1].elements[0].start_tangent == Vec3(-1, 0, 0));
}

TEST_CASE("A line has fractions of its length at its nodes, whatever the order", "[mesh]") {
    for (int order = 1; order <= 3; ++order) {
        LineMesh mesh;
        for (int i = 0; i <= 2 * order; ++i) mesh.positions.emplace_back(3.0 * i, 4.0 * i, 0.0);
        MeshLines lines{1, "", {order}, {}};
        // The second element first, and the wrong way round.
        for (int i = 2 * order; i >= order; --i) lines.nodes.push_back(static_cast<std::size_t>(i));
        for (int i = order; i >= 0; --i) lines.nodes.push_back(static_cast<std::size_t>(i));
        const RodNet net = make_rod_net(mesh, lines);
        REQUIRE(net.is_line());
        const std::vector<double> fractions = net.fractions();
        REQUIRE(fractions.size() == static_cast<std::size_t>(2 * order) + 1);
        CHECK(fractions.front() == 0.0);
        CHECK(fractions.back() == 1.0);
        CHECK(net.positions.front() == Vec3(6.0 * order, 8.0 * order, 0));
        for (std::size_t i = 0; i < fractions.size(); ++i) {
            const Vec3 expected = (1.0 - fractions[i]) * net.positions.front();
            CHECK((net.positions[i] - expected).norm() < 1e-14);
        }
        if (order == 3) CHECK(fractions[1] == Approx(0.25 * (1.0 - std::sqrt(0.2))).epsilon(1e-14));
    }
}

TEST_CASE("Inner nodes of cubic elements move to Gauss-Lobatto points on their polynomial", "[mesh]") {
    const RodNet net = net_of(make_parabola(3, 2));
    REQUIRE(net.positions.size() == 7);
    // The polynomial through points of a parabola is the parabola, its parameter x.
    const double inner = 0.5 * (1.0 - std::sqrt(0.2));
    const std::vector<double> x{
        0.0, 0.5 * inner, 0.5 - 0.5 * inner, 0.5, 0.5 + 0.5 * inner, 1.0 - 0.5 * inner, 1.0};
    for (std::size_t i = 0; i < 7; ++i) CHECK((net.positions[i] - Vec3(x[i], x[i] * x[i], 0)).norm() < 1e-14);
    const NetElement& second = net.chains[0].elements[1];
    for (std::size_t i = 0; i < 4; ++i) {
        const double at = x[i + 3];
        CHECK(second.arc_length[i] == Approx(parabola_length(at) - parabola_length(0.5)).margin(1e-15));
        const double turn = std::atan(2.0 * at) - std::atan(1.0);
        CHECK((second.transports[i] * second.start_tangent -
               Vec3(std::cos(turn + M_PI / 4), std::sin(turn + M_PI / 4), 0))
                  .norm() < 1e-14);
    }
    CHECK((second.end_tangent - Vec3(1, 2, 0).normalized()).norm() < 1e-14);
    CHECK(net.length() == Approx(parabola_length(1.0)).epsilon(1e-14));
}

TEST_CASE("Middle nodes of quadratic elements stay where the mesh has them", "[mesh]") {
    LineMesh mesh;
    mesh.positions = {Vec3(0, 0, 0), Vec3(0.6, 0.1, 0), Vec3(1, 0, 0)};
    mesh.lines = {{1, "", {2}, {0, 1, 2}}};
    CHECK(net_of(mesh).positions[1] == Vec3(0.6, 0.1, 0));
}

TEST_CASE("Elements without length, onto themselves or folded are refused", "[mesh]") {
    LineMesh mesh;
    mesh.positions = {Vec3(1, 2, 3), Vec3(1, 2, 3), Vec3(2, 2, 3), Vec3(4, 2, 3)};
    mesh.lines = {{1, "", {1}, {0, 1}}};
    CHECK_THROWS_WITH(net_of(mesh), "the element at (1, 2, 3) has no length");
    mesh.lines = {{1, "", {1}, {2, 2}}};
    CHECK_THROWS_WITH(net_of(mesh), "the element at (2, 2, 3) ends where it starts");
    mesh.lines = {{1, "", {2}, {0, 3, 2}}};
    CHECK_THROWS_WITH(net_of(mesh), "the element at (1, 2, 3) turns back on itself");
}

}  // namespace gxrod::test
