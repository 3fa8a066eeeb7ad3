#include <cmath>

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// Lines 1 to 12, with one rod r from a mesh in line 6.
std::string deck_of(const std::string& file, const std::string& group) {
    return replaced(replaced(rod_deck,
                             "line = { from = [0, 0, 0], to = [10, 0, 0] }",
                             "mesh = { file = \"" + file + "\", group = " + group + " }"),
                    "elements = 10\n",
                    "");
}

std::string mesh_deck(const std::string& file, const std::string& group) {
    return deck_of(GXROD_SOURCE_DIR "/meshes/" + file, group);
}

std::string with_point(const std::string& deck, const std::string& point) {
    return deck + "[[support]]\nat = \"" + point + "\"\nfix = \"all\"\n";
}

// Where the deck's first support is.
Vec3 supported_place(const std::string& deck) {
    const Model model = read(deck).model;
    return model.nodes[static_cast<std::size_t>(model.supports.at(0).node)].position;
}

}  // namespace

TEST_CASE("A curved cable from a mesh follows its circle", "[deck]") {
    const Model model = read(mesh_deck("cable.geo", "\"cable\"")).model;
    const Rod& rod = model.rods[0];
    CHECK(rod.order == 3);
    CHECK(rod.element_count() == 8);
    CHECK(model.nodes.size() == 25);
    CHECK(rod.length == Approx(M_PI / 2.0).epsilon(1e-6));
    for (std::size_t i = 0; i < rod.triads.size(); ++i) {
        // The start is at (−1, 0, 0), the tangent there −z.
        const double s = rod.arc_length[i];
        const Vec3& position = model.nodes[static_cast<std::size_t>(rod.element_nodes[i])].position;
        CHECK((position - Vec3(-std::cos(s), 0, -std::sin(s))).norm() < 1e-5);
        CHECK((rod.triads[i] * Vec3::UnitX() - Vec3(std::sin(s), 0, -std::cos(s))).norm() < 2e-4);
        CHECK((rod.triads[i] * Vec3::UnitY() - Vec3(0, 1, 0)).norm() < 1e-12);
    }
    // Gauss-Lobatto points of the first element.
    const double length = rod.arc_length[3];
    CHECK(rod.arc_length[1] == Approx(0.5 * (1.0 - std::sqrt(0.2)) * length).epsilon(1e-4));
    CHECK(rod.arc_length[2] == Approx(0.5 * (1.0 + std::sqrt(0.2)) * length).epsilon(1e-4));
    CHECK(rod.arc_length[4] == length);
    CHECK(model.nodes[0].name == "r.mast");
    CHECK(model.nodes[24].name == "r.end");
    CHECK(model.nodes[7].name == "r node 7");
}

TEST_CASE("A corner of a mesh has one node and two triads", "[deck]") {
    const Model model = read(mesh_deck("l_frame.geo", "\"frame\"")).model;
    const Rod& rod = model.rods[0];
    CHECK(rod.order == 2);
    REQUIRE(rod.element_count() == 7);
    CHECK(model.nodes.size() == 15);
    CHECK(rod.element_nodes[11] == rod.element_nodes[12]);
    CHECK(model.nodes[static_cast<std::size_t>(rod.element_nodes[11])].name == "r.corner");
    CHECK((rod.triads[11] * Vec3::UnitX() - Vec3(0, 0, 1)).norm() < 1e-14);
    CHECK((rod.triads[12] * Vec3::UnitX() - Vec3(1, 0, 0)).norm() < 1e-14);
    for (const Quat& triad : rod.triads) CHECK((triad * Vec3::UnitY() - Vec3(0, 1, 0)).norm() < 1e-14);
    CHECK(rod.arc_length[12] == Approx(2.0).epsilon(1e-14));
    CHECK(rod.length == Approx(3.5).epsilon(1e-14));
}

TEST_CASE("A truss with a loop and branches is the same in every format", "[deck]") {
    for (const std::string file : {"truss.geo", "truss_2.2.msh", "truss_4.1.msh"}) {
        INFO(file);
        const Problem problem = read(mesh_deck(file, "\"truss\""));
        const Rod& rod = problem.model.rods[0];
        CHECK(rod.element_count() == 12);
        CHECK(problem.model.nodes.size() == 11);
        CHECK(rod.length == Approx(4.0 + std::sqrt(2.0) + 0.8).epsilon(1e-12));
        for (std::size_t e = 0; e < 12; ++e) {
            const auto place = [&](std::size_t i) {
                return problem.model.nodes[static_cast<std::size_t>(rod.element_nodes[2 * e + i])].position;
            };
            CHECK((place(1) - place(0)).norm() == Approx(rod.arc_length[2 * e + 1] - rod.arc_length[2 * e]));
            for (const std::size_t i : {0, 1}) {
                CHECK((rod.triads[2 * e + i] * Vec3::UnitX() - (place(1) - place(0)).normalized()).norm() <
                      1e-14);
            }
        }
        CHECK(problem.notes ==
              std::vector<std::string>{
                  "rod.r.y_axis: not given; section y at the start of each of 4 lines is from the "
                  "global axis least aligned with it"});
        CHECK(supported_place(with_point(mesh_deck(file, "\"truss\""), "r.top")) == Vec3(1, 0, 1.8));
        CHECK(supported_place(with_point(mesh_deck(file, "\"truss\""), "r.left_foot")) == Vec3(0, 0, 0));
    }
}

