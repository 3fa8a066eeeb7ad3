#include "report/model/model_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "deck/problem.hpp"
#include "tools/catch.hpp"

using namespace gxrod;
using Json = nlohmann::json;

namespace {

// Two bodies, a joint between them and one on the ground, springs and a bushing.
const char* const deck = R"(
[body.crank]
mass = 1
inertia = [1, 1, 1]
at = [1, 0, 0]
[body.link]
mass = 1
inertia = [1, 1, 1]
at = [3, 0, 0]
[joint.shaft]
type = "hinge"
between = ["ground", "crank"]
at = [0, 0.5, 0]
axis = [0, 3, 4]
move = "t^2"
[joint.knuckle]
type = "universal"
between = ["crank", "link"]
at = [2, 0, 0]
axis = [0, 0, 2]
axis_b = [0, 5, 0]
[spring.cord]
between = ["ground", "link"]
at_a = [3, 4, 0]
at_b = [3, 0, 0.25]
stiffness = 2
length = 1
[spring.dashpot]
between = ["crank", "link"]
damping = 2
[bushing.mount]
between = ["ground", "link"]
stiffness = { x = 1, rz = 1 }
[analysis]
kind = "dynamic"
end_time = 1
time_step = 0.1
)";

// Numbers of nodes in the page that are not those of the model.
int number(int node) { return node + 7; }

Vec3 vector(const Json& json) { return Vec3(json.at(0), json.at(1), json.at(2)); }

// Where an end is at t = 0.
Vec3 place(const Json& end, const Model& model) {
    const int node = end.at("node");
    return (node < 0 ? Vec3(Vec3::Zero()) : model.nodes[node - 7].position) + vector(end.at("arm"));
}

Vec3 first_axis(const Json& quaternion) {
    const Quat axes(quaternion.at(0), quaternion.at(1), quaternion.at(2), quaternion.at(3));
    return axes * Vec3::UnitX();
}

}  // namespace

TEST_CASE("Joints are described by their ends, places and axes", "[report][joint]") {
    const Problem problem = read_problem_text(deck, "crank.toml");
    const Json joints = describe_joints(problem.model, number, 10);
    REQUIRE(joints.size() == 2);
    CHECK(joints[0]["name"] == "shaft");
    CHECK(joints[0]["type"] == "hinge");
    CHECK(joints[0]["leaves_free"] == "turn about the axis");
    CHECK(joints[0]["moved"] == true);
    CHECK_FALSE(joints[0].contains("axis_b"));
    CHECK(joints[0]["ends"][0]["node"] == -1);
    CHECK(joints[0]["ends"][1]["node"].get<int>() - 7 == problem.model.bodies[0].node);
    for (const Json& end : joints[0]["ends"])
        CHECK((place(end, problem.model) - Vec3(0, 0.5, 0)).norm() < 1e-15);
    CHECK((first_axis(joints[0]["axes"]) - Vec3(0, 0.6, 0.8)).norm() < 1e-15);

    CHECK(joints[1]["name"] == "knuckle");
    CHECK(joints[1]["type"] == "universal");
    CHECK(joints[1]["moved"] == false);
    for (const Json& end : joints[1]["ends"])
        CHECK((place(end, problem.model) - Vec3(2, 0, 0)).norm() < 1e-15);
    CHECK((first_axis(joints[1]["axes"]) - Vec3::UnitZ()).norm() < 1e-15);
    CHECK((vector(joints[1]["axis_b"]) - Vec3::UnitY()).norm() < 1e-15);
    CHECK(describe_joints(problem.model, number, 1).size() == 1);
}

TEST_CASE("A sleeve is described as a joint at its point", "[report][joint]") {
    Model model;
    model.nodes.resize(2);
    model.rods.emplace_back().nodes = {0};
    model.sleeves.push_back({.name = "collar", .rod = 0, .point = {.node = 1, .arm = Vec3(0, 0.5, 0)}});
    const Json joints = describe_joints(model, number, 10);
    REQUIRE(joints.size() == 1);
    CHECK(joints[0]["name"] == "collar");
    CHECK(joints[0]["type"] == "sleeve");
    for (const Json& end : joints[0]["ends"]) {
        CHECK(end["node"] == number(1));
        CHECK(vector(end["arm"]) == Vec3(0, 0.5, 0));
    }
    CHECK(joints[0]["around"] == number(0));
    CHECK(describe_joints(model, number, 0).empty());
}

TEST_CASE("Springs and bushings are described by their ends", "[report]") {
    const Problem problem = read_problem_text(deck, "crank.toml");
    nlohmann::ordered_json ties;
    describe_element_ties(problem.model, number, 10, ties);
    const Json springs = ties["springs"];
    REQUIRE(springs.size() == 2);
    CHECK(springs[0]["name"] == "cord");
    CHECK(springs[0]["pulls"] == true);
    CHECK((place(springs[0]["ends"][0], problem.model) - Vec3(3, 4, 0)).norm() < 1e-15);
    CHECK((place(springs[0]["ends"][1], problem.model) - Vec3(3, 0, 0.25)).norm() < 1e-15);
    CHECK(springs[0]["ends"][0]["node"] == -1);
    CHECK(springs[1]["name"] == "dashpot");
    CHECK(springs[1]["pulls"] == false);
    CHECK_FALSE(springs[0].contains("axes"));

    const Json bushings = ties["bushings"];
    REQUIRE(bushings.size() == 1);
    CHECK_FALSE(bushings[0].contains("pulls"));
    CHECK(bushings[0]["name"] == "mount");
    for (const Json& end : bushings[0]["ends"])
        CHECK((place(end, problem.model) - Vec3(3, 0, 0)).norm() < 1e-15);
    CHECK((first_axis(bushings[0]["axes"]) - Vec3::UnitX()).norm() < 1e-15);

    describe_element_ties(problem.model, number, 1, ties);
    CHECK(ties["springs"].size() == 1);
}
