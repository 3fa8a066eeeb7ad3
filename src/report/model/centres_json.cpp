#include "report/model/centres_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "model/sections/section_centres.hpp"

namespace gxrod {

using Json = nlohmann::ordered_json;

namespace {

constexpr std::size_t most_centred_rods = 300;  // that have centres
constexpr std::size_t most_stations = 50;       // of a rod
constexpr std::size_t most_centre_rows = 50;

// Models that no deck has made may have no stiffness.
bool are_apart(const Section& section) {
    return section.stiffness.diagonal().minCoeff() > 0.0 &&
           SectionCentres(section.stiffness, section.mass).are_apart();
}

Json to_json(const SectionCentres& centres, const SectionPoint& point) {
    const SectionPoint at = centres.clean(point);
    return {at.x(), at.y()};
}

Json describe_station(const Section& section, double s) {
    const SectionCentres centres(section.stiffness, section.mass);
    const std::optional<SectionPoint>& mass = centres.centre_of_mass();
    return {{"s", s},
            {"shear", to_json(centres, centres.shear_centre())},
            {"tension", to_json(centres, centres.tension_centre())},
            {"mass", mass ? to_json(centres, *mass) : Json()},
            {"turn", centres.bending().turn}};
}

// Of a rod's nodes, evenly.
std::vector<std::size_t> choose_entries(const Rod& rod) {
    const std::size_t count = rod.varying.at_nodes.size();
    const std::size_t stations = std::min(count, most_stations);
    std::vector<std::size_t> entries;
    for (std::size_t i = 0; i < stations; ++i) entries.push_back(i * (count - 1) / (stations - 1));
    return entries;
}

Json describe_stations(const Model& model, const Rod& rod) {
    Json stations = Json::array();
    if (!rod.has_varying_sections()) {
        const Section& section = model.sections[static_cast<std::size_t>(rod.section)];
        if (are_apart(section)) stations.push_back(describe_station(section, 0.0));
        return stations;
    }
    if (std::ranges::none_of(rod.varying.at_nodes, are_apart)) return stations;
    for (const std::size_t entry : choose_entries(rod))
        stations.push_back(describe_station(rod.varying.at_nodes[entry], rod.arc_length[entry]));
    return stations;
}

std::string describe_point(const SectionCentres& centres, const SectionPoint& point) {
    const SectionPoint at = centres.clean(point);
    return fmt::format("({:.6g}, {:.6g})", at.x(), at.y());
}

void add_row(const std::string& name, const Section& section, Json& rows) {
    if (rows.size() == most_centre_rows || !are_apart(section)) return;
    const SectionCentres centres(section.stiffness, section.mass);
    const std::optional<SectionPoint>& mass = centres.centre_of_mass();
    const PrincipalAxes& bending = centres.bending();
    rows.push_back({name,
                    describe_point(centres, centres.shear_centre()),
                    describe_point(centres, centres.tension_centre()),
                    mass ? describe_point(centres, *mass) : std::string(),
                    bending.turn * 180.0 / M_PI,
                    bending.about_y,
                    bending.about_z});
}

}  // namespace

Json describe_centres_along(const Model& model) {
    Json rods = Json::array();
    for (std::size_t i = 0; i < model.rods.size() && rods.size() < most_centred_rods; ++i) {
        Json stations = describe_stations(model, model.rods[i]);
        if (!stations.empty()) rods.push_back({{"rod", i}, {"stations", std::move(stations)}});
    }
    return rods;
}

Json describe_centre_table(const Model& model) {
    Json rows = Json::array();
    std::vector<bool> is_mean(model.sections.size(), false);
    for (const Rod& rod : model.rods) {
        if (rod.has_varying_sections()) is_mean[static_cast<std::size_t>(rod.section)] = true;
    }
    for (std::size_t i = 0; i < model.sections.size(); ++i) {
        if (!is_mean[i]) add_row(model.sections[i].name, model.sections[i], rows);
    }
    for (const Rod& rod : model.rods) {
        if (!rod.has_varying_sections()) continue;
        add_row(rod.name + ".start", rod.varying.at_nodes.front(), rows);
        add_row(rod.name + ".end", rod.varying.at_nodes.back(), rows);
    }
    return {{"title", "Centres of sections, (y, z) from the line"},
            {"columns",
             {"",
              "shear centre",
              "tension centre",
              "centre of mass",
              "axes of bending turned by, °",
              "EI about y",
              "EI about z"}},
            {"rows", rows}};
}

}  // namespace gxrod
