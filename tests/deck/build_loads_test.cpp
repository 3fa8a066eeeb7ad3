#include "deck/decks.hpp"

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

TEST_CASE("Loads have the axes of the point that is named", "[deck]") {
    const Problem problem =
        read(rod_deck +
             "[body.b]\nmass = 1\ninertia = [1, 1, 1]\nat = \"r.end\"\nrotation_vector = [1, 0, 0]\n"
             "[[load]]\nat = \"r.end\"\nforce = [0, 0, 1]\nframe = \"body\"\n"
             "[[load]]\nat = \"b\"\nforce = [0, 0, 1]\nframe = \"body\"\n");
    const Model& model = problem.model;
    CHECK(model.loads[0].node == model.loads[1].node);
    CHECK(model.loads[0].axes.isApprox(model.rods[0].triads[10]));
    CHECK(model.loads[1].axes.isApprox(model.bodies[0].attitude));
    CHECK_FALSE(model.loads[0].axes.isApprox(model.loads[1].axes));
    CHECK(model.loads[0].frame == Frame::body);
}

}  // namespace gxrod::test
