#include "mesh/triangles/triangle_examination.hpp"

#include <algorithm>
#include <cmath>

#include "contact/meshes.hpp"
#include "mesh/triangles/stl_file.hpp"
#include "report/model/mesh_picture.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

TEST_CASE("A closed mesh has the area and volume of its solid", "[mesh]") {
    TriangleMesh cube = make_cube(2.0);
    for (Vec3& position : cube.positions) position += Vec3(100.0, -3.0, 7.0);
    const TriangleExamination found = examine_triangles(cube);
    CHECK(found.area == Approx(24.0).epsilon(1e-14));
    REQUIRE(found.volume);
    CHECK(*found.volume == Approx(8.0).epsilon(1e-12));
    CHECK(found.low == Vec3(99.0, -4.0, 6.0));
    CHECK(found.high == Vec3(101.0, -2.0, 8.0));
    CHECK(found.parts == 1);
    CHECK(found.least_side == 2.0);
    CHECK(found.greatest_side == Approx(2.0 * std::sqrt(2.0)));
    CHECK(found.greatest_turn == Approx(M_PI / 2.0));
    CHECK(found.sharp_edges == 12);
    CHECK(found.is_closed());
    CHECK(found.holes.empty());
    CHECK(found.flipped.empty());
}

TEST_CASE("A prism about a circle has its area and volume", "[mesh]") {
    constexpr int facets = 24;
    const TriangleExamination found = examine_triangles(make_cylinder(0.5, -1.0, 2.0, facets, 3));
    CHECK(found.area == Approx(facets * 2.0 * 0.5 * std::sin(M_PI / facets) * 3.0).epsilon(1e-12));
    CHECK_FALSE(found.volume);  // without ends
    REQUIRE(found.holes.size() == 2);
    for (const MeshHole& hole : found.holes) {
        CHECK(hole.edges == facets);
        CHECK(hole.length == Approx(facets * 2.0 * 0.5 * std::sin(M_PI / facets)).epsilon(1e-12));
        CHECK(hole.middle.head<2>().norm() < 1e-12);
    }
    CHECK(std::min(found.holes[0].middle.z(), found.holes[1].middle.z()) == Approx(-1.0));
    CHECK(found.open_edges.size() == 2 * facets);
    CHECK(found.greatest_turn == Approx(2.0 * M_PI / facets));
}

TEST_CASE("Facets the other way around are found, whichever comes first", "[mesh]") {
    for (const std::size_t turned : {0UL, 5UL, 11UL}) {
        TriangleMesh cube = make_cube(1.0);
        std::swap(cube.triangles[turned][0], cube.triangles[turned][1]);
        const TriangleExamination found = examine_triangles(cube);
        CHECK(found.flipped == std::vector<int>{static_cast<int>(turned) + 1});
        REQUIRE(found.volume);
        CHECK(*found.volume == Approx(1.0));
        CHECK(found.sharp_edges == 12);  // corners in any order
        CHECK(found.greatest_turn == Approx(M_PI / 2.0));
    }
}

TEST_CASE("Parts, crowded edges and missing facets are counted", "[mesh]") {
    TriangleMesh two = make_cube(1.0);
    const TriangleMesh other = make_cube(0.5);
    for (const std::array<int, 3>& corners : other.triangles)
        two.triangles.push_back({corners[0] + 8, corners[1] + 8, corners[2] + 8});
    for (const Vec3& position : other.positions) two.positions.push_back(position + Vec3(3.0, 0.0, 0.0));
    two.numbers.clear();
    number(two);
    TriangleExamination found = examine_triangles(two);
    CHECK(found.parts == 2);
    REQUIRE(found.volume);
    CHECK(*found.volume == Approx(1.125));

    two.triangles.pop_back();
    two.numbers.pop_back();
    found = examine_triangles(two);
    CHECK_FALSE(found.volume);
    REQUIRE(found.holes.size() == 1);
    CHECK(found.holes[0].edges == 3);

    TriangleMesh fins = make_floor(1.0, 1);
    add_position({0.0, 0.0, 1.0}, fins);
    fins.triangles.push_back({0, 3, 4});
    fins.numbers.push_back(3);
    found = examine_triangles(fins);
    CHECK(found.crowded_edges == 1);
    CHECK_FALSE(found.is_closed());
    CHECK(found.parts == 1);
}

TEST_CASE("A text whose last solid does not end is found", "[mesh]") {
    const std::string facet =
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
        "endloop\nendfacet\n";
    CHECK(lacks_end_of_stl("solid a\n" + facet));
    CHECK_FALSE(lacks_end_of_stl("solid a\n" + facet + "endsolid a\n"));
    CHECK_FALSE(lacks_end_of_stl("SOLID solid\n" + facet + "EndSolid solid\n"));
    CHECK(lacks_end_of_stl("solid a\n" + facet + "endsolid a\nsolid b\n" + facet));
    std::string bytes(84, ' ');
    bytes.replace(0, 5, "solid");
    std::fill(bytes.begin() + 80, bytes.end(), '\0');
    CHECK_FALSE(lacks_end_of_stl(bytes));
}

TEST_CASE("A mesh is drawn from three sides, with its open edges", "[mesh]") {
    const TriangleMesh floor = make_floor(1.0, 2);
    const std::string picture = draw_mesh(floor, examine_triangles(floor));
    const auto count = [&](const std::string& text) {
        std::size_t found = 0;
        for (std::size_t at = picture.find(text); at != std::string::npos; at = picture.find(text, at + 1))
            ++found;
        return found;
    };
    CHECK(count("<polygon") == 3 * 8);
    CHECK(count("<polyline") == 3 * 8);
    CHECK(picture.find("points=\"30.00,330.00") != std::string::npos);  // the corner at -1, -1 from above
    CHECK(picture.ends_with("</svg>\n"));
}
