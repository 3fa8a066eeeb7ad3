#include "mesh/sections/section_mesher.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <map>
#include <random>

#include "cross_section/outlines/outline_examination.hpp"
#include "cross_section/outlines/outline_moments.hpp"
#include "cross_section/profiles/profile_shape.hpp"
#include "mesh/line_mesh.hpp"
#include "mesh/sections/plane_triangles.hpp"
#include "numerics/gauss_legendre.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// Lagrange's polynomials of a triangle on the even lattice, as monomials: Vandermonde's matrix.
Eigen::VectorXd evaluate_monomials(int order, double r, double s) {
    Eigen::VectorXd values(count_nodes(CellShape::triangle, order));
    int k = 0;
    for (int j = 0; j <= order; ++j)
        for (int i = 0; i <= order - j; ++i) values[k++] = std::pow(r, i) * std::pow(s, j);
    return values;
}

Eigen::MatrixXd invert_lattice(int order) {
    const int count = count_nodes(CellShape::triangle, order);
    Eigen::MatrixXd values(count, count);
    int k = 0;
    for (int j = 0; j <= order; ++j)
        for (int i = 0; i <= order - j; ++i)
            values.row(k++) = evaluate_monomials(order, double(i) / order, double(j) / order);
    return values.inverse();
}

std::vector<std::pair<std::string, ProfileShape>> samples() {
    return {{"IPE 200", IShape{200, 100, 5.6, 8.5, 12}},
            {"sharp I", IShape{200, 100, 5.6, 8.5}},
            {"UPN 140",
             ChannelShape{
                 .height = 140, .width = 60, .web = 7, .flange = 10, .fillet = 10, .toe = 5, .slope = 0.08}},
            {"L", AngleShape{100, 100, 10, 12, 6}},
            {"SHS", BoxShape{100, 100, 5, 5, 10, 5}},
            {"T", TeeShape{100, 100, 10, 10, 8}},
            {"hat", HatShape{60, 50, 20, 3, 3}},
            {"CHS", HollowCircle{114.3, 5}}};
}

struct MeshMoments {
    OutlineMoments moments;
    double least_determinant = INFINITY;  // over that of the triangle's corners
};

// The shape functions of a triangle and their slopes at a quadrature point.
struct ShapePoint {
    Eigen::VectorXd values, by_r, by_s;
    double weight;
};

std::vector<ShapePoint> list_shape_points(int order) {
    constexpr double step = 1e-6;
    const auto rule = compute_gauss_rule<8>();
    const Eigen::MatrixXd lattice = invert_lattice(order).transpose();
    const auto at = [&](double r, double s) -> Eigen::VectorXd {
        return lattice * evaluate_monomials(order, r, s);
    };
    std::vector<ShapePoint> points;
    for (const auto& [xi, wi] : rule) {
        for (const auto& [eta, we] : rule) {
            const double s = 0.5 * (1 + eta), r = 0.5 * (1 + xi) * (1 - s);
            points.push_back({at(r, s),
                              (at(r + step, s) - at(r - step, s)) / (2 * step),
                              (at(r, s + step) - at(r, s - step)) / (2 * step),
                              0.25 * wi * we * (1 - s)});
        }
    }
    return points;
}

// Area and moments by quadrature of the map of every cell.
MeshMoments integrate(const SectionMesh& mesh) {
    const int order = mesh.cells.front().order;
    const std::vector<ShapePoint> points = list_shape_points(order);
    MeshMoments found;
    double area = 0, y = 0, z = 0, yy = 0, zz = 0, yz = 0;
    for (const SectionCell& cell : mesh.cells) {
        Eigen::Matrix2Xd nodes(2, cell.nodes.size());
        for (std::size_t i = 0; i < cell.nodes.size(); ++i) nodes.col(i) = mesh.nodes[cell.nodes[i]];
        const PlanePoint a = nodes.col(0), b = nodes.col(order), c = nodes.col(nodes.cols() - 1);
        const double straight = cross(b - a, c - a);
        if (straight <= 0.0) found.least_determinant = -1.0;
        for (const ShapePoint& point : points) {
            const double determinant = cross(nodes * point.by_r, nodes * point.by_s);
            const double weight = point.weight * determinant;
            found.least_determinant = std::min(found.least_determinant, determinant / straight);
            const PlanePoint p = nodes * point.values;
            area += weight;
            y += weight * p.x();
            z += weight * p.y();
            yy += weight * p.x() * p.x();
            zz += weight * p.y() * p.y();
            yz += weight * p.x() * p.y();
        }
    }
    found.moments = {area, {y / area, z / area}, zz - z * z / area, yy - y * y / area, yz - y * z / area};
    return found;
}

}  // namespace

