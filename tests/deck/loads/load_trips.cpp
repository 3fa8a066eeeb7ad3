#include "deck/decks.hpp"
#include "deck/round_trips.hpp"

namespace gxrod::test {
std::vector<RoundTrip> plane_trips() {
    return {{"plane", "plane = \"xy\"\n" + rod_deck, [](const Problem& p) {
                 return p.model.plane && p.model.plane->normal == 2;
             }}};
}

std::vector<RoundTrip> connection_and_initial_trips() {
    const std::string pair = rod_deck +
                             "[rod.q]\nsection = \"s\"\nline = { from = [10, 0, 0], to = [10, 5, 0] }\n"
                             "elements = 2\nelement = \"simo\"\n";
    const std::string initial = "[[initial]]\non = \"r\"\nvelocity = [\"x\", \"2*s\", 1]\n";
    return {
        {"connect.points",
         rod_deck + "[rod.q]\nsection = \"s\"\nline = { from = [10, 0, 0], to = [10, 5, 0] }\nelements = 2\n"
                    "element = \"simo\"\n[[connect]]\npoints = [\"r.end\", \"q.start\"]\n",
         [](const Problem& p) { return p.model.rods[1].nodes[0] == 10; }},
        {"connect.on",
         pair + "[[connect]]\npoints = \"coincident\"\non = [\"r\", \"q\"]\n",
         [](const Problem& p) { return p.model.rods[1].nodes[0] == 10; }},
        {"connect.tolerance",
         replaced(pair, "from = [10, 0, 0]", "from = [10, 0.1, 0]") +
             "[[connect]]\npoints = \"coincident\"\ntolerance = 0.2\n",
         [](const Problem& p) { return p.model.rods[1].nodes[0] == 10; }},
        {"rod.NAME.hinges",
         pair + "hinges = \"start\"\n[[connect]]\npoints = \"coincident\"\n",
         [](const Problem& p) { return p.model.joints.size() == 1 && p.model.joints[0].name == "q.start"; }},
        {"load.where",
         pair + "[[load]]\nwhere = \"y > 4\"\nforce = [0, 0, 1]\n",
         [](const Problem& p) { return p.model.loads.size() == 1 && p.model.loads[0].node == 13; }},
        {"support.where",
         pair + "[[support]]\nwhere = \"y > 4\"\nfix = \"all\"\n",
         [](const Problem& p) { return p.model.supports.size() == 1 && p.model.supports[0].node == 13; }},
        {"gravity.acceleration",
         "gravity = { acceleration = [1, \"2\", -9.5] }\n" + rod_deck,
         [](const Problem& p) { return p.model.gravity(0.0) == Vec3(1, 2, -9.5); }},
        {"gravity.factor",
         "gravity = { acceleration = [0, 0, -2], factor = \"1 + t\" }\n" + rod_deck,
         [](const Problem& p) { return p.model.gravity(0.5) == Vec3(0, 0, -3); }},
        {"gravity.stages",
         "gravity = { acceleration = [0, 0, -2], stages = \"two\" }\n" + staged(rod_deck),
         [](const Problem& p) {
             return p.model.gravity(0.5) == Vec3(0, 0, 0) && p.stages.size() == 2 &&
                    p.stages[1].actions.gravity(0.5) == Vec3(0, 0, -2);
         }},
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
