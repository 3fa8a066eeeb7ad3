#include "report/findings/mode_json.hpp"

#include <nlohmann/json.hpp>

#include "results/tables/shape_table.hpp"

namespace gxrod {

using Json = nlohmann::ordered_json;

namespace {

// Of each mode the part of the whole model's mass, or moment of inertia, in six directions; 0 where that has
// none.
Json share_masses(const std::vector<double>& masses, const std::vector<double>& total) {
    Json list = Json::array();
    for (std::size_t first = 0; first + 6 <= masses.size(); first += 6) {
        Json shares = Json::array();
        for (std::size_t i = 0; i < 6; ++i) {
            const double whole = total.at(i);
            shares.push_back(whole > 0.0 ? masses[first + i] / whole : 0.0);
        }
        list.push_back(shares);
    }
    return list;
}

}  // namespace

bool has_modes(const Hdf5Reader& file, const FoundStage& stage) {
    return stage.has(file, shape_words_name) && !stage.has(file, sweep_values_name);
}

std::size_t count_modes(const Hdf5Reader& file, const FoundStage& stage) {
    return file.size(stage.group() + "/" + shape_words_name).at(0);
}

Json describe_modes(const Hdf5Reader& file, const FoundStage& stage) {
    Json json{{"stage", stage.name}, {"kind", stage.kind}};
    json["words"] = file.texts(stage.group() + "/" + shape_words_name);
    for (const char* name : {"frequency", "omega", "growth", "damping_ratio", "factor"}) {
        if (stage.has(file, name)) json[name] = file.numbers(stage.group() + "/" + name);
    }
    if (stage.has(file, "effective_mass")) {
        json["mass_shares"] = share_masses(file.numbers(stage.group() + "/effective_mass"),
                                           file.numbers(stage.group() + "/total_mass"));
    }
    for (const char* name : {"complete", "unstable"}) {
        if (file.has_attribute(stage.group(), name)) json[name] = file.integer_attribute(stage.group(), name);
    }
    return json;
}

}  // namespace gxrod
