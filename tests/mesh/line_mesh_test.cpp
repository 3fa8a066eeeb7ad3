#include "mesh/line_mesh.hpp"

#include <fstream>
#include <set>

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

const std::string meshes = GXROD_SOURCE_DIR "/meshes/";

const MeshLines& lines_of(const LineMesh& mesh, int number) {
    for (const MeshLines& lines : mesh.lines) {
        if (lines.number == number) return lines;
    }
    throw std::runtime_error("no such group");
}

std::set<std::string> point_names(const LineMesh& mesh) {
    std::set<std::string> names;
    for (const MeshPoints& points : mesh.points) names.insert(name_of_group(points.number, points.name));
    return names;
}

}  // namespace

TEST_CASE("A mesh is the same from geometry and from each version of the format", "[mesh]") {
    for (const std::string file : {"truss.geo", "truss_2.2.msh", "truss_4.1.msh"}) {
        INFO(file);
        const LineMesh mesh = read_line_mesh(meshes + file);
        CHECK(mesh.positions.size() == 11);
        CHECK(point_names(mesh) == std::set<std::string>{"left_foot", "right_foot", "top", "feet"});
        REQUIRE(mesh.lines.size() == 2);
        const MeshLines& truss = lines_of(mesh, 21);
        CHECK(truss.name == "truss");
        CHECK(truss.orders == std::vector<int>{1});
        CHECK(truss.nodes.size() == 24);
        CHECK(lines_of(mesh, 22).name.empty());
        CHECK(lines_of(mesh, 22).nodes.size() == 4);
        for (const MeshPoints& points : mesh.points) {
            if (points.name == "feet") CHECK(points.nodes.size() == 2);
            if (points.name != "top") continue;
            REQUIRE(points.nodes.size() == 1);
            CHECK(mesh.positions[points.nodes[0]] == Vec3(1, 0, 1.8));
        }
    }
}

TEST_CASE("Geometry is meshed at the order that it asks for, ends of elements outside", "[mesh]") {
    const LineMesh cable = read_line_mesh(meshes + "cable.geo");
    const MeshLines& lines = cable.lines.at(0);
    CHECK(lines.orders == std::vector<int>{3});
    REQUIRE(lines.nodes.size() == 8 * 4);
    for (std::size_t e = 0; e < 8; ++e) {
        // The angle from the start of the quarter circle grows along each element.
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec3& at = cable.positions[lines.nodes[4 * e + i]];
            CHECK(at.norm() == Approx(1.0).epsilon(1e-12));
            const double angle = std::atan2(-at[2], -at[0]);
            CHECK(angle ==
                  Approx(M_PI / 16.0 * (static_cast<double>(e) + static_cast<double>(i) / 3.0)).margin(1e-6));
        }
    }
    // The options of one file do not reach the next.
    CHECK(lines_of(read_line_mesh(meshes + "truss.geo"), 21).orders == std::vector<int>{1});
    CHECK(read_line_mesh(meshes + "l_frame.geo").lines.at(0).orders == std::vector<int>{2});
}

TEST_CASE("Groups of surfaces, of mixed and of high order are distinguished", "[mesh]") {
    const ScratchFile file("mixed.msh", R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
3
1 1 "mixed"
1 2 "high"
2 3 "skin"
$EndPhysicalNames
$Nodes
8
1 0 0 0
2 1 0 0
3 2 0 0
4 1.5 0 0
5 0 1 0
6 0.25 1 0
7 0.5 1 0
8 0.75 1 0
$EndNodes
$Elements
4
1 1 2 1 1 1 2
2 8 2 1 2 2 3 4
3 27 2 2 3 5 1 6 7 8
4 2 2 3 4 1 2 5
$EndElements
)");
    const LineMesh mesh = read_line_mesh(file.path());
    CHECK(lines_of(mesh, 1).orders == std::vector<int>{1, 2});
    CHECK(lines_of(mesh, 1).nodes.empty());
    CHECK(lines_of(mesh, 2).orders == std::vector<int>{4});
    CHECK(lines_of(mesh, 2).nodes.empty());
    REQUIRE(mesh.regions.size() == 1);
    CHECK(mesh.regions[0].name == "skin");
    CHECK(mesh.regions[0].dimension == 2);
}

