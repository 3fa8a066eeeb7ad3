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

}  // namespace gxrod::test
