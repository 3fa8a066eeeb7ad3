#include "deck/checks/check_functions.hpp"

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {

TEST_CASE("Functions of time are finite at the steps of the analysis", "[deck]") {
    CHECK(faults_of(body_deck + R"x([[load]]
at = "top"
force = ["1/(t - 0.5)", 0, 0])x") == R"x(x.toml:10:10: load[0].force[0]: "1/(t - 0.5)" is inf at t = 0.5)x");
    CHECK(faults_of(body_deck + R"x([[load]]
at = "top"
moment = [0, "sqrt(0.35 - t)", 0])x") ==
          R"x(x.toml:10:14: load[0].moment[1]: "sqrt(0.35 - t)" is nan at t = 0.4)x");
    CHECK(faults_of(body_deck + R"x([[load]]
at = "top"
force = [0, 0, "log(t)"]
moment = ["1/(1 - t)", 0, 0])x") ==
          R"x(x.toml:10:16: load[0].force[2]: "log(t)" is -inf at t = 0
x.toml:11:11: load[0].moment[0]: "1/(1 - t)" is inf at t = 1)x");
    CHECK(faults_of(body_deck + R"x([function.f]
expression = "sqrt(0.25 - t)"
[[load]]
at = "top"
force = [0, 0, "f(t - 0.1)"])x") == R"x(x.toml:12:16: load[0].force[2]: "f(t - 0.1)" is nan at t = 0.4)x");
}

TEST_CASE("Functions of time are asked for at every step up to 10000, then at 10001 of them", "[deck]") {
    const auto pole_at = [](const std::string& time, const std::string& steps) {
        return faults_of(replaced(body_deck, "steps = 10", "steps = " + steps) +
                         "[[load]]\nat = \"top\"\nforce = [\"1/(t - " + time + ")\", 0, 0]\n");
    };
    CHECK(pole_at("0.5", "7").empty());
    CHECK_FALSE(pole_at("0.5", "8").empty());
    CHECK_FALSE(pole_at("1", "7").empty());
    CHECK_FALSE(pole_at("0", "7").empty());
    CHECK_FALSE(pole_at("0.0009765625", "1024").empty());
    CHECK_FALSE(pole_at("0.5", "1048576").empty());
    CHECK(pole_at("0.50000095367431640625", "1048576").empty());
}

TEST_CASE("Gravity, loads along rods and moves are finite at the steps of the analysis", "[deck]") {
    CHECK(faults_of("gravity = [0, \"1/(t - 0.2)\", 0]\n" + body_deck) ==
          R"x(x.toml:1:15: gravity[1]: "1/(t - 0.2)" is inf at t = 0.2)x");
    CHECK(faults_of(rod_deck + R"x([[load]]
on = "r"
force_per_length = [0, "1/s", "sqrt(t - 0.1)"]
moment_per_length = ["t/(s - 10)", 0, 0])x") ==
          R"x(x.toml:15:24: load[0].force_per_length[1]: "1/s" is inf at t = 0, s = 0
x.toml:15:31: load[0].force_per_length[2]: "sqrt(t - 0.1)" is nan at t = 0, s = 0
x.toml:16:22: load[0].moment_per_length[0]: "t/(s - 10)" is nan at t = 0, s = 10)x");
    CHECK(faults_of(body_deck + R"x([[support]]
at = "top"
move = { x = "t/(t - 1)" })x") == R"x(x.toml:10:14: support[0].move.x: "t/(t - 1)" is inf at t = 1)x");
}

}  // namespace gxrod::test