TEST_CASE("A mesh that cannot be read is an error with the reason", "[mesh]") {
    CHECK_THROWS_WITH(read_line_mesh(meshes + "nothing.msh"), "cannot be read (No such file or directory)");
    CHECK_THROWS_WITH(read_line_mesh(meshes), "is a folder, expected a mesh");
    CHECK_THROWS_WITH(read_line_mesh("/dev/null"), "is not a regular file, expected a mesh");
    const ScratchFile wrong("wrong.geo", "Point(1) = {0, 0, 0};\nPoint(;\n");
    CHECK_THROWS_WITH(
        read_line_mesh(wrong.path()),
        Catch::StartsWith("Gmsh cannot read it: ") && Catch::EndsWith("line 2: syntax error (;)"));
    const ScratchFile nowhere("nowhere.msh", R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
1
1 0 0 0
$EndNodes
$Elements
1
1 1 2 1 1 1 9
$EndElements
)");
    CHECK_THROWS_AS(read_line_mesh(nowhere.path()), MeshError);
    // The log of one file does not reach the next.
    CHECK(read_line_mesh(meshes + "truss.geo").lines.size() == 2);
    const ScratchFile cut("cut.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0");
    CHECK_THROWS_AS(read_line_mesh(cut.path()), MeshError);
    const ScratchFile other("other.msh", "This is no mesh.\n");
    CHECK_THROWS_WITH(read_line_mesh(other.path()), "is no mesh; a .msh file starts with $MeshFormat");
    const ScratchFile empty("empty.msh", "");
    CHECK_THROWS_WITH(read_line_mesh(empty.path()), "is no mesh; a .msh file starts with $MeshFormat");
}

// Gmsh takes what does not begin as a mesh for a script, whatever the file is called.
TEST_CASE("A file that is called a mesh is not run as a script", "[mesh]") {
    const ScratchFile script("evil.msh", "$Foo;\n;\nPoint(1) = {0, 0, 0};\nPhysical Point(\"p\") = {1};\n");
    CHECK_THROWS_WITH(read_line_mesh(script.path()), "is no mesh; a .msh file starts with $MeshFormat");
    const ScratchFile blank("blank.msh", "\n$MeshFormat\n2.2 0 8\n$EndMeshFormat\n");
    CHECK_THROWS_WITH(read_line_mesh(blank.path()), "is no mesh; a .msh file starts with $MeshFormat");
}

TEST_CASE("A geometry script runs no programs and writes no files", "[mesh]") {
    const std::string line =
        "Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0}; Line(1) = {1, 2};\nPhysical Curve(\"c\") = {1};\n";
    const ScratchFile harmless("harmless.geo", line);
    CHECK(read_line_mesh(harmless.path()).lines.size() == 1);
    const std::filesystem::path made = harmless.path().parent_path() / "made";
    const std::string name = "\"" + made.string() + "\"";
    for (const std::string& action : {"SystemCall \"touch " + made.string() + "\";\n",
                                      "NonBlockingSystemCall \"touch " + made.string() + "\";\n",
                                      "Printf(\"x\") > " + name + ";\n",
                                      "Printf(\"x\") >> " + name + ";\n",
                                      "Mesh 1; Save \"" + made.string() + ".msh\";\n"}) {
        INFO(action);
        const ScratchFile script("script.geo", line + action);
        const bool is_program = action.find("System") != std::string::npos;
        CHECK_THROWS_WITH(
            read_line_mesh(script.path()),
            Catch::StartsWith("Gmsh cannot read it: ") &&
                Catch::Contains(is_program ? "it tries to run a program" : "Unable to open file"));
        CHECK_FALSE(std::filesystem::exists(made));
    }
}

}  // namespace gxrod::test
