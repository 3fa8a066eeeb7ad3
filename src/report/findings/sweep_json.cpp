#include "report/findings/sweep_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "results/tables/shape_table.hpp"

namespace gxrod {

using Json = nlohmann::ordered_json;

namespace {

Json list_by_mode(const std::vector<double>& values, std::size_t modes) {
    Json lists = Json::array();
    for (std::size_t mode = 0; mode < modes; ++mode) {
        Json list = Json::array();
        for (std::size_t i = mode; i < values.size(); i += modes)
            list.push_back(std::isfinite(values[i]) ? Json(values[i]) : Json(nullptr));
        lists.push_back(std::move(list));
    }
    return lists;
}

Json list_onsets(const Hdf5Reader& file, const std::string& group) {
    const std::vector<double> values = file.numbers(group + "/value");
    const std::vector<double> omegas = file.numbers(group + "/omega");
    const std::vector<double> begins = file.numbers(group + "/begins");
    const std::vector<std::string> kinds = file.texts(group + "/kind");
    Json onsets = Json::array();
    for (std::size_t i = 0; i < values.size(); ++i) {
        onsets.push_back({{"value", values[i]},
                          {"omega", omegas.at(i)},
                          {"kind", kinds.at(i)},
                          {"begins", begins.at(i) != 0.0}});
    }
    return onsets;
}

}  // namespace

bool has_sweep(const Hdf5Reader& file, const FoundStage& stage) { return stage.has(file, sweep_values_name); }

std::size_t count_sweep_shapes(const Hdf5Reader& file, const FoundStage& stage) {
    return stage.has(file, "scale") ? file.size(stage.group() + "/scale").at(0) : 0;
}

Json describe_sweep(const Hdf5Reader& file, const FoundStage& stage) {
    const std::string group = stage.group() + "/";
    const std::vector<std::string> words = file.texts(group + shape_words_name);
    Json json{{"stage", stage.name}, {"key", file.text_attribute(stage.group(), "key")}};
    json["values"] = file.numbers(group + sweep_values_name);
    json["speeds"] = file.numbers(group + "speed");
    json["words"] = words;
    // By mode; files of earlier versions have the words at the first value alone.
    Json by_mode = Json::array();
    if (stage.has(file, sweep_words_name)) {
        const std::vector<std::string> all = file.texts(group + sweep_words_name);
        for (std::size_t mode = 0; mode < words.size(); ++mode) {
            Json list = Json::array();
            for (std::size_t i = mode; i < all.size(); i += words.size()) list.push_back(all[i]);
            by_mode.push_back(std::move(list));
        }
    }
    json["words_at_values"] = by_mode;
    for (const char* name : {"omega", "growth"})
        json[name] = list_by_mode(file.numbers(group + name), words.size());
    json["onsets"] = stage.has(file, onsets_name) ? list_onsets(file, group + onsets_name) : Json::array();
    return json;
}

}  // namespace gxrod
