#include "deck/sections/section_axes.hpp"

#include <Eigen/Geometry>

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;
using Notes = std::vector<std::string>;

Vec3 x_of(const Quat& triad) { return triad * Vec3::UnitX(); }
Vec3 z_of(const Quat& triad) { return triad * Vec3::UnitZ(); }

Rod rod_along(const std::string& curve, const std::string& axis, const std::string& top = "") {
    return read(top + replaced(static_rod_deck,
                               "line = { from = [0, 0, 0], to = [10, 0, 0] }",
                               curve + "\n" + axis))
        .model.rods.at(0);
}

const std::string mesh_deck = R"([section.s]
stiffness = { EA = 1e4, GAy = 2e4, GAz = 3e4, GJ = 500, EIy = 600, EIz = 700 }
[rod.r]
section = "s"
mesh = { file = ")" GXROD_SOURCE_DIR R"(/meshes/truss.geo", group = "truss" }
z_axis = "up"
[analysis]
kind = "static"
)";

}  // namespace

TEST_CASE("Section z is in the vertical plane of the rod by the rule up", "[deck]") {
    const Vec3 tangent = Vec3(3, 4, 2).normalized();
    const Rod rod = rod_along("line = { from = [0, 0, 0], to = [3, 4, 2] }", "z_axis = \"up\"");
    const Vec3 expected = (Vec3::UnitZ() - tangent.z() * tangent).normalized();
    for (const Quat& triad : rod.triads) {
        CHECK((x_of(triad) - tangent).norm() < 1e-14);
        CHECK((z_of(triad) - expected).norm() < 1e-14);
    }
    const Rod with_y = rod_along("line = { from = [0, 0, 0], to = [3, 4, 2] }", "y_axis = \"up\"");
    CHECK((with_y.triads[0] * Vec3::UnitY() - expected).norm() < 1e-14);
    // A vector is projected, too.
    const Rod by_vector = rod_along("line = { from = [0, 0, 0], to = [3, 4, 2] }", "z_axis = [0, 0, 7]");
    CHECK((z_of(by_vector.triads[0]) - expected).norm() < 1e-14);
}

TEST_CASE("Up is against gravity, or the second axis of the plane", "[deck]") {
    const std::string line = "line = { from = [0, 0, 0], to = [1, 1, 0] }";
    const auto z_with = [&](const std::string& top) {
        return z_of(rod_along(line, "z_axis = \"up\"", top).triads[0]);
    };
    const Vec3 in_plane = Vec3(-1, 1, 0).normalized();
    CHECK((z_with("") - Vec3::UnitZ()).norm() < 1e-14);
    CHECK((z_with("gravity = [0, -9.81, 0]\n") - in_plane).norm() < 1e-14);
    CHECK((z_with("plane = \"xy\"\n") - in_plane).norm() < 1e-14);
    CHECK((z_with("gravity = [0, 0, 3]\n") + Vec3::UnitZ()).norm() < 1e-14);
}

TEST_CASE("The rule is anew after each corner, and a vertical piece has section z along x", "[deck]") {
    const std::string portal = "polyline = [[0, 0, 0], [0, 0, 3], [4, 3, 3], [4, 3, 0]]";
    const std::string deck = replaced(
        static_rod_deck, "line = { from = [0, 0, 0], to = [10, 0, 0] }", portal + "\nz_axis = \"up\"");
    const Problem problem = read(deck);
    const std::vector<Quat>& triads = problem.model.rods.at(0).triads;
    for (const Quat& triad : triads) {
        const bool is_column = std::abs(x_of(triad).z()) > 0.5;
        CHECK((z_of(triad) - (is_column ? Vec3::UnitX() : Vec3::UnitZ())).norm() < 1e-12);
    }
    CHECK(problem.notes ==
          Notes{"rod.r.z_axis: up is [0, 0, 1]; 2 of 3 pieces are vertical, with section z from global x"});
    const auto leaning = [](const std::string& to) {
        return z_of(rod_along("line = { from = [0, 0, 0], to = [" + to + "] }", "z_axis = \"up\"").triads[0]);
    };
    CHECK((leaning("0, 0.0009, 1") - Vec3::UnitX()).norm() < 1e-12);
    CHECK((leaning("0, 0.002, 1") + Vec3::UnitY()).norm() < 0.01);
    CHECK(
        (z_of(rod_along(
                  "line = { from = [0, 0, 0], to = [2, 0, 0] }", "z_axis = \"up\"", "gravity = [-1, 0, 0]\n")
                  .triads[0]) -
         Vec3::UnitY())
            .norm() < 1e-14);
}

TEST_CASE("Along a curve axes are carried without twisting from where the rule has them", "[deck]") {
    const Rod arch =
        rod_along("arc = { from = [1, 0, 0], through = [0, 0, 1], to = [-1, 0, 0] }", "z_axis = \"up\"");
    CHECK((z_of(arch.triads[0]) - Vec3::UnitX()).norm() < 1e-12);
    for (const Quat& triad : arch.triads) CHECK(std::abs(z_of(triad).y()) < 1e-12);
    CHECK((z_of(arch.triads.back()) + Vec3::UnitX()).norm() < 1e-12);
}

TEST_CASE("The rule gives each element of a mesh its axes", "[deck]") {
    const Problem problem = read(mesh_deck);
    const Rod& rod = problem.model.rods.at(0);
    bool has_column = false;
    for (const Quat& triad : rod.triads) {
        const Vec3 tangent = x_of(triad);
        const bool is_column = tangent.cross(Vec3::UnitZ()).norm() < 1e-3;
        has_column = has_column || is_column;
        const Vec3 up = is_column ? Vec3::UnitX() : Vec3::UnitZ();
        CHECK((z_of(triad) - (up - up.dot(tangent) * tangent).normalized()).norm() < 1e-9);
    }
    CHECK(has_column);
    CHECK_THAT(problem.notes.at(0),
               Contains("rod.r.z_axis: up is [0, 0, 1]; ") &&
                   Contains(" elements are vertical, with section z from global x"));
}

TEST_CASE("y_axis and z_axis are one of them", "[deck]") {
    const auto faults = [](const std::string& keys) {
        return faults_of(replaced(static_rod_deck, "element = \"simo\"", keys));
    };
    CHECK_THAT(faults("y_axis = [0, 1, 0]\nz_axis = \"up\""), Contains("y_axis") && Contains("z_axis"));
    CHECK(faults("z_axis = \"down\"") ==
          "x.toml:8:10: rod.r.z_axis: expected \"up\", found the text \"down\"");
    CHECK(
        faults("z_axis = [2, 0, 0]") ==
        "x.toml:8:10: rod.r.z_axis: parallel to the rod, so that section z is not defined; expected another "
        "direction");
    CHECK(faults("z_axis = \"up\"\nrest = { line = { from = [0, 0, 0], to = [0, 0, 9] } }").empty());
}

}  // namespace gxrod::test
