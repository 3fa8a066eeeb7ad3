#include <cmath>

#include "deck/decks.hpp"
#include "deck/round_trips.hpp"
#include "deck/schema/choices.hpp"

namespace gxrod::test {
namespace {

const std::string force = "[[load]]\nat = \"r.end\"\nforce = [\"2*t\", 0, 3]\n";

}  // namespace

// Keys by which loads and supports know of stages, and the plane of all.
std::vector<RoundTrip> action_trips() {
    const std::string deck = staged(rod_deck);
    return {{"load.factor",
             rod_deck + force + "factor = \"3*t\"\n",
             [](const Problem& p) { return p.model.loads[0].force[2](2.0) == 18.0; }},
            {"load.stages",
             deck + force + "stages = [\"two\"]\n",
             [](const Problem& p) {
                 return p.model.loads.empty() && p.stages[1].actions.loads[0].force[0](4.0) == 8.0;
             }},
            {"support.stages",
             deck + "[[support]]\nat = \"r.end\"\nfix = \"x\"\nstages = \"two\"\n",
             [](const Problem& p) {
                 return p.model.supports.empty() && p.stages[1].actions.supports.size() == 1;
             }},
            {"plane", "plane = \"xy\"\n" + rod_deck, [](const Problem& p) {
                 return p.model.plane && p.model.plane->normal == 2;
             }}};
}

std::vector<RoundTrip> load_trips() {
    const std::string along = rod_deck + "[[load]]\non = \"r\"\nforce_per_length = [\"2*t + s\", 0, 3]\n";
    const auto is_seen = [](const std::array<LineFunction, 3>& value) {
        return value[0](4.0, 0.5) == 8.5 && value[2](0.0, 1.0) == 3.0;
    };
    return {
        {"load.at", rod_deck + force, [](const Problem& p) { return p.model.loads[0].node == 10; }},
        {"load.force",
         rod_deck + force,
         [](const Problem& p) {
             return p.model.loads[0].force[0](4.0) == 8.0 && p.model.loads[0].force[2](0.0) == 3.0;
         }},
        {"load.moment",
         rod_deck + replaced(force, "force", "moment"),
         [](const Problem& p) {
             return p.model.loads[0].moment[0](4.0) == 8.0 && p.model.loads[0].moment[2](0.0) == 3.0;
         }},
        {"load.on",
         along,
         [](const Problem& p) { return p.model.loads.empty() && p.model.distributed_loads.at(0).rod == 0; }},
        {"load.force_per_length",
         along,
         [=](const Problem& p) { return is_seen(p.model.distributed_loads[0].force); }},
        {"load.moment_per_length",
         replaced(along, "force_per", "moment_per"),
         [=](const Problem& p) { return is_seen(p.model.distributed_loads[0].moment); }},
        {"load.frame", rod_deck + force + "frame = \"follower\"", [](const Problem& p) {
             return p.model.loads[0].frame == Frame::follower;
         }}};
}

std::vector<RoundTrip> support_trips() {
    std::vector<RoundTrip> trips{
        {"support.at",
         rod_deck + "[[support]]\nat = \"r.start\"\nfix = \"x\"\n",
         [](const Problem& p) { return p.model.supports[0].node == 0; }},
        {"support.fix",
         rod_deck + "[[support]]\nat = \"r.end\"\nfix = [\"y\", \"rx\", \"rz\"]\n",
         [](const Problem& p) {
             return p.model.supports[0].fixed == std::array{false, true, false, true, false, true};
         }},
        {"support.axes",
         rod_deck + "[[support]]\nat = \"r.end\"\nfix = \"x\"\naxes = [[0, 1, 0], [0, 0, 1], [1, 0, 0]]\n",
         [](const Problem& p) {
             return (p.model.supports[0].axes * Vec3::UnitX()).isApprox(Vec3::UnitY(), 1e-15);
         }}};
    for (std::size_t i = 0; i < component_names.size(); ++i) {
        const std::string name(component_names[i]);
        // A rotation that moves needs the other two.
        std::string others;
        for (std::size_t k = i < 3 ? 0 : 3; k < (i < 3 ? 3 : 6); ++k) {
            if (k != i) others += (others.empty() ? "\"" : ", \"") + std::string(component_names[k]) + "\"";
        }
        trips.push_back({"support.move." + name,
                         rod_deck + "[[support]]\nat = \"r.end\"\nfix = [" + others + "]\nmove = { " + name +
                             " = \"3*t\" }\n",
                         [i](const Problem& p) {
                             const Support& support = p.model.supports[0];
                             return support.moved[i] && support.motion[i](2.0) == 6.0;
                         }});
    }
    return trips;
}

std::vector<RoundTrip> connection_and_initial_trips() {
    const std::string initial = "[[initial]]\non = \"r\"\nvelocity = [\"x\", \"2*s\", 1]\n";
    return {
        {"connect.points",
         rod_deck + "[rod.q]\nsection = \"s\"\nline = { from = [10, 0, 0], to = [10, 5, 0] }\nelements = 2\n"
                    "element = \"simo\"\n[[connect]]\npoints = [\"r.end\", \"q.start\"]\n",
         [](const Problem& p) { return p.model.rods[1].nodes[0] == 10; }},
        {"initial.on",
         rod_deck + initial,
         [](const Problem& p) { return p.model.nodes[10].velocity != Vec3::Zero(); }},
        {"initial.velocity",
         rod_deck + initial,
         [](const Problem& p) { return p.model.nodes[3].velocity == Vec3(3, 6, 1); }},
        {"initial.angular_velocity",
         rod_deck + replaced(initial, "velocity", "angular_velocity"),
         [](const Problem& p) { return p.model.nodes[3].angular_velocity == Vec3(3, 6, 1); }}};
}

}  // namespace gxrod::test
