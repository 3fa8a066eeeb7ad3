
#include "deck/decks.hpp"

#include "tools/catch.hpp"

namespace gxrod::test {

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

TEST_CASE("Loads along a rod are functions of time and arc length", "[deck]") {
    const Problem problem =
        read(rod_deck +
             "[function.f]\ntable = [[0, 1], [10, 3]]\n"
             "[[load]]\nat = \"r.end\"\nforce = [1, 0, 0]\n"
             "[[load]]\non = \"r\"\nforce_per_length = [0, \"t*(10 - s)\", \"f(s)\"]\nframe = \"follower\"\n"
             "[[load]]\non = \"r\"\nmoment_per_length = [7, 0, 0]\n");
    const Model& model = problem.model;
    REQUIRE(model.distributed_loads.size() == 2);
    const DistributedLoad& force = model.distributed_loads[0];
    CHECK(force.key == "load[1]");
    CHECK(force.rod == 0);
    CHECK(force.frame == Frame::follower);
    CHECK(force.force[0].is_zero());
    CHECK(force.force[1](2.0, 4.0) == 12.0);
    CHECK(force.force[2](0.0, 5.0) == 2.0);
    CHECK(force.moment[0].is_zero());
    const DistributedLoad& moment = model.distributed_loads[1];
    CHECK(moment.key == "load[2]");
    CHECK(moment.frame == Frame::spatial);
    CHECK(moment.moment[0](3.0, 1.0) == 7.0);
    CHECK(moment.force[2].is_zero());
}

TEST_CASE("A load along a rod names a rod", "[deck]") {
    const auto fault = [](const std::string& name) {
        return faults_of(rod_deck + "[body.b]\nmass = 1\ninertia = [1, 1, 1]\n[[load]]\non = \"" + name +
                         "\"\nforce_per_length = [0, 0, 1]\n");
    };
    CHECK(fault("r").empty());
    CHECK(fault("b") == R"(x.toml:17:6: load[0].on: "b" is a body; expected a rod)");
    CHECK(fault("r.end") == R"(x.toml:17:6: load[0].on: "r.end" is a point; expected the rod "r")");
    CHECK(fault("beam") == R"(x.toml:17:6: load[0].on: no rod "beam"; the deck has r)");
    CHECK(faults_of(body_deck + "[[load]]\non = \"r\"\nforce_per_length = [0, 0, 1]\n") ==
          R"(x.toml:9:6: load[0].on: no rod "r"; the deck has no rod)");
}

TEST_CASE("In a static deck what has no t is multiplied by it", "[deck]") {
    const std::string rest =
        "[function.f]\nexpression = \"3\"\n"
        "[[load]]\nat = \"r.end\"\nforce = [4, \"4*t^2\", 0]\nmoment = [\"f(t)\", \"f(2)\", 0]\n"
        "[[load]]\non = \"r\"\nforce_per_length = [5, \"s\", \"s*t^2\"]\n";
    const Model grown = read("gravity = [2, \"2 + t\", 0]\n" + static_rod_deck + rest).model;
    CHECK(grown.gravity(0.5) == Vec3(1.0, 2.5, 0.0));
    CHECK(grown.loads[0].force[0](0.25) == 1.0);
    CHECK(grown.loads[0].force[1](0.25) == 0.25);
    CHECK(grown.loads[0].force[2].is_zero());
    CHECK(grown.loads[0].moment[0](0.25) == 3.0);
    CHECK(grown.loads[0].moment[1](0.25) == 0.75);
    const auto& along = grown.distributed_loads[0].force;
    CHECK(along[0](0.5, 4.0) == 2.5);
    CHECK(along[1](0.5, 4.0) == 2.0);
    CHECK(along[2](0.5, 4.0) == 1.0);
    const Model dynamic = read("gravity = [2, \"2 + t\", 0]\n" + rod_deck + rest).model;
    CHECK(dynamic.gravity(0.5) == Vec3(2.0, 2.5, 0.0));
    CHECK(dynamic.loads[0].force[0](0.25) == 4.0);
    CHECK(dynamic.distributed_loads[0].force[1](0.5, 4.0) == 4.0);
}

}  // namespace gxrod::test
