#include "deck/reading/copies.hpp"

#include "deck/decks.hpp"
#include "model/ties/ties.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {

using Catch::Contains;

namespace {

// Lines 1 to 22; text that is added begins in line 23.
const std::string rotor = R"deck([parameters]
R = 0.2
[section.s]
stiffness = { EA = 1e4, GAy = 2e4, GAz = 3e4, GJ = 500, EIy = 600, EIz = 700 }
[body.hub]
at = [1, 0, 0]
[rod.blade]
section = "s"
line = { from = ["1 + R", 0, 0], to = [3, 0, 0] }
y_axis = [0, 1, 0]
elements = 4
copies = { count = 4, about = [0, 0, 2], through = [1, 0, 0] }
[joint.root]
type = "hinge"
between = ["hub", "blade.start"]
axis = [0, 1, 0]
copies = "blade"
[[support]]
at = "hub"
fix = "all"
[analysis]
kind = "static"
)deck";

Vec3 place_of_end(const Model& model, std::size_t rod) {
    return model.nodes[static_cast<std::size_t>(model.rods[rod].nodes.back())].position;
}

}  // namespace

TEST_CASE("copies of a rod and its joint are turned about an axis", "[deck]") {
    const Problem problem = read(rotor);
    const Model& model = problem.model;
    REQUIRE(model.rods.size() == 4);
    REQUIRE(model.joints.size() == 4);
    const std::array<Vec3, 4> ends{
        Vec3(3.0, 0.0, 0.0), Vec3(1.0, 2.0, 0.0), Vec3(-1.0, 0.0, 0.0), Vec3(1.0, -2.0, 0.0)};
    const std::array<Vec3, 4> across{
        Vec3(0.0, 1.0, 0.0), Vec3(-1.0, 0.0, 0.0), Vec3(0.0, -1.0, 0.0), Vec3(1.0, 0.0, 0.0)};
    for (std::size_t i = 0; i < 4; ++i) {
        const std::string number = std::to_string(i + 1);
        CHECK(model.rods[i].name == "blade_" + number);
        CHECK(model.joints[i].name == "root_" + number);
        CHECK((place_of_end(model, i) - ends[i]).norm() < 1e-14);
        CHECK((model.rods[i].triads[0] * Vec3::UnitY() - across[i]).norm() < 1e-14);
        CHECK((model.joints[i].a.axes.col(0) - across[i]).norm() < 1e-14);
        CHECK(model.joints[i].b.anchor.node == model.rods[i].nodes.front());
        CHECK((find_place(model, model.joints[i].b.anchor) -
               (Vec3(1.0, 0.0, 0.0) + 0.1 * (ends[i] - Vec3(1.0, 0.0, 0.0))))
                  .norm() < 1e-14);
    }
}

TEST_CASE("loads, supports, bodies, springs, bushings and histories have copies, too", "[deck]") {
    const Problem problem = read(rotor + R"deck([body.tip]
at = "blade.end"
mass = 1
rotation_vector = [0.5, 0, 0]
copies = "blade"
[spring.guy]
between = ["ground", "blade@0.5"]
at_a = [2, 0, 1]
stiffness = 3
copies = "blade"
[bushing.pad]
between = ["hub", "blade.start"]
at = [1.1, 0, 0]
stiffness = { x = 1, y = 2 }
copies = "blade"
[bushing.bed]
between = ["ground", "blade.end"]
axes = "ground"
stiffness = { x = 1, y = 2 }
copies = "blade"
[[load]]
at = "blade.end"
force = ["2*t", 0, "2*t"]
copies = "blade"
[[load]]
on = "blade"
force_per_length = [0, "s", 0]
frame = "body"
copies = "blade"
[[support]]
at = "blade.end"
fix = ["x"]
copies = "blade"
[[history]]
name = "tip"
at = "blade.end"
quantities = ["position"]
copies = "blade"
[[history]]
name = "second"
at = "blade_2@0.25"
quantities = ["position"]
)deck");
    const Model& model = problem.model;
    const Quat turn(Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitZ()));
    REQUIRE(model.bodies.size() == 5);
    CHECK(model.bodies[2].name == "tip_2");
    CHECK(model.bodies[2].node == model.rods[1].nodes.back());
    CHECK((model.bodies[2].attitude.toRotationMatrix() - (turn * model.bodies[1].attitude).toRotationMatrix())
              .norm() < 1e-14);
    REQUIRE(model.springs.size() == 4);
    CHECK((model.springs[1].ends[0].arm - Vec3(1.0, 1.0, 1.0)).norm() < 1e-14);
    REQUIRE(model.bushings.size() == 8);
    for (const std::size_t i : {1, 5})
        CHECK((model.bushings[i].axes.toRotationMatrix() - turn.toRotationMatrix()).norm() < 1e-14);
    CHECK(model.bushings[5].carrier == BushingAxes::ground);
    CHECK((find_place(model, model.bushings[1].ends[1]) - Vec3(1.0, 0.1, 0.0)).norm() < 1e-14);
    REQUIRE(model.loads.size() == 4);
    const auto& force = model.loads[1].force;
    CHECK((Vec3(force[0](0.5), force[1](0.5), force[2](0.5)) - Vec3(0.0, 1.0, 1.0)).norm() < 1e-14);
    REQUIRE(model.distributed_loads.size() == 4);
    CHECK(model.distributed_loads[1].force[1](1.0, 0.7) == Approx(0.7));
    CHECK(model.distributed_loads[1].rod == 1);
    REQUIRE(model.supports.size() == 5);
    CHECK((model.supports[2].axes.toRotationMatrix() - turn.toRotationMatrix()).norm() < 1e-14);
    REQUIRE(problem.output.histories.size() == 5);
    CHECK(problem.output.histories[2].name == "tip_3");
}