TEST_CASE("Meshes of profiles have the area and the moments of the outline", "[mesh]") {
    const auto [order, tolerance] = GENERATE(std::pair(2, 1e-5), std::pair(3, 1e-6), std::pair(4, 1e-8));
    for (const auto& [name, shape] : samples()) {
        INFO(name << " of order " << order);
        const Outline outline = draw_outline(shape);
        const SectionMesh mesh = mesh_outline(outline, name, order);
        const auto [found, least] = integrate(mesh);
        const OutlineMoments exact = compute_moments(outline);
        CHECK(least > 0.8);
        CHECK(found.area == Approx(exact.area).epsilon(tolerance));
        CHECK(found.Iy == Approx(exact.Iy).epsilon(tolerance));
        CHECK(found.Iz == Approx(exact.Iz).epsilon(tolerance));
        CHECK(found.Iyz == Approx(exact.Iyz).epsilon(tolerance).margin(tolerance * exact.Iz));
        CHECK((found.centroid - exact.centroid).norm() < tolerance * 100.0);
        CHECK(mesh.layers.size() == 1);
        CHECK(mesh.layers[0].name == name);
    }
}

TEST_CASE("Cells of a section's mesh share nodes, and every node belongs to one", "[mesh]") {
    const SectionMesh mesh = mesh_outline(draw_outline(BoxShape{100, 100, 5, 5, 10, 5}), "box");
    std::vector<int> uses(mesh.nodes.size(), 0);
    std::map<std::pair<int, int>, int> sides;
    for (const SectionCell& cell : mesh.cells) {
        REQUIRE(cell.order == 3);
        REQUIRE(cell.nodes.size() == 10);
        for (const int node : cell.nodes) ++uses[static_cast<std::size_t>(node)];
        const int corners[] = {cell.nodes[0], cell.nodes[3], cell.nodes[9]};
        for (int k = 0; k < 3; ++k) ++sides[std::minmax(corners[k], corners[(k + 1) % 3])];
    }
    CHECK(*std::ranges::min_element(uses) > 0);
    // Euler: a plane area with one hole.
    const auto inner = std::ranges::count_if(sides, [](const auto& side) { return side.second == 2; });
    const auto outer = std::ranges::count_if(sides, [](const auto& side) { return side.second == 1; });
    CHECK(static_cast<std::size_t>(inner + outer) == sides.size());
    const auto cells = static_cast<long>(mesh.cells.size());
    CHECK(3 * cells == 2 * inner + outer);
    CHECK(static_cast<long>(mesh.nodes.size()) == cells + 2 * (inner + outer) + (inner + outer - cells));
}

TEST_CASE("Nodes on arcs lie on them", "[mesh]") {
    const double outer = 57.15, inner = 52.15;
    const SectionMesh mesh = mesh_outline(draw_outline(HollowCircle{2 * outer, outer - inner}), "ring", 4);
    const auto count = [&](double radius) {
        return std::ranges::count_if(
            mesh.nodes, [&](const PlanePoint& at) { return std::abs(at.norm() - radius) < 1e-12 * radius; });
    };
    // Four nodes an edge, whose length is half of the wall, a little less.
    CHECK(count(outer) == 4 * 144);
    CHECK(count(inner) == 4 * 132);
    CHECK(std::ranges::max(mesh.nodes, {}, &PlanePoint::norm).norm() < outer * (1 + 1e-12));
    CHECK(std::ranges::min(mesh.nodes, {}, &PlanePoint::norm).norm() > inner * (1 - 1e-12));
}

TEST_CASE("Re-entrant corners without a radius are named and have small elements", "[mesh]") {
    const SectionMesh sharp = mesh_outline(draw_outline(IShape{200, 100, 5.6, 8.5}), "I");
    REQUIRE(sharp.sharp_corners.size() == 4);
    for (const SharpCorner& corner : sharp.sharp_corners) {
        CHECK(corner.reach == Approx(0.5 * 5.6));
        CHECK(std::abs(corner.at.x()) == Approx(2.8));
        CHECK(std::abs(corner.at.y()) == Approx(91.5));
        double nearest = INFINITY;
        for (const SectionCell& cell : sharp.cells)
            for (const int i : {0, 3, 9}) {
                const double distance =
                    (sharp.nodes[static_cast<std::size_t>(cell.nodes[i])] - corner.at).norm();
                if (distance > 0.0) nearest = std::min(nearest, distance);
            }
        CHECK(nearest < 0.04 * 5.6);
    }
    CHECK(mesh_outline(draw_outline(IShape{200, 100, 5.6, 8.5, 12}), "I").sharp_corners.empty());
    CHECK(mesh_outline(draw_outline(BoxShape{100, 80, 5, 5}), "box").sharp_corners.size() == 4);
}

TEST_CASE("Sizes follow the local thickness, at most a fifth of the least extent", "[mesh]") {
    const SectionMesh block = mesh_outline(draw_outline({{{{0, 0}}, {{1, 0}}, {{1, 1}}, {{0, 1}}}}), "block");
    CHECK(block.cells.size() >= 50);
    CHECK(block.cells.size() < 80);
    // A block with a thin fin.
    const Polygon finned{{{{0, 0}},
                          {{10, 0}},
                          {{10, 4.95}, 0.2},
                          {{20, 4.95}},
                          {{20, 5.05}},
                          {{10, 5.05}, 0.2},
                          {{10, 10}},
                          {{0, 10}}}};
    const SectionMesh mesh = mesh_outline(draw_outline(finned), "fin");
    const auto count = [&](double from, double to) {
        return std::ranges::count_if(mesh.cells, [&](const SectionCell& cell) {
            const double y = mesh.nodes[static_cast<std::size_t>(cell.nodes[0])].x();
            return y >= from && y < to;
        });
    };
    CHECK(count(0, 8) < 150);
    CHECK(count(11, 20) > 250);
}