TEST_CASE("Section y is projected at the start of every line of a net", "[deck]") {
    const std::string deck =
        replaced(mesh_deck("truss.geo", "\"truss\""), "element = \"simo\"", "y_axis = [0, 2, 0]");
    const Problem problem = read(deck);
    CHECK(problem.notes.empty());
    for (const Quat& triad : problem.model.rods[0].triads) {
        CHECK((triad * Vec3::UnitY() - Vec3(0, 1, 0)).norm() < 1e-14);
    }
    CHECK(faults_of(replaced(deck, "[0, 2, 0]", "[0, 0, 1]")) ==
          "x.toml:7:10: rod.r.y_axis: parallel to the line that starts at (1, 0, 1.8), so that section y is "
          "not defined "
          "there; expected another direction, \"up\", or rods of their own for its lines");
    CHECK(faults_of(replaced(deck, "[0, 2, 0]", "[0, 0, 0]")) ==
          "x.toml:7:10: rod.r.y_axis: expected a direction, found a vector of zero length");
}

TEST_CASE("A mesh's rod can be twisted", "[deck]") {
    const std::string deck =
        replaced(mesh_deck("l_frame.geo", "\"frame\""), "element = \"simo\"", "twist = 1.5");
    const Rod rod = read(deck).model.rods[0];
    for (std::size_t i = 0; i < rod.triads.size(); ++i) {
        const Vec3 y = rod.triads[i] * Vec3::UnitY();
        CHECK(std::acos(std::min(1.0, y[1])) == Approx(1.5 * rod.arc_length[i] / 3.5).margin(1e-7));
    }
}

TEST_CASE("A line from a mesh has its ends, its named points and fractions where nodes are", "[deck]") {
    const std::string deck = mesh_deck("l_frame.geo", "\"frame\"");
    CHECK(supported_place(with_point(deck, "r.start")) == Vec3(0, 0, 0));
    CHECK(supported_place(with_point(deck, "r.end")) == Vec3(1.5, 0, 2));
    CHECK(supported_place(with_point(deck, "r.corner")) == Vec3(0, 0, 2));
    CHECK(supported_place(with_point(deck, "r@0.571428571")) == Vec3(0, 0, 2));
    CHECK((supported_place(with_point(deck, "r@0.1428571")) - Vec3(0, 0, 0.5)).norm() < 2e-12);
    CHECK(faults_of(with_point(deck, "r@0.1")) ==
          "x.toml:13:6: support[0].at: the mesh has no node at 0.1; the nearest is at 0.0714285714");
    CHECK(faults_of(with_point(deck, "r@2")) ==
          "x.toml:13:6: support[0].at: expected a fraction from 0 to 1 after \"@\", found \"2\"");
    CHECK(faults_of(with_point(deck, "r.corne")) ==
          "x.toml:13:6: support[0].at: no point \"r.corne\"; did you mean \"r.corner\"?");
    CHECK(faults_of(with_point(deck, "r.abcdefgh")) ==
          "x.toml:13:6: support[0].at: no point \"r.abcdefgh\"; the rod has r.start, r.end, r@FRACTION, "
          "r.corner");
    CHECK(faults_of(with_point(deck, "r")) ==
          "x.toml:13:6: support[0].at: \"r\" is a rod; expected a point of it: r.start, r.end, r@FRACTION or "
          "r.corner");
}

