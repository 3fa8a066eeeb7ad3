#include "mesh/sections/section_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include "cross_section/examination/mesh_examination.hpp"
#include "cross_section/section_quadrature.hpp"
#include "deck/decks.hpp"
#include "mesh/line_mesh.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using std::numbers::pi;

// A circle of radius 1 in two groups of surfaces, "ring" around "core" of radius ½, by Gmsh; the curve around
// it is "outline". The quadrangles of order 2 have 8 nodes, and the core is walked clockwise where the order
// is 2.
SurfaceMesh read_circle(const std::string& shape, int order) {
    const std::filesystem::path folder = std::filesystem::path(GXROD_SOURCE_DIR) / "tests/mesh/section_files";
    return read_surface_mesh(folder / fmt::format("ring_{}_{}.msh", shape, order));
}

int find_group(const SurfaceMesh& mesh, const std::string& name) {
    const auto found = std::ranges::find(mesh.groups, name, &SurfaceGroup::name);
    REQUIRE(found != mesh.groups.end());
    return static_cast<int>(found - mesh.groups.begin());
}

SectionMesh make_circle_section(const SurfaceMesh& mesh, double scale) {
    return make_section_mesh(mesh,
                             scale,
                             {{.group = find_group(mesh, "core"), .name = "core", .material = 1},
                              {.group = find_group(mesh, "ring"),
                               .name = "ring",
                               .fibre_angle = 0.3,
                               .wall = find_group(mesh, "outline")}});
}

// The areas of two layers.
Eigen::Vector2d compute_areas(const SectionMesh& mesh) {
    const std::vector<ElasticMaterial> materials(2);
    const SectionQuadrature quadrature(mesh, materials);
    Eigen::Vector2d areas(0.0, 0.0);
    for (const CellPoints& cell : quadrature.cells()) {
        for (const double weight : cell.weights) areas[cell.cell->layer] += weight;
    }
    return areas;
}

constexpr const char* two_squares = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
2 1 "left"
2 2 "right"
$EndPhysicalNames
$Nodes
6
1 0 0 0
2 1 0 0
3 2 0 0
4 0 1 0
5 1 1 0
6 2 1 {}
$EndNodes
$Elements
{}
$EndElements
)";

std::string fault_of(const std::string& last_z, const std::string& elements) {
    const ScratchFile file("a.msh", fmt::format(fmt::runtime(two_squares), last_z, elements));
    try {
        make_section_mesh(read_surface_mesh(file.path()), 1.0, {{.name = "all"}});
        return "";
    } catch (const MeshError& error) {
        return error.what();
    }
}

}  // namespace

TEST_CASE("Surfaces of a file become cells of a section, whatever their order", "[mesh]") {
    for (const std::string shape : {"triangles", "quads"}) {
        for (const int order : {1, 2, 3}) {
            CAPTURE(shape, order);
            const SurfaceMesh file = read_circle(shape, order);
            const SectionMesh mesh = make_circle_section(file, 0.1);
            CHECK(find_mesh_fault(mesh) == "");
            const bool is_straight = order == 1;
            for (const SectionCell& cell : mesh.cells) {
                CHECK(cell.order == (is_straight ? 3 : order));
                CHECK((cell.shape == CellShape::quad) == (shape == "quads"));
                CHECK(cell.walls.empty() == (cell.layer == 0));
            }
            const Eigen::Vector2d areas = compute_areas(mesh);
            const Eigen::Vector2d round(0.01 * pi / 4.0, 0.01 * pi * 3.0 / 4.0);
            CHECK((areas - round).norm() < (is_straight ? 0.2 : order == 2 ? 5e-3 : 2e-4) * 0.01);
            REQUIRE(mesh.layers.size() == 2);
            CHECK(mesh.layers[0].name == "core");
            CHECK(mesh.layers[0].material == 1);
            CHECK(mesh.layers[1].fibre_angle == 0.3);
        }
    }
}

TEST_CASE("The direction of walls follows the nearest curve, anticlockwise", "[mesh]") {
    for (const int order : {1, 2, 3}) {
        const SectionMesh mesh = make_circle_section(read_circle("quads", order), 1.0);
        for (const SectionCell& cell : mesh.cells) {
            for (std::size_t i = 0; i < cell.walls.size(); ++i) {
                const PlanePoint& at = mesh.nodes[static_cast<std::size_t>(cell.nodes[i])];
                const PlanePoint expected = PlanePoint(-at.y(), at.x()).normalized();
                CHECK((cell.walls[i] - expected).norm() < (order == 1 ? 0.05 : 5e-3));
                CHECK(std::abs(cell.walls[i].norm() - 1.0) < 1e-14);
            }
        }
    }
    const SurfaceMesh file = read_circle("quads", 1);
    const SectionMesh turned = make_section_mesh(file, 1.0, {{.name = "all", .wall = 0.5 * pi}});
    CHECK((turned.cells[0].walls[0] - PlanePoint(0.0, 1.0)).norm() < 1e-15);
}

