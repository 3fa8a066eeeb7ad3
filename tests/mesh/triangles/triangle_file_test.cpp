#include "mesh/triangles/triangle_file.hpp"

#include <cstring>

#include "deck/decks.hpp"
#include "mesh/line_mesh.hpp"
#include "mesh/triangles/stl_file.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

std::string stl_bytes(const std::vector<std::array<float, 9>>& triangles) {
    std::string bytes = "solid though it is not text";
    bytes.resize(80, '\0');
    const auto add = [&](const auto& value) {
        bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
    };
    add(static_cast<std::uint32_t>(triangles.size()));
    for (const std::array<float, 9>& corners : triangles) {
        add(std::array<float, 3>{});
        add(corners);
        add(std::uint16_t{0});
    }
    return bytes;
}

const char* const msh = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
5
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 2 0 1
$EndNodes
$Elements
3
1 15 2 0 1 1
2 3 2 0 1 1 2 3 4
3 2 2 0 1 2 5 3
$EndElements
)";

}  // namespace

TEST_CASE("STL is read as text and as bytes", "[mesh]") {
    const std::vector<Corners> text = read_stl(
        "solid a b c\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\r\n vertex 1e0 0 0\n vertex 0 +2.5 "
        "0\n"
        "  endloop\n endfacet\nendsolid a\nSOLID\nFACET NORMAL 0 0 0 OUTER LOOP VERTEX 1 2 3 VERTEX 4 5 6 "
        "VERTEX 7 8 "
        "10 ENDLOOP ENDFACET\nENDSOLID\n");
    REQUIRE(text.size() == 2);
    CHECK(text[0][2] == Vec3(0, 2.5, 0));
    CHECK(text[1][2] == Vec3(7, 8, 10));
    const std::string bytes = stl_bytes({{0, 0, 0, 1, 0, 0, 0, 2.5, 0}, {1, 2, 3, 4, 5, 6, 7, 8, 10}});
    CHECK(read_stl(bytes) == text);
    CHECK_THROWS_AS(read_stl(bytes.substr(0, bytes.size() - 1)), MeshError);
    CHECK_THROWS_AS(read_stl(stl_bytes({{0, 0, 0, 1, 0, 0, 0, NAN, 0}})), MeshError);
    CHECK(read_stl(stl_bytes({})).empty());
}

TEST_CASE("Triangles that share corners are joined", "[mesh]") {
    const ScratchFile file("a.stl",
                           stl_bytes({{0, 0, 0, 1, 0, 0, 1, 1, 0}, {-0.0F, 0, 0, 1, 1, 0, 0, 1, 0}}));
    const TriangleMesh mesh = read_triangle_mesh(file.path(), 0.5);
    CHECK(mesh.positions.size() == 4);
    CHECK(mesh.positions[2] == Vec3(0.5, 0.5, 0));
    CHECK(mesh.open_edges == 4);
    CHECK(mesh.left_out == 0);
}

TEST_CASE("Triangles and quadrangles of Gmsh are read, and cut", "[mesh]") {
    const ScratchFile file("a.msh", msh);
    const TriangleMesh mesh = read_triangle_mesh(file.path(), 1.0);
    CHECK(mesh.positions.size() == 5);
    CHECK(mesh.triangles.size() == 3);
    CHECK(mesh.open_edges == 5);
}

}  // namespace gxrod::test
