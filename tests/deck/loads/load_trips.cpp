#include "deck/decks.hpp"
#include "deck/round_trips.hpp"

namespace gxrod::test {
std::vector<RoundTrip> plane_trips() {
    return {{"plane", "plane = \"xy\"\n" + rod_deck, [](const Problem& p) {
                 return p.model.plane && p.model.plane->normal == 2;
             }}};
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
