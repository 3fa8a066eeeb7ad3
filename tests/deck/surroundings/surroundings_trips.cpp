#include <algorithm>
#include <cmath>

#include "deck/round_trips.hpp"
#include "deck/surroundings/surroundings_decks.hpp"

namespace gxrod::test {
namespace {

const std::string folder = GXROD_SOURCE_DIR "/tests/deck/surroundings/";

bool is_near(double a, double b) { return std::abs(a - b) <= 1e-12 * std::abs(b); }

const Water& water_of(const Problem& p) {
    static const Water none;
    return p.model.surroundings.water ? *p.model.surroundings.water : none;
}
const Seabed& bed_of(const Problem& p) {
    static const Seabed none;
    return p.model.surroundings.seabed ? *p.model.surroundings.seabed : none;
}
Air air_of(const Problem& p) { return p.model.surroundings.air.value_or(Air{}); }
SectionInFluid section_of(const Problem& p) {
    return p.model.sections.empty() ? SectionInFluid{} : p.model.sections[0].fluid.value_or(SectionInFluid{});
}

using Sees = std::function<bool(const Problem&)>;

RoundTrip trip(const std::string& key, const std::string& deck, const Sees& sees) {
    return {key, deck, sees};
}

Vec3 flow_at(const Flow& flow, double time, const Vec3& place) {
    return flow.field ? flow.field(time, place) : Vec3(Vec3::Zero());
}

// The factor of water or ground at a time of a stage.
template <class Part>
double factor_in(const Problem& p, std::size_t stage, double time, std::optional<Part> Surroundings::*part) {
    const Surroundings& around = stage == 0 ? p.model.surroundings : p.stages.at(stage).actions.surroundings;
    return (around.*part)->factor(time);
}

template <class Part>
std::vector<RoundTrip> presence_trips(const std::string& key,
                                      const std::string& table,
                                      std::optional<Part> Surroundings::*part) {
    return {trip(key + ".factor",
                 staged_tube_deck() + table + "factor = { hang = \"0.5*t\", calm = 2 }\n",
                 [=](const Problem& p) {
                     return p.stages.size() == 3 && factor_in(p, 0, 0.5, part) == 0.25 &&
                            factor_in(p, 2, 0.5, part) == 2.0;
                 }),
            trip(key + ".stages", staged_tube_deck() + table + "stages = \"storm\"\n", [=](const Problem& p) {
                return p.stages.size() == 3 && factor_in(p, 0, 1.0, part) == 0.0 &&
                       factor_in(p, 1, 1.0, part) == 1.0 && factor_in(p, 2, 1.0, part) == 0.0;
            })};
}

std::vector<RoundTrip> flow_trips(const std::string& key,
                                  const std::string& begin,
                                  const std::function<Flow(const Problem&)>& flow) {
    const std::string table = "table = [[-10, 1], [0, 3]], direction = [0, 2, 0]";
    const auto with = [=](const std::string& keys) { return tube_deck() + begin + " = { " + keys + " }\n"; };
    const std::string staged = staged_tube_deck() + begin + " = { " + table + ", stages = \"storm\" }\n";
    return {
        trip(key + ".table",
             with(table),
             [=](const Problem& p) {
                 const Flow f = flow(p);
                 return f.profile && f.profile->heights.at(1) == 0.0 && f.profile->speeds.at(1) == 3.0;
             }),
        trip(key + ".direction",
             with(table),
             [=](const Problem& p) {
                 const Flow f = flow(p);
                 return f.profile && f.profile->direction == Vec3(0, 1, 0);
             }),
        trip(key + ".velocity",
             with("velocity = [\"x*t\", 2, \"z\"]"),
             [=](const Problem& p) { return flow_at(flow(p), 3.0, Vec3(4, 5, 6)) == Vec3(12.0, 2.0, 6.0); }),
        trip(key + ".factor",
             with(table + ", factor = \"2*t\""),
             [=](const Problem& p) { return flow(p).profile && flow(p).profile->factor(3.0) == 6.0; }),
        trip(key + ".stages", staged, [=](const Problem& p) {
            if (p.stages.size() < 2 || !flow(p).is_still()) return false;
            Problem second = p;
            second.model.surroundings = p.stages[1].actions.surroundings;
            return flow(second).profile.has_value();
        })};
}

std::vector<RoundTrip> water_trips() {
    const auto with = [](const std::string& line) { return tube_deck() + water_deck + line; };
    const std::string airy = "[[wave]]\nairy = { height = 2, period = 8 }\n";
    std::vector<RoundTrip> trips{
        trip("fluid.density", with(""), [](const Problem& p) { return water_of(p).density == 1000.0; }),
        trip("fluid.surface",
             replaced(with(""), "surface = 0", "surface = 7"),
             [](const Problem& p) { return water_of(p).surface == 7.0; }),
        trip("fluid.depth",
             with("depth = 50\n" + airy),
             [](const Problem& p) { return water_of(p).depth == 50.0; }),
        trip("fluid.stretching",
             with("stretching = \"extrapolate\"\n"),
             [](const Problem& p) { return water_of(p).stretching == Stretching::extrapolate; }),
        trip("fluid.current_stretching",
             with("current_stretching = true\ncurrent = { table = [[0, 1]], direction = [1, 0, 0] }\n"),
             [](const Problem& p) { return water_of(p).stretches_current; }),
        trip("fluid.ramp", with("ramp = 7\n" + airy), [](const Problem& p) {
            return water_of(p).ramp == 7.0;
        })};
    for (RoundTrip& one : presence_trips("fluid", water_deck, &Surroundings::water))
        trips.push_back(std::move(one));
    for (RoundTrip& one : flow_trips(
             "fluid.current", water_deck + "current", [](const Problem& p) { return water_of(p).current; }))
        trips.push_back(std::move(one));
    return trips;
}

std::vector<RoundTrip> wave_trips() {
    const auto with = [](const std::string& lines) {
        return tube_deck() + water_deck + "[[wave]]\n" + lines;
    };
    const auto waves = [](const Problem& p) { return water_of(p).waves; };
    const auto first = [=](const Problem& p) { return waves(p).empty() ? WaveTrain{} : waves(p).front(); };
    const auto airy = [&](const std::string& keys) { return with("airy = { height = 2, period = 8" + keys); };
    const auto sea = [&](const std::string& keys) { return with("jonswap = { Hs = 4, Tp = 10" + keys); };
    const auto height = [=](const Problem& p) {
        double variance = 0.0;
        for (const WaveTrain& train : waves(p)) variance += 0.5 * train.amplitude * train.amplitude;
        return 4.0 * std::sqrt(variance);
    };
    // Differs from the sea of the deck with the key's default.
    const auto differs = [=](const std::string& usual) {
        return [=](const Problem& p) {
            const std::vector<WaveTrain> others = waves(read(usual));
            if (waves(p).size() != others.size()) return false;
            return first(p).frequency != others[0].frequency || first(p).phase != others[0].phase;
        };
    };
    const std::string record = "elevation = { file = \"" + folder + "eta.csv\"";
    return {
        trip("wave.airy.height", airy(" }\n"), [=](const Problem& p) { return first(p).amplitude == 1.0; }),
        trip("wave.airy.period",
             airy(" }\n"),
             [=](const Problem& p) { return is_near(first(p).frequency, 2.0 * M_PI / 8.0); }),
        trip("wave.airy.phase",
             airy(", phase = 0.5 }\n"),
             [=](const Problem& p) { return first(p).phase == 0.5; }),
        trip("wave.jonswap.Hs",
             sea(" }\n"),
             [=](const Problem& p) { return std::abs(height(p) - 4.0) < 1e-9; }),
        trip("wave.jonswap.Tp", replaced(sea(" }\n"), "Tp = 10", "Tp = 5"), differs(sea(" }\n"))),
        trip("wave.jonswap.gamma", sea(", gamma = 1 }\n"), differs(sea(" }\n"))),
        trip("wave.jonswap.components",
             sea(", components = 7 }\n"),
             [=](const Problem& p) { return waves(p).size() == 7; }),
        trip("wave.jonswap.seed", sea(", seed = 2 }\n"), differs(sea(" }\n"))),
        trip("wave.elevation.file",
             with(record + " }\n"),
             [=](const Problem& p) { return !waves(p).empty() && first(p).amplitude > 0.0; }),
        trip("wave.elevation.at", with(record + ", at = [10, 0, 0] }\n"), differs(with(record + " }\n"))),
        trip("wave.elevation.shortest_period",
             with(record + ", shortest_period = 6 }\n"),
             [=](const Problem& p) {
                 return !waves(p).empty() && waves(p).back().frequency <= 2.0 * M_PI / 6;
             }),
        trip("wave.elevation.longest_period",
             with(record + ", longest_period = 6 }\n"),
             [=](const Problem& p) { return !waves(p).empty() && first(p).frequency >= 2.0 * M_PI / 6; }),
        trip("wave.jonswap.spreading",
             sea(", spreading = 5 }\n"),
             [=](const Problem& p) { return first(p).direction != 0.0; }),
        trip("wave.direction",
             with("airy = { height = 2, period = 8 }\ndirection = [0, 3, 0]\n"),
             [=](const Problem& p) { return is_near(first(p).direction, 0.5 * M_PI); }),
        trip("wave.stages",
             staged_tube_deck() + water_deck +
                 "[[wave]]\nairy = { height = 2, period = 8 }\nstages = \"calm\"\n",
             [=](const Problem& p) {
                 if (p.stages.size() < 3 || !waves(p).empty()) return false;
                 const auto of = [&](std::size_t i) { return p.stages[i].actions.surroundings.water->waves; };
                 return of(1).empty() && of(2).size() == 1;
             })};
}

std::vector<RoundTrip> air_trips() {
    const std::string begin = "[air]\ndensity = 1.2\n";
    std::vector<RoundTrip> trips{
        trip("air.density", tube_deck() + begin, [](const Problem& p) { return air_of(p).density == 1.2; })};
    for (RoundTrip& one :
         flow_trips("air.wind", begin + "wind", [](const Problem& p) { return air_of(p).wind; }))
        trips.push_back(std::move(one));
    return trips;
}

std::vector<RoundTrip> bed_trips() {
    const auto with = [](const std::string& lines) {
        return tube_deck() + "[seabed]\nstiffness = 5e4\n" + lines;
    };
    const auto friction = [&](const std::string& value) {
        return with("z = -5\nfriction = " + value + "\n");
    };
    const std::string all = "{ axial = 0.3, lateral = 0.6, stiffness = 7 }";
    const std::string plane = "plane = { point = [1, 2, 3], normal = [3, 0, 4] }\n";
    std::vector<RoundTrip> trips{
        trip("seabed.z", with("z = -5\n"), [](const Problem& p) { return bed_of(p).point.z() == -5.0; }),
        trip("seabed.plane.point", with(plane), [](const Problem& p) { return bed_of(p).point.y() == 2.0; }),
        trip("seabed.plane.normal",
             with(plane),
             [](const Problem& p) { return (bed_of(p).normal - Vec3(0.6, 0.0, 0.8)).norm() < 1e-15; }),
        trip("seabed.grid.file",
             with("grid = { file = \"" + folder + "bed.csv\" }\n"),
             [](const Problem& p) { return bed_of(p).grid && bed_of(p).grid->z.at(2) == -12.0; }),
        trip("seabed.stiffness",
             with("z = -5\n"),
             [](const Problem& p) { return bed_of(p).stiffness == 5e4; }),
        trip("seabed.damping",
             with("z = -5\ndamping = 7\n"),
             [](const Problem& p) { return bed_of(p).damping == 7.0; }),
        trip("seabed.friction",
             friction("0.5"),
             [](const Problem& p) {
                 return bed_of(p).axial_friction == 0.5 && bed_of(p).lateral_friction == 0.5 &&
                        bed_of(p).friction_stiffness == 5e4;
             }),
        trip("seabed.friction.axial",
             friction(all),
             [](const Problem& p) { return bed_of(p).axial_friction == 0.3; }),
        trip("seabed.friction.lateral",
             friction(all),
             [](const Problem& p) { return bed_of(p).lateral_friction == 0.6; }),
        trip("seabed.friction.stiffness",
             friction(all),
             [](const Problem& p) { return bed_of(p).friction_stiffness == 7.0; }),
        trip("seabed.friction.stages",
             staged_tube_deck() +
                 "[seabed]\nz = -5\nstiffness = 5e4\nfriction = { axial = 0.3, lateral = 0.6, "
                 "stages = \"calm\" }\n",
             [](const Problem& p) {
                 if (p.stages.size() < 3 || bed_of(p).axial_friction != 0.0) return false;
                 const auto of = [&](std::size_t i) {
                     return p.stages[i].actions.surroundings.seabed->axial_friction;
                 };
                 return of(1) == 0.0 && of(2) == 0.3;
             })};
    for (RoundTrip& one :
         presence_trips("seabed", "[seabed]\nz = -5\nstiffness = 5e4\n", &Surroundings::seabed))
        trips.push_back(std::move(one));
    return trips;
}

std::vector<RoundTrip> coefficient_trips(const std::string& key,
                                         const std::function<Vec3(const Problem&)>& value) {
    const auto with = [=](const std::string& keys) {
        return tube_deck("fluid = { " + key + " = " + keys + " }") + water_deck;
    };
    const std::string path = "section.NAME.fluid." + key;
    const double usual = key == "drag" ? 1.2 : 1.0;
    return {
        trip(path, with("7"), [=](const Problem& p) { return value(p) == Vec3(0, 7, 7); }),
        trip(path + ".normal",
             with("{ normal = 7 }"),
             [=](const Problem& p) { return value(p) == Vec3(0, 7, 7); }),
        trip(path + ".tangential",
             with("{ tangential = 7 }"),
             [=](const Problem& p) { return value(p) == Vec3(7, usual, usual); }),
        trip(path + ".x",
             with("{ x = 7 }"),
             [=](const Problem& p) { return value(p) == Vec3(7, usual, usual); }),
        trip(path + ".y", with("{ y = 7 }"), [=](const Problem& p) { return value(p) == Vec3(0, 7, usual); }),
        trip(
            path + ".z", with("{ z = 7 }"), [=](const Problem& p) { return value(p) == Vec3(0, usual, 7); })};
}

std::vector<RoundTrip> wet_section_trips() {
    const auto with = [](const std::string& keys) {
        return tube_deck("fluid = { " + keys + " }") + water_deck;
    };
    const std::string path = "section.NAME.fluid.";
    const std::string contents = "contents = { density = 900, pressure = 5, inner_diameter = 0.3 }";
    std::vector<RoundTrip> trips{
        trip(path + "outer_diameter",
             with("outer_diameter = 0.7"),
             [](const Problem& p) {
                 return section_of(p).diameter == 0.7 && is_near(section_of(p).area, M_PI * 0.35 * 0.35);
             }),
        trip(path + "area", with("area = 7"), [](const Problem& p) { return section_of(p).area == 7.0; }),
        trip(path + "contents.density",
             with(contents),
             [](const Problem& p) { return section_of(p).contents_density == 900.0; }),
        trip(path + "contents.pressure",
             with(contents),
             [](const Problem& p) { return section_of(p).contents_pressure == 5.0; }),
        trip(path + "contents.inner_diameter",
             with(contents),
             [](const Problem& p) { return is_near(section_of(p).contents_area, M_PI * 0.15 * 0.15); }),
        trip(path + "contents.velocity",
             with("contents = { density = 900, inner_diameter = 0.3, velocity = 2 }"),
             [](const Problem& p) {
                 const auto flows = [](const auto& one) {
                     return one.key == "section.s.fluid.contents.velocity";
                 };
                 return std::ranges::count_if(p.model.loads, flows) == 2 &&
                        std::ranges::count_if(p.model.actuations, flows) == 1 &&
                        std::ranges::count_if(p.model.distributed_loads, flows) == 1;
             }),
        trip(path + "poisson", with("poisson = 0.3"), [](const Problem& p) {
            return section_of(p).poisson == 0.3;
        })};
    for (RoundTrip& one : coefficient_trips("drag", [](const Problem& p) { return section_of(p).drag; }))
        trips.push_back(std::move(one));
    for (RoundTrip& one :
         coefficient_trips("added_mass", [](const Problem& p) { return section_of(p).added_mass; }))
        trips.push_back(std::move(one));
    return trips;
}

std::vector<RoundTrip> wet_body_trips() {
    const auto with = [](const std::string& keys) {
        return replaced(body_deck, "[analysis]", "fluid = { volume = 2" + keys + " }\n[analysis]") +
               "[fluid]\ndensity = 1000\n";
    };
    const auto fluid = [](const Problem& p) { return p.model.bodies.at(0).fluid.value_or(BodyInFluid{}); };
    const std::string path = "body.NAME.fluid.";
    return {
        trip(path + "volume", with(""), [=](const Problem& p) { return fluid(p).volume == 2.0; }),
        trip(path + "centre_of_buoyancy",
             with(", centre_of_buoyancy = [1, 2, 3]"),
             [=](const Problem& p) { return fluid(p).centre == Vec3(1, 2, 3); }),
        trip(path + "height", with(", height = 7"), [=](const Problem& p) { return fluid(p).height == 7.0; }),
        trip(path + "drag_area",
             with(", drag_area = [1, 2, 3]"),
             [=](const Problem& p) { return fluid(p).drag_area == Vec3(1, 2, 3); }),
        trip(path + "drag_coefficient",
             with(", drag_area = [1, 2, 3], drag_coefficient = 2"),
             [=](const Problem& p) { return fluid(p).drag_area == Vec3(2, 4, 6); }),
        trip(path + "added_mass",
             with(", added_mass = [1, 2, 3]"),
             [=](const Problem& p) {
                 return fluid(p).added_mass(1, 1) == 2.0 && fluid(p).added_mass(4, 4) == 0.0;
             }),
        trip(path + "added_mass_matrix",
             with(", added_mass_matrix = [[1, 0, 0, 0, 0, 0], [0, 2, 0, 0, 0, 1], [0, 0, 3, 0, 0, 0], "
                  "[0, 0, 0, 4, 0, 0], [0, 0, 0, 0, 5, 0], [0, 1, 0, 0, 0, 6]]"),
             [=](const Problem& p) {
                 return fluid(p).added_mass(1, 5) == 1.0 && fluid(p).added_mass(4, 4) == 5.0;
             })};
}

}  // namespace

std::vector<RoundTrip> surroundings_trips() {
    std::vector<RoundTrip> all;
    for (const auto& trips :
         {water_trips(), wave_trips(), air_trips(), bed_trips(), wet_section_trips(), wet_body_trips()})
        all.insert(all.end(), trips.begin(), trips.end());
    return all;
}

}  // namespace gxrod::test