TEST_CASE("A history looks between the nodes of a line from a mesh", "[deck]") {
    const auto history = [](double fraction) {
        return "[[history]]\nname = \"h" + std::to_string(static_cast<int>(1000 * fraction)) +
               "\"\nat = \"r@" + std::to_string(fraction) + "\"\nquantities = \"moment\"\n";
    };
    const std::vector<double> fractions{0.001, 0.1, 0.4, 0.9, 0.999};
    std::string deck = mesh_deck("l_frame.geo", "\"frame\"");
    for (const double fraction : fractions) deck += history(fraction);
    const Problem problem = read(deck);
    CHECK(problem.model.nodes.size() == read(mesh_deck("l_frame.geo", "\"frame\"")).model.nodes.size());
    const Rod& rod = problem.model.rods[0];
    for (std::size_t i = 0; i < fractions.size(); ++i) {
        INFO(fractions[i]);
        const HistoryRequest& request = problem.output.histories[i];
        CHECK(node_of(request.target) == -1);
        const RodPlace& place = std::get<WatchedPoint>(request.target).place;
        CHECK(std::abs(place.xi) < 1.0);
        const auto first = static_cast<std::size_t>(place.element * (rod.order + 1));
        const double start = rod.arc_length[first];
        const double end = rod.arc_length[first + static_cast<std::size_t>(rod.order)];
        CHECK(start + 0.5 * (1.0 + place.xi) * (end - start) == Approx(3.5 * fractions[i]).epsilon(1e-9));
    }
}

TEST_CASE("A net has the points that its mesh names, and no others", "[deck]") {
    const std::string deck = mesh_deck("truss.geo", "\"truss\"");
    CHECK(faults_of(with_point(deck, "r@0.5")) ==
          "x.toml:13:6: support[0].at: rod r is no single line with two ends, along which a fraction has a "
          "meaning; expected r.left_foot, r.right_foot or r.top");
    CHECK(faults_of(with_point(deck, "r.start")) ==
          "x.toml:13:6: support[0].at: no point \"r.start\"; the rod has r.left_foot, r.right_foot, r.top");
    CHECK(read(with_point(deck, "r.feet")).model.supports.size() == 2);
    // Points of the mesh that are not on the rod are not its points.
    CHECK(faults_of(with_point(mesh_deck("truss.geo", "22"), "r.top")) ==
          "x.toml:13:6: support[0].at: no point \"r.top\"; the rod has r.start, r.end, r@FRACTION, "
          "r.left_foot, r.right_foot");
}

TEST_CASE("Points of a rod whose mesh is at fault are not faults too", "[deck]") {
    CHECK(faults_of(with_point(mesh_deck("truss.geo", "\"x\""), "r.top")).find("support") ==
          std::string::npos);
}

TEST_CASE("A mesh decides the number of elements, and the order of curved ones", "[deck]") {
    const std::string deck = mesh_deck("cable.geo", "\"cable\"");
    CHECK(faults_of(replaced(deck, "element = \"simo\"", "elements = 8")) ==
          "x.toml:7:12: rod.r.elements: comes from the mesh; leave it out");
    CHECK(
        faults_of(replaced(deck, "element = \"simo\"", "order = 3")) ==
        "x.toml:7:9: rod.r.order: the mesh has curved elements, of order 3, which keep it; expected the key "
        "left out, or a mesh of order 1");
}

TEST_CASE("Straight elements of a mesh take the order of the rod", "[deck]") {
    const std::string plain = mesh_deck("truss.geo", "\"truss\"");
    const Model before = read(plain).model;
    const Model raised = read(replaced(plain, "element = \"simo\"", "order = 3")).model;
    const Rod& rod = raised.rods[0];
    const std::size_t elements = before.rods[0].element_nodes.size() / 2;
    CHECK(rod.order == 3);
    REQUIRE(rod.element_nodes.size() == 4 * elements);
    CHECK(raised.nodes.size() == before.nodes.size() + 2 * elements);
    for (std::size_t e = 0; e < elements; ++e) {
        const auto at = [&](std::size_t i) {
            return raised.nodes[static_cast<std::size_t>(rod.element_nodes[4 * e + i])].position;
        };
        for (const std::size_t end : {0U, 1U}) {
            const auto node = static_cast<std::size_t>(before.rods[0].element_nodes[2 * e + end]);
            CHECK(at(3 * end) == before.nodes[node].position);
        }
        const double inner = 0.5 * (1.0 - std::sqrt(0.2));
        CHECK((at(1) - (1.0 - inner) * at(0) - inner * at(3)).norm() < 1e-15);
    }
    CHECK(raised.nodes[static_cast<std::size_t>(rod.element_nodes[1])].name.find("node") !=
          std::string::npos);
}

TEST_CASE("A line of a mesh that goes straight back is refused", "[deck]") {
    const ScratchFile back(
        "back.msh",
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 2 0 0\n3 1 0 0\n$EndNodes\n"
        "$Elements\n2\n1 1 2 1 1 1 2\n2 1 2 1 1 2 3\n$EndElements\n");
    CHECK(faults_of(deck_of(back.path(), "1"))
              .ends_with("rod.r.mesh.group: a line goes straight back at (2, 0, 0)"));
}

}  // namespace gxrod::test