TEST_CASE("faults of copies name their key", "[deck]") {
    const auto faults = [](const std::string& old_text, const std::string& new_text) {
        return faults_of(replaced(rotor, old_text, new_text));
    };
    CHECK(faults("count = 4", "count = 1") ==
          "x.toml:12:20: rod.blade.copies.count: expected a whole number from 2 to 1000");
    CHECK(faults("about = [0, 0, 2]", "about = [0, 0, 0]") ==
          "x.toml:12:31: rod.blade.copies.about: expected 3 numbers, not all of them zero for about");
    CHECK_THAT(faults("count = 4", "number = 4"), Contains("rod.blade.copies.number: unknown key"));
    CHECK(faults("copies = \"blade\"", "copies = \"hub\"") ==
          "x.toml:17:10: joint.root.copies: \"hub\" names no table with copies");
    CHECK_THAT(faults("y_axis = [0, 1, 0]\n", ""),
               Contains("copies need y_axis or z_axis, which is turned with them"));
    CHECK_THAT(faults("[body.hub]",
                      "[rod.blade_2]\nsection = \"s\"\nline = { from = [0, 0, 0], to = [1, 0, 0] }\nelements "
                      "= 1\n[body.hub]"),
               Contains("rod.blade: its copy blade_2 has the name of another table"));
    // Without a copy of its own, a table has to say which copy it means.
    CHECK_THAT(faults_of(rotor + "[[load]]\nat = \"blade.end\"\nforce = [0, 0, 1]\n"),
               Contains("load[0].at"));
    CHECK_THAT(
        faults_of(rotor + "[[load]]\nat = \"blade.end\"\nforce = [0, 0, \"-z\"]\ncopies = \"blade\"\n"),
        Contains("a force by place or velocity is not turned with copies"));
    CHECK_THAT(faults_of(rotor + "[[load]]\nat = \"blade.end\"\nforce = [\"t\", 0, 1]\ncopies = \"blade\"\n"),
               Contains("load[0].force: copies are turned: expected t in all components"));
    // Each copy would act on all.
    CHECK_THAT(faults_of(rotor + "[[load]]\nat = [\"blade*.end\"]\nforce = [0, 0, 1]\ncopies = \"blade\"\n"),
               Contains("load[0].at: a pattern names all copies at once"));
    CHECK_THAT(faults_of(rotor + "[[load]]\nwhere = \"x > 0\"\nforce = [0, 0, 1]\ncopies = \"blade\"\n"),
               Contains("load[0].where: a condition on the place is not turned with copies"));
    CHECK_THAT(faults_of(rotor + "[[load]]\non = \"blade\"\nfile = \"q.csv\"\ncopies = \"blade\"\n"),
               Contains("load[0].file: components of a file are not turned with copies"));
    CHECK(faults_of(rotor + "[[load]]\nat = \"blade*.end\"\nforce = [0, 0, 1]\n").empty());
    CHECK_THAT(faults("elements = 4", "elements = 0"), Contains("rod.blade_1.elements"));
}

}  // namespace gxrod::test