TEST_CASE("A curve by many points has no sharp corners", "[mesh]") {
    Polygon star;
    for (int i = 0; i < 120; ++i) {
        const double angle = 2 * M_PI * i / 120, radius = 1 + 0.3 * std::cos(3 * angle);
        star.outer.push_back({{radius * std::cos(angle), radius * std::sin(angle)}});
    }
    const SectionMesh mesh = mesh_outline(draw_outline(star), "star");
    CHECK(mesh.sharp_corners.empty());
    CHECK(mesh.cells.size() < 4000);
}

TEST_CASE("Meshes of random polygons have the area of the outline, and no cell with a flat corner",
          "[mesh]") {
    std::mt19937 random(7);
    const auto draw = [&](double least, double greatest) {
        return std::uniform_real_distribution(least, greatest)(random);
    };
    int meshed = 0;
    for (int k = 0; k < 20; ++k) {
        const int corners = 4 + k % 8;
        Polygon polygon;
        for (int i = 0; i < corners; ++i) {
            const double angle = 2 * M_PI * (i + draw(0, 0.6)) / corners, radius = draw(0.1, 1.1);
            const double rounding = i % 2 == 0 ? 0.2 * draw(0, 1) * draw(0, 1) : 0.0;
            polygon.outer.push_back({{radius * std::cos(angle), radius * std::sin(angle)}, rounding});
        }
        if (k % 3 == 0) polygon.holes = {{{{0.05, 0}, 0.01}, {{0, 0.05}}, {{-0.05, 0}}, {{0, -0.05}, 0.02}}};
        if (find_fault(polygon)) continue;
        INFO("polygon " << k);
        const Outline outline = draw_outline(polygon);
        const auto [found, least] = integrate(mesh_outline(outline, "random"));
        CHECK(found.area == Approx(compute_moments(outline).area).epsilon(1e-6));
        CHECK(least > 0.5);
        ++meshed;
    }
    CHECK(meshed > 8);
}

TEST_CASE("A shape that takes too many triangles is refused", "[mesh]") {
    const auto strip = [](double length, double thickness) {
        return draw_outline({{{{0, 0}}, {{length, 0}}, {{length, thickness}}, {{0, thickness}}}});
    };
    CHECK_THROWS_WITH(mesh_outline(strip(0.1, 1e-9), "strip"),
                      "has more than 6000 edges of triangles around it: it is 1e-09 thick somewhere, and 0.1 "
                      "across; draw thin "
                      "parts as a rectangle, walls or a mesh, whose cells are long");
    CHECK_THROWS_WITH(
        mesh_outline(strip(100, 0.05), "strip"),
        Catch::StartsWith(
            "has more than 6000 edges of triangles around it: it is 0.05 thick somewhere, and 100 across"));
    CHECK(mesh_outline(strip(100, 2), "strip").cells.size() < 4000);
}

TEST_CASE("The same outline has the same mesh", "[mesh]") {
    const Outline outline = draw_outline(AngleShape{100, 100, 10, 12, 6});
    const SectionMesh one = mesh_outline(outline, "L"), other = mesh_outline(outline, "L");
    REQUIRE(one.nodes.size() == other.nodes.size());
    for (std::size_t i = 0; i < one.nodes.size(); ++i) CHECK(one.nodes[i] == other.nodes[i]);
    REQUIRE(one.cells.size() == other.cells.size());
    for (std::size_t i = 0; i < one.cells.size(); ++i) CHECK(one.cells[i].nodes == other.cells[i].nodes);
}

TEST_CASE("Units and the place do not change a mesh", "[mesh]") {
    const SectionMesh mm = mesh_outline(draw_outline(TeeShape{100, 100, 10, 10, 8}), "T");
    const SectionMesh m = mesh_outline(draw_outline(TeeShape{0.1, 0.1, 0.01, 0.01, 0.008}), "T");
    const SectionMesh km = mesh_outline(draw_outline(TeeShape{1e-4, 1e-4, 1e-5, 1e-5, 8e-6}), "T");
    CHECK(m.cells.size() == mm.cells.size());
    CHECK(km.cells.size() == mm.cells.size());
    const Outline away = move_outline(draw_outline(TeeShape{100, 100, 10, 10, 8}), {1e5, -1e5});
    CHECK(mesh_outline(away, "T").cells.size() == mm.cells.size());
}

TEST_CASE("Gmsh's message of an area that it cannot mesh is an error", "[mesh]") {
    const PlaneLoop bow{.corners = {{0, 0}, {1, 1}, {1, 0}, {0, 1}}, .sizes = {1, 1, 1, 1}};
    CHECK_THROWS_AS(mesh_area({bow}), MeshError);
}

}  // namespace gxrod::test
