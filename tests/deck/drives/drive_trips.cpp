#include "deck/decks.hpp"
#include "deck/round_trips.hpp"

namespace gxrod::test {
namespace {

std::string staged(const std::string& lines) {
    return rod_deck.substr(0, rod_deck.find("[analysis]")) + lines +
           "[[stage]]\nname = \"one\"\nkind = \"static\"\n[[stage]]\nname = \"two\"\nkind = \"static\"\n";
}

std::vector<RoundTrip> tendon_trips() {
    const std::string lines = "[tendon.t]\non = \"r\"\noffset = [0.25, \"s\"]\ntension = \"7*t\"\n";
    const std::string drawn = "[tendon.t]\non = \"r\"\noffset = [0, 1]\n";
    const auto first = [](const Problem& p) { return p.model.tendons.at(0); };
    return {{"tendon.NAME.shortening",
             rod_deck + drawn + "shortening = \"7*t\"\n",
             [=](const Problem& p) { return first(p).winch->shortening(3.0) == 21.0; }},
            {"tendon.NAME.length",
             rod_deck + drawn + "length = \"10 - t\"\n",
             [=](const Problem& p) { return (*first(p).winch->length)(3.0) == 7.0; }},
            {"tendon.NAME.stiffness",
             rod_deck + drawn + "shortening = 1\nstiffness = 30\n",
             [=](const Problem& p) { return first(p).winch->stiffness == 30.0; }},
            {"tendon.NAME.slack",
             rod_deck + drawn + "shortening = 0\nslack = false\n",
             [=](const Problem& p) { return !first(p).winch->pulls_only; }},
            {"tendon.NAME.friction",
             rod_deck + lines + "friction = 0.3\n",
             [=](const Problem& p) {
                 return first(p).friction->coefficient == 0.3 && first(p).friction->is_pulled_at_start;
             }},
            {"tendon.NAME.pulled_at",
             rod_deck + lines + "friction = 0.3\npulled_at = \"to\"\n",
             [=](const Problem& p) { return !first(p).friction->is_pulled_at_start; }},
            {"tendon.NAME.on", rod_deck + lines, [=](const Problem& p) { return first(p).rod == 0; }},
            {"tendon.NAME.offset",
             rod_deck + lines,
             [=](const Problem& p) { return first(p).path(2.0).at == Vec3(0.0, 0.25, 2.0); }},
            {"tendon.NAME.tension",
             rod_deck + lines,
             [=](const Problem& p) { return first(p).tension(3.0) == 21.0; }},
            {"tendon.NAME.from",
             rod_deck + lines + "from = 0.25\n",
             [=](const Problem& p) { return first(p).from == 2.5; }},
            {"tendon.NAME.to",
             rod_deck + lines + "to = 0.75\n",
             [=](const Problem& p) { return first(p).to == 7.5; }},
            {"tendon.NAME.factor",
             rod_deck + lines + "factor = 2\n",
             [=](const Problem& p) { return first(p).tension(3.0) == 42.0; }},
            {"tendon.NAME.stages", staged(lines + "stages = \"two\"\n"), [=](const Problem& p) {
                 return first(p).tension(3.0) == 0.0 &&
                        p.stages[1].actions.tendons.at(0).tension(3.0) == 21.0;
             }}};
}

std::vector<RoundTrip> chamber_trips() {
    const std::string lines =
        "[chamber.t]\non = \"r\"\noffset = [0.25, \"s\"]\narea = 0.5\npressure = \"7*t\"\n";
    const auto first = [](const Problem& p) { return p.model.tendons.at(0); };
    return {{"chamber.NAME.on", rod_deck + lines, [=](const Problem& p) { return first(p).rod == 0; }},
            {"chamber.NAME.offset",
             rod_deck + lines,
             [=](const Problem& p) { return first(p).path(2.0).at == Vec3(0.0, 0.25, 2.0); }},
            {"chamber.NAME.area",
             rod_deck + lines,
             [=](const Problem& p) { return first(p).tension(2.0) == -7.0; }},
            {"chamber.NAME.pressure",
             rod_deck + lines,
             [=](const Problem& p) { return first(p).tension(3.0) == -10.5; }},
            {"chamber.NAME.from",
             rod_deck + lines + "from = 0.25\n",
             [=](const Problem& p) { return first(p).from == 2.5; }},
            {"chamber.NAME.to",
             rod_deck + lines + "to = 0.75\n",
             [=](const Problem& p) { return first(p).to == 7.5; }},
            {"chamber.NAME.factor",
             rod_deck + lines + "factor = 2\n",
             [=](const Problem& p) { return first(p).tension(3.0) == -21.0; }},
            {"chamber.NAME.stages", staged(lines + "stages = \"two\"\n"), [=](const Problem& p) {
                 return first(p).tension(3.0) == 0.0 &&
                        p.stages[1].actions.tendons.at(0).tension(3.0) == -10.5;
             }}};
}

std::vector<RoundTrip> actuation_trips() {
    const std::string begin = "[[actuation]]\non = \"r\"\n";
    const auto with = [=](const std::string& line) { return rod_deck + begin + line; };
    const auto with_heat = [=](const std::string& line) {
        return replaced(rod_deck, "[rod.r]", "expansion = 1e-5\n[rod.r]") + begin + line;
    };
    const auto first = [](const Problem& p) { return p.model.actuations.at(0); };
    const auto strain = [=](const Problem& p, std::size_t i) { return first(p).strain[i](2.0, 3.0); };
    return {
        {"actuation.on", with("stretch = 1\n"), [=](const Problem& p) { return first(p).rod == 0; }},
        {"actuation.stretch",
         with("stretch = \"t*s\"\n"),
         [=](const Problem& p) { return strain(p, 0) == 6.0; }},
        {"actuation.shear",
         with("shear = [\"t\", \"s\"]\n"),
         [=](const Problem& p) { return strain(p, 1) == 2.0 && strain(p, 2) == 3.0; }},
        {"actuation.curvature",
         with("curvature = [\"t\", \"s\", 5]\n"),
         [=](const Problem& p) { return strain(p, 3) == 2.0 && strain(p, 4) == 3.0 && strain(p, 5) == 5.0; }},
        {"actuation.temperature",
         with_heat("temperature = \"t*s\"\n"),
         [=](const Problem& p) { return first(p).temperature(2.0, 3.0) == 6.0; }},
        {"actuation.temperature_gradient",
         with_heat("temperature_gradient = [\"t\", \"s\"]\n"),
         [=](const Problem& p) {
             return first(p).temperature_gradient[0](2.0, 3.0) == 2.0 &&
                    first(p).temperature_gradient[1](2.0, 3.0) == 3.0;
         }},
        {"actuation.factor",
         with("stretch = 3\nfactor = \"t\"\n"),
         [=](const Problem& p) { return strain(p, 0) == 6.0; }},
        {"actuation.stages", staged(begin + "stretch = 1\nstages = \"two\"\n"), [](const Problem& p) {
             return p.model.actuations.empty() && p.stages[1].actions.actuations.size() == 1;
         }}};
}

std::vector<RoundTrip> magnetic_trips() {
    const std::string lines = "[[magnetic]]\non = \"r\"\nmoment = [\"s\", 0, 2]\nfield = [\"t\", \"y\", 3]\n";
    const auto first = [](const Problem& p) { return p.model.distributed_loads.at(0); };
    const auto field = [=](const Problem& p) { return first(p).field->at(2.0, Vec3(0.0, 5.0, 0.0)); };
    return {{"magnetic.on", rod_deck + lines, [=](const Problem& p) { return first(p).rod == 0; }},
            {"magnetic.moment",
             rod_deck + lines,
             [=](const Problem& p) {
                 return first(p).moment[0](0.0, 4.0) == 4.0 && first(p).moment[2](0.0, 0.0) == 2.0;
             }},
            {"magnetic.field",
             rod_deck + lines,
             [=](const Problem& p) { return field(p) == Vec3(2.0, 5.0, 3.0); }},
            {"magnetic.factor",
             rod_deck + lines + "factor = 2\n",
             [=](const Problem& p) { return field(p) == Vec3(4.0, 10.0, 6.0); }},
            {"magnetic.stages", staged(lines + "stages = \"two\"\n"), [](const Problem& p) {
                 return p.model.distributed_loads.empty() &&
                        p.stages[1].actions.distributed_loads.size() == 1;
             }}};
}

}  // namespace

std::vector<RoundTrip> drive_trips() {
    std::vector<RoundTrip> trips = tendon_trips();
    for (RoundTrip& trip : chamber_trips()) trips.push_back(std::move(trip));
    for (RoundTrip& trip : actuation_trips()) trips.push_back(std::move(trip));
    for (RoundTrip& trip : magnetic_trips()) trips.push_back(std::move(trip));
    const std::string expanding = replaced(rod_deck, "[rod.r]", "expansion = 1e-5\n[rod.r]");
    trips.push_back({"section.NAME.expansion", expanding, [](const Problem& p) {
                         return p.model.sections[0].expansion == 1e-5;
                     }});
    return trips;
}

}  // namespace gxrod::test
