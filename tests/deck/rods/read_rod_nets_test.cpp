#include <fstream>
#include <iterator>

#include "deck/decks.hpp"
#include "deck/text/fault.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

const std::string meshes = GXROD_SOURCE_DIR "/meshes/";

// Lines 1 to 12, with one rod r from a mesh in line 6.
std::string deck_of(const std::string& file, const std::string& group) {
    return replaced(replaced(rod_deck,
                             "line = { from = [0, 0, 0], to = [10, 0, 0] }",
                             "mesh = { file = \"" + file + "\", group = " + group + " }"),
                    "elements = 10\n",
                    "");
}

std::string mesh_deck(const std::string& file, const std::string& group) {
    return deck_of(meshes + file, group);
}

std::string read_bytes(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

// The message of the one fault of a deck.
std::string message_of(const std::string& deck) {
    try {
        read(deck);
    } catch (const DeckError& error) {
        return error.faults.size() == 1 ? error.faults[0].message : error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("A group goes by its name or its number", "[deck]") {
    CHECK(read(mesh_deck("truss.geo", "\"truss\"")).model.rods[0].element_count() == 12);
    CHECK(read(mesh_deck("truss.geo", "21")).model.rods[0].element_count() == 12);
    CHECK(read(mesh_deck("truss.geo", "22")).model.rods[0].element_count() == 2);
    // As --set has numbers in text.
    CHECK(read(mesh_deck("truss.geo", "\"22\"")).model.rods[0].element_count() == 2);
}

TEST_CASE("A problem is rebuilt from its record when the mesh is gone", "[deck]") {
    std::optional<Problem> problem;
    {
        const ScratchFile file("net.msh", read_bytes(meshes + "truss_4.1.msh"));
        problem = read(deck_of(file.path().string(), "\"truss\""));
    }
    REQUIRE(!std::filesystem::exists(problem->record.meshes.at(0).file));
    const Problem rebuilt = rebuild_problem(problem->record);
    CHECK(rebuilt.record.text == problem->record.text);
    CHECK(rebuilt.record.meshes.at(0).file == problem->record.meshes[0].file);
    CHECK(rebuilt.record.meshes[0].bytes == problem->record.meshes[0].bytes);
    REQUIRE(rebuilt.model.nodes.size() == problem->model.nodes.size());
    for (std::size_t i = 0; i < rebuilt.model.nodes.size(); ++i) {
        CHECK(rebuilt.model.nodes[i].position == problem->model.nodes[i].position);
    }
    CHECK(rebuild_problem(problem->record, {"analysis.steps=7"}).record.text != problem->record.text);
}

TEST_CASE("A geometry script of a record is not run, and no other file read", "[deck]") {
    DeckRecord script = read(mesh_deck("truss.geo", "\"truss\"")).record;
    CHECK_THROWS_WITH(rebuild_problem(script), Catch::Contains("is not run from a results file"));
    DeckRecord missing = read(mesh_deck("truss_4.1.msh", "\"truss\"")).record;
    missing.meshes.clear();
    CHECK_THROWS_WITH(rebuild_problem(missing), Catch::Contains("is not kept in the results file"));
}

TEST_CASE("Rods can be groups of one mesh, whose bytes are kept once", "[deck]") {
    const Problem problem =
        read(mesh_deck("truss.geo", "\"truss\"") + "[rod.q]\nsection = \"s\"\nmesh = { file = \"" + meshes +
             "truss.geo\", group = 22 }\n[rod.c]\nsection = \"s\"\nmesh = { file = \"" + meshes +
             "cable.geo\", group = \"cable\" }\n");
    REQUIRE(problem.model.rods.size() == 3);
    CHECK(problem.model.rods[1].element_count() == 2);
    CHECK(problem.model.rods[2].order == 3);
    REQUIRE(problem.record.meshes.size() == 2);
    CHECK(problem.record.meshes[0].file == meshes + "truss.geo");
    CHECK(problem.record.meshes[0].bytes == read_bytes(meshes + "truss.geo"));
    CHECK(problem.record.meshes[1].bytes == read_bytes(meshes + "cable.geo"));
    CHECK(read(rod_deck).record.meshes.empty());
}

TEST_CASE("A mesh is found from the folder of its deck", "[deck]") {
    const ScratchFile mesh(
        "line.geo",
        "Point(1) = {0,0,0};\nPoint(2) = {1,0,0};\nLine(1) = {1, 2};\nPhysical Curve(\"a\") = {1};\n");
    const std::string deck = deck_of("line.geo", "\"a\"");
    CHECK_NOTHROW(read_problem_text(deck, (mesh.path().parent_path() / "x.toml").string()));
    CHECK(message_of(deck) == "line.geo: cannot be read (No such file or directory)");
}

TEST_CASE("Faults of a mesh or its group are reported", "[deck]") {
    CHECK(faults_of(deck_of("no.msh", "\"a\"")) ==
          "x.toml:6:17: rod.r.mesh.file: no.msh: cannot be read (No such file or directory)");
    CHECK(message_of(mesh_deck("truss.geo", "\"trus\"")) ==
          "no physical group \"trus\" of lines; did you mean \"truss\"?");
    CHECK(message_of(mesh_deck("truss.geo", "\"bridge\"")) ==
          "no physical group \"bridge\" of lines; the mesh has truss, 22");
    CHECK(message_of(mesh_deck("truss.geo", "23")) ==
          "no physical group 23 of lines; the mesh has truss, 22");
    CHECK(message_of(mesh_deck("truss.geo", "\"top\"")) ==
          "physical group \"top\" is one of points; expected lines");
    CHECK(message_of(mesh_deck("truss.geo", "true")) ==
          "expected the name or the number of a physical group, found a boolean");
    const ScratchFile bare("bare.geo", "Point(1) = {0,0,0};\nPoint(2) = {1,0,0};\nLine(1) = {1, 2};\n");
    CHECK(message_of(deck_of(bare.path(), "\"a\"")) ==
          "no physical group \"a\" of lines; the mesh has no physical group of lines");
    const std::string square =
        "Point(1) = {0,0,0};\nPoint(2) = {1,0,0};\nPoint(3) = {1,1,0};\nLine(1) = {1, 2};\nLine(2) = {2, "
        "3};\nLine(3) = {3, 1};\n";
    const ScratchFile surface(
        "surface.geo",
        square + "Curve Loop(1) = {1, 2, 3};\nPlane Surface(1) = {1};\nPhysical Surface(\"skin\") = {1};\n");
    CHECK(message_of(deck_of(surface.path(), "\"skin\"")) ==
          "physical group \"skin\" is one of surfaces; expected lines");
    const ScratchFile high("high.geo", square + "Mesh.ElementOrder = 4;\nPhysical Curve(\"edge\") = {1};\n");
    CHECK(message_of(deck_of(high.path(), "\"edge\"")) ==
          "physical group edge has elements of order 4; expected order 1 to 3");
}

TEST_CASE("A group without elements, or with elements of two orders, is reported", "[deck]") {
    const std::string nodes = "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 1.5 0 0\n$EndNodes\n";
    const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    const ScratchFile mixed("mixed.msh",
                            head + nodes + "$Elements\n2\n1 1 2 1 1 1 2\n2 8 2 1 2 2 3 4\n$EndElements\n");
    CHECK(message_of(deck_of(mixed.path(), "1")) ==
          "physical group 1 has elements of orders 1 and 2; expected one order");
    const ScratchFile loop("loop.msh", head + nodes + "$Elements\n1\n1 8 2 1 1 2 2 3\n$EndElements\n");
    CHECK(message_of(deck_of(loop.path(), "1")) == "the element at (1, 0, 0) ends where it starts");
    const ScratchFile none(
        "none.geo",
        "Point(1) = {0,0,0};\nPoint(2) = {1,0,0};\nLine(1) = {1, 2};\nPhysical Curve(\"a\") = {7};\n");
    CHECK(message_of(deck_of(none.path(), "\"a\"")).find("a") != std::string::npos);
}

}  // namespace gxrod::test
