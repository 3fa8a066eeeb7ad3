#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {

TEST_CASE("A frame turns about the axis of its deck, with a speed by the load factor", "[deck]") {
    const std::string deck = replaced(static_rod_deck, "\"static\"", "\"steady\"") + "[rotation]\n";
    const Problem plain = read(deck + "speed = 2\n");
    CHECK(plain.model.rotation->axis == Vec3::UnitZ());
    CHECK(plain.model.rotation->through == Vec3::Zero());
    CHECK(plain.model.rotation->speed(0.5) == 1.0);
    const Problem other = read(deck + "speed = \"2*t^2\"\naxis = [3, 0, 0]\nthrough = [1, 2, 3]\n");
    CHECK(other.model.rotation->axis == Vec3::UnitX());
    CHECK(other.model.rotation->through == Vec3(1, 2, 3));
    CHECK(other.model.rotation->speed(0.5) == 0.5);
    CHECK(faults_of(deck + "speed = 2\naxis = [0, 0, 0]\n") ==
          "x.toml:13:8: rotation.axis: expected a vector that is not zero");
}

TEST_CASE("Parts that spin are named by their rods and bodies", "[deck]") {
    const std::string deck = replaced(static_rod_deck, "\"static\"", "\"steady\"") +
                             "[body.b]\nmass = 1\nat = [0, 0, 1]\n[rotation]\naxis = [1, 0, 0]\nspeed = 2\n";
    const TurningFrame rod = *read(deck + "spins = \"r\"\n").model.rotation;
    CHECK(rod.is_at_rest());
    CHECK(rod.spins(0));
    CHECK(rod.spins(10));
    CHECK_FALSE(rod.spins(11));
    CHECK_FALSE(rod.spins(-1));
    CHECK(read(deck + "spins = [\"r\", \"b\"]\n").model.rotation->spins(11));
    CHECK_FALSE(read(deck).model.rotation->is_at_rest());
    CHECK(faults_of(deck + "spins = \"s\"\n").starts_with("x.toml:17:9: rotation.spins: "));
}

TEST_CASE("Gravity acts once a revolution after a stage whose frame turns", "[deck]") {
    const std::string deck = replaced(static_rod_deck, "[analysis]\nkind = \"static\"\n", "") +
                             "[rotation]\nspeed = 2\n[[history]]\nname = \"h\"\nat = \"r.end\"\nquantities = "
                             "[\"displacement\"]\n";
    const std::string steady = "[[stage]]\nname = \"a\"\nkind = \"steady\"\n";
    const std::string response = "[[stage]]\nname = \"b\"\nkind = \"response\"\ngravity = [0, -9, 0]\n";
    const Problem problem = read(deck + steady + response);
    CHECK(std::get<ResponseSettings>(problem.stages[1].analysis).gravity == Vec3(0, -9, 0));
    CHECK_THAT(faults_of(deck + steady + "[[stage]]\nname = \"c\"\nkind = \"static\"\n" + response),
               Catch::Contains("the stage before is not one of kind steady"));
    CHECK_THAT(faults_of(replaced(deck, "speed = 2\n", "speed = 2\nspins = \"r\"\n") + steady + response),
               Catch::Contains("has gravity as a load"));
    CHECK_THAT(faults_of(deck + steady + response + "omega = { values = [1] }\n"),
               Catch::Contains("gravity"));
}

}  // namespace gxrod::test
