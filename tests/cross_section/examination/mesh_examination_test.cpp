#include "cross_section/examination/mesh_examination.hpp"

#include <string>
#include <vector>

#include "cross_section/walls/solid_meshes.hpp"
#include "cross_section/walls/wall_mesh.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

// A mesh of quadrilaterals and triangles with straight sides, whose corners are given in the order of a walk.
SectionMesh make_mesh(std::vector<PlanePoint> nodes, const std::vector<std::vector<int>>& walks) {
    SectionMesh mesh{.nodes = std::move(nodes), .cells = {}, .layers = {{.name = "all"}}};
    for (const std::vector<int>& walk : walks) {
        SectionCell cell;
        cell.shape = walk.size() == 4 ? CellShape::quad : CellShape::triangle;
        cell.nodes = walk;
        if (walk.size() == 4) std::swap(cell.nodes[2], cell.nodes[3]);
        mesh.cells.push_back(cell);
    }
    return mesh;
}

// Two squares side by side; nodes 0 to 5 are the lower row, then the upper one.
const std::vector<PlanePoint> six{{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}};

}  // namespace

TEST_CASE("Sound meshes have no fault", "[cross_section]") {
    CHECK(find_mesh_fault(make_mesh(six, {{0, 1, 4, 3}, {1, 2, 5, 4}})).empty());
    CHECK(find_mesh_fault(make_mesh(six, {{0, 1, 4, 3}, {1, 2, 5}, {1, 5, 4}})).empty());
    CHECK(find_mesh_fault(mesh_circle(1.0)).empty());
    CHECK(find_mesh_fault(mesh_tube(1.0, 0.9)).empty());
    const WallOutline hook{.corners = {{{0, 0}}, {{4, 0}, 0.5}, {{4, 2}}, {{2, 2}}, {{2, 0.16}}},
                           .layups = {0}};
    CHECK(find_mesh_fault(mesh_walls(hook, {{"skin", {{0, 0.1, 0.0}, {0, 0.2, 0.0}}}})).empty());
    CHECK(find_mesh_fault(SectionMesh{}) == "has no elements");
}

TEST_CASE("Elements that are inside out or flat are found", "[cross_section]") {
    const std::string text = "the element near (1.5, 0.5) is inside out or has no area";
    CHECK(find_mesh_fault(make_mesh(six, {{0, 1, 4, 3}, {1, 4, 5, 2}})) == text);
    CHECK(find_mesh_fault(make_mesh(six, {{0, 1, 4, 3}, {1, 2, 4, 5}})) == text);
    CHECK(find_mesh_fault(make_mesh(six, {{0, 1, 4, 3}, {0, 1, 2}})) ==
          "the element near (1, 0) is inside out or has no area");
    // Of order 2, with one node moved so far that the side crosses the element.
    SectionMesh bent = mesh_rectangle(1.0, 1.0, {.order = 2});
    const SectionCell& cell = bent.cells.front();
    bent.nodes[static_cast<std::size_t>(cell.nodes[1])] = bent.nodes[static_cast<std::size_t>(cell.nodes[7])];
    CHECK(find_mesh_fault(bent).ends_with("is inside out or has no area"));
}

TEST_CASE("Parts of a mesh that share no node are counted", "[cross_section]") {
    std::vector<PlanePoint> nodes = six;
    nodes.insert(nodes.end(), {{1, 0}, {1, 1 + 1e-9}});
    CHECK(find_mesh_fault(make_mesh(nodes, {{0, 1, 4, 3}, {6, 2, 5, 7}})) ==
          "2 parts share no node; 2 of their corners coincide, the first at (1, 0): merge them (Gmsh: "
          "Coherence "
          "Mesh)");
    nodes[6] = {1.1, 0};
    nodes[7] = {1.1, 1};
    CHECK(find_mesh_fault(make_mesh(nodes, {{0, 1, 4, 3}, {6, 2, 5, 7}})) ==
          "2 parts share no node and touch nowhere, one at (0.5, 0.5), one at (1.55, 0.5): a section is one "
          "piece");
}

TEST_CASE("Parts that are joined at a node only are found", "[cross_section]") {
    std::vector<PlanePoint> nodes = six;
    nodes.insert(nodes.end(), {{2, 2}, {1, 2}});
    CHECK(find_mesh_fault(make_mesh(nodes, {{0, 1, 4, 3}, {4, 5, 6, 7}})) ==
          "the part at (1.5, 1.5) is joined to the rest at single nodes only, and would turn about them");
}

TEST_CASE("Nodes on sides of other elements are found", "[cross_section]") {
    std::vector<PlanePoint> nodes = six;
    nodes.insert(nodes.end(), {{1, 0.5}, {2, 0.5}, {1, 2}, {2, 2}, {0, 2}});
    // The right square is cut in two, whose common node is on the side of the left one.
    CHECK(find_mesh_fault(make_mesh(nodes, {{0, 1, 4, 3}, {1, 2, 7, 6}, {6, 7, 5, 4}})) ==
          "the side from (1, 0) to (1, 1) has a node of another element on it, at (1, 0.5), that it does not "
          "share");
}

TEST_CASE("Elements that overlap are found", "[cross_section]") {
    CHECK(find_mesh_fault(make_mesh(six, {{0, 1, 4, 3}, {1, 2, 5, 4}, {1, 2, 5, 4}})) ==
          "elements overlap near (1.5, 0.5): two lie on the same side of an edge");
    // A chain of elements that comes back over the first one.
    CHECK(find_mesh_fault(make_mesh({{0, 0}, {4, 0}, {4, 1}, {0, 1}, {6, 0}, {6, 3}, {2, 3}, {1, 0.5}},
                                    {{0, 1, 2, 3}, {1, 4, 5, 2}, {2, 5, 6, 7}})) ==
          "elements overlap near (1.2, 1)");
    // Those that share one node, and cross elsewhere.
    CHECK(find_mesh_fault(make_mesh({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5}, {1.5, 0.5}, {1.5, 1.5}},
                                    {{0, 1, 2, 3}, {2, 4, 5, 6}})) == "elements overlap near (1, 0.5)");
    // A node on a side, of an element on the same side of it.
    CHECK(find_mesh_fault(make_mesh(six, {{0, 1, 4, 3}, {0, 2, 5, 4}})) == "elements overlap near (1, 0)");
}