TEST_CASE("Cells of order 1 are raised to share the nodes of their sides", "[mesh]") {
    const ScratchFile file(
        "a.msh",
        fmt::format(
            fmt::runtime(two_squares), "0", "3\n1 3 2 1 1 1 2 5 4\n2 2 2 2 2 2 3 6\n3 2 2 2 2 2 6 5"));
    const SurfaceMesh surfaces = read_surface_mesh(file.path());
    const SectionMesh mesh = make_section_mesh(surfaces, 1.0, {{.name = "all"}});
    // 16 + 10 + 10 less the 4 on each of the two common sides.
    CHECK(mesh.nodes.size() == 28);
    CHECK(find_mesh_fault(mesh).empty());
    CHECK(compute_areas(mesh)[0] == Approx(2.0).epsilon(1e-14));
    // One group alone: its nodes alone.
    CHECK(make_section_mesh(surfaces, 1.0, {{.group = 0, .name = "left"}}).nodes.size() == 16);
}

TEST_CASE("Data of a file turn the walls of each surface, or at each of its nodes", "[mesh]") {
    const auto read = [](const std::string& data) {
        std::string text =
            fmt::format(fmt::runtime(two_squares), "0", "2\n11 3 2 1 1 1 2 5 4\n12 3 2 2 2 2 3 6 5");
        const ScratchFile file("a.msh", text + data);
        return read_surface_mesh(file.path());
    };
    const std::string header = "1\n\"turn\"\n1\n0\n3\n0\n1\n2\n";
    const SurfaceMesh once = read("$ElementData\n" + header + "11 0.5\n12 -1.25\n$EndElementData\n");
    REQUIRE(once.data.size() == 1);
    CHECK(once.data[0].name == "turn");
    const SectionMesh mesh = make_section_mesh(once, 1.0, {{.name = "all", .wall = WallAngles{0}}});
    const auto turned = [](double angle) { return PlanePoint(std::cos(angle), std::sin(angle)); };
    REQUIRE(mesh.cells.size() == 2);
    for (const PlanePoint& wall : mesh.cells[0].walls) CHECK((wall - turned(0.5)).norm() < 1e-15);
    for (const PlanePoint& wall : mesh.cells[1].walls) CHECK((wall - turned(-1.25)).norm() < 1e-15);

    // 3 and 3.4 − 2π are 0.4 apart. The second square has its own angles at the nodes that both have.
    const SurfaceMesh by_node =
        read("$ElementNodeData\n" + header +
             "11 4 3 -2.883185307179586 -2.883185307179586 3\n12 4 0 0 0.2 0.2\n$EndElementNodeData\n");
    const SectionMesh bent = make_section_mesh(by_node, 1.0, {{.name = "all", .wall = WallAngles{0}}});
    for (const SectionCell& cell : bent.cells) {
        REQUIRE(cell.walls.size() == 16);
        for (std::size_t i = 0; i < 16; ++i) {
            const PlanePoint& at = bent.nodes[static_cast<std::size_t>(cell.nodes[i])];
            const bool is_left = &cell == &bent.cells[0];
            CHECK((cell.walls[i] - turned(is_left ? 3.0 + 0.4 * at.x() : 0.2 * at.y())).norm() < 1e-14);
        }
    }
    const SurfaceMesh holed = read("$ElementData\n1\n\"turn\"\n1\n0\n3\n0\n1\n1\n11 0.5\n$EndElementData\n");
    CHECK_THROWS_WITH(make_section_mesh(holed, 1.0, {{.name = "all", .wall = WallAngles{0}}}),
                      "the data \"turn\" have no angle of the surface at (1, 0, 0)");
}

TEST_CASE("Files that are not sections are refused", "[mesh]") {
    CHECK(fault_of("0", "1\n1 3 2 1 1 1 2 5 4").empty());
    CHECK(fault_of("0", "2\n1 3 2 1 1 1 2 5 4\n2 3 2 2 2 2 5 4 1") ==
          "the surface at (1, 0, 0) is in two groups, \"left\" and \"right\"; expected one");
    CHECK(fault_of("0", "1\n1 1 2 1 1 1 2") == "has no surfaces; expected triangles or quadrangles");
    CHECK(fault_of("0.1", "1\n1 3 2 1 1 2 3 6 5") ==
          "is not a section: its surfaces lie neither in a plane z = constant nor in x = constant");
    CHECK(fault_of("0", "1\n1 23 2 1 1 1 2 3 4 5 6 1 2 3 4 5 6 1 2 3") ==
          "has elements of type 23; expected triangles of 3, 6 or 10 nodes and quadrangles of 4, 8, 9 or 16");
    const ScratchFile text("b.msh", "outline");
    CHECK_THROWS_WITH(read_surface_mesh(text.path()), "is no mesh; a .msh file starts with $MeshFormat");
}

TEST_CASE("A mesh in the plane of y and z is a section as it is", "[mesh]") {
    const ScratchFile file("a.msh", R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
3
1 5 0 0
2 5 2 0
3 5 0 1
$EndNodes
$Elements
1
1 2 2 0 1 1 2 3
$EndElements
)");
    const SectionMesh mesh = make_section_mesh(read_surface_mesh(file.path()), 1.0, {{.name = "all"}});
    CHECK(mesh.nodes[static_cast<std::size_t>(mesh.cells[0].nodes[3])] == PlanePoint(2.0, 0.0));
    CHECK(compute_areas(mesh)[0] == Approx(1.0).epsilon(1e-14));
}

}  // namespace gxrod::test
