#include <cmath>
#include <set>

#include "deck/decks.hpp"
#include "deck/round_trips.hpp"
#include "deck/schema/choices.hpp"
#include "deck/schema/schema.hpp"
#include "model/spring_law.hpp"
#include "tools/catch.hpp"

// Every key of the schema, set to a value that is not its default, is seen in the problem that the reader
// builds.
namespace gxrod::test {

std::string with_body_key(const std::string& line) {
    return replaced(body_deck, "[analysis]", line + "\n[analysis]");
}

std::string with_rod_key(const std::string& line) {
    return replaced(rod_deck, "[analysis]", line + "\n[analysis]");
}

std::string with_history(const std::string& line) {
    const std::string rest = "name = \"h\"\nat = \"r.end\"\nquantities = \"position\"\n";
    const std::string key = line.substr(0, line.find(' '));
    const std::size_t at = rest.find(key + " =");
    if (at == std::string::npos) return rod_deck + "[[history]]\n" + rest + line;
    return rod_deck + "[[history]]\n" + std::string(rest).replace(at, rest.find('\n', at) - at, line);
}

namespace {

std::vector<RoundTrip> top_level_trips() {
    return {
        {"title",
         "title = \"A title\"\n" + body_deck,
         [](const Problem& p) { return p.record.title == "A title"; }},
        {"units",
         "units = \"mm t s\"\n" + body_deck,
         [](const Problem& p) { return p.record.units == "mm t s"; }},
        {"gravity",
         "gravity = [1, \"2\", -9.5]\n" + body_deck,
         [](const Problem& p) { return p.model.gravity(0.0) == Vec3(1, 2, -9.5); }},
        {"parameters",
         replaced(body_deck, "mass = 1.0", "mass = \"2*m\"") + "[parameters]\nm = 4\n",
         [](const Problem& p) { return p.model.bodies[0].mass == 8.0; }},
        {"input.NAME.value",
         body_deck + "[input.u]\nvalue = \"3*t\"\n",
         [](const Problem& p) { return !p.model.inputs.empty() && (*p.model.inputs[0])(2.0) == 6.0; }},
        {"input.NAME.hold",
         body_deck + "[input.u]\nhold = \"linear\"\n",
         [](const Problem& p) {
             return !p.model.inputs.empty() && p.model.inputs[0]->hold() == InputHold::linear;
         }},
        {"function.NAME.table",
         body_deck +
             "[function.f]\ntable = [[0, 0], [2, 6]]\n[[load]]\nat = \"top\"\nforce = [\"f(t)\", 0, 0]\n",
         [](const Problem& p) { return p.model.loads[0].force[0](1.0) == 3.0; }},
        {"function.NAME.file",
         body_deck + "[function.f]\nfile = \"" GXROD_SOURCE_DIR
                     "/tests/deck/motion.csv\"\n[[load]]\nat = \"top\"\nforce = [\"f(t)\", 0, 0]\n",
         [](const Problem& p) { return p.model.loads[0].force[0](1.5) == 5.0; }},
        {"function.NAME.columns",
         body_deck + "[function.f]\nfile = \"" GXROD_SOURCE_DIR
                     "/tests/deck/motion.csv\"\ncolumns = [\"t\", 3]\n[[load]]\nat = \"top\"\n"
                     "force = [\"f(t)\", 0, 0]\n",
         [](const Problem& p) { return p.model.loads[0].force[0](1.5) == 2.5; }},
        {"function.NAME.interpolation",
         body_deck + "[function.f]\ntable = [[0, 0], [1, 1], [3, 9]]\ninterpolation = \"cubic\"\n"
                     "[[load]]\nat = \"top\"\nforce = [\"f(t)\", 0, 0]\n",
         [](const Problem& p) { return std::abs(p.model.loads[0].force[0](2.0) - 4.0) < 1e-14; }},
        {"function.NAME.expression",
         body_deck + "[function.f]\nexpression = \"t^2\"\n[[load]]\nat = \"top\"\nforce = [\"f(t)\", 0, 0]\n",
         [](const Problem& p) { return p.model.loads[0].force[0](3.0) == 9.0; }}};
}

std::vector<RoundTrip> all_trips() {
    std::vector<RoundTrip> all;
    for (const auto& trips :
         {top_level_trips(),    section_trips(),  shape_trips(),         matrix_trips(),
          law_trips(),          drive_trips(),    rod_trips(),           section_frame_trips(),
          spin_trips(),         rest_trips(),     history_frame_trips(), body_trips(),
          plane_trips(),        response_trips(), sweep_trips(),         connection_and_initial_trips(),
          analysis_trips(),     path_trips(),     follow_trips(),        stage_trips(),
          surroundings_trips(), contact_trips(),  looks_trips()}) {
        all.insert(all.end(), trips.begin(), trips.end());
    }
    return all;
}

}  // namespace

TEST_CASE("Every key of a deck is seen in the problem", "[deck]") {
    for (const RoundTrip& trip : all_trips()) {
        INFO(trip.key << "\n" << trip.deck);
        CHECK(trip.is_seen(read(trip.deck)));
    }
}

TEST_CASE("The values that round trips see are not there by default", "[deck]") {
    // These have one valid value only.
    const std::set<std::string> single{"analysis.kind", "stage.kind", "stage.name"};
    for (const RoundTrip& trip : all_trips()) {
        if (single.contains(trip.key)) continue;
        const bool has_loads = trip.key.starts_with("function");
        const bool has_others = trip.key.starts_with("history") || trip.key.starts_with("connect") ||
                                trip.key.starts_with("initial") || trip.key.starts_with("tendon") ||
                                trip.key.starts_with("chamber") || trip.key.starts_with("actuation") ||
                                trip.key.starts_with("magnetic");
        if (has_loads || has_others) continue;  // not there at all without their table
        const bool of_rod = trip.key.starts_with("rod") || trip.key.starts_with("section");
        INFO(trip.key);
        const bool of_shapes = (trip.key.ends_with(".count") && !trip.key.ends_with("sweep.count")) ||
                               trip.key.ends_with(".below") || trip.key.ends_with(".linearization");
        const std::string kind = trip.key.ends_with(".count") ? "buckling" : "modes";
        const std::string bare = of_shapes ? shape_deck(kind, "") : of_rod ? rod_deck : body_deck;
        CHECK_FALSE(trip.is_seen(read(bare)));
    }
}

}  // namespace gxrod::test
