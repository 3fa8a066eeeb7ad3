#include "report/findings/stage_list.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace gxrod {

bool FoundStage::has(const Hdf5Reader& file, const std::string& member) const {
    return file.has(group() + "/" + member);
}

std::vector<FoundStage> list_stages(const Hdf5Reader& file) {
    std::vector<FoundStage> stages;
    if (!file.has("/stages")) return stages;
    for (const std::string& name : file.members("/stages")) {
        FoundStage stage{name, "", 0, 0};
        const auto read = [&](const char* attribute) {
            return static_cast<std::size_t>(
                std::max<std::int64_t>(0, file.integer_attribute(stage.group(), attribute)));
        };
        stage.kind = file.text_attribute(stage.group(), "kind");
        stage.number = read("number");
        stage.first_row = read("first_row");
        stages.push_back(std::move(stage));
    }
    std::sort(stages.begin(), stages.end(), [](const FoundStage& a, const FoundStage& b) {
        return a.number < b.number;
    });
    return stages;
}

std::size_t row_before(const FoundStage& stage) { return stage.first_row > 0 ? stage.first_row - 1 : 0; }

std::size_t find_row_of_state(const Hdf5Reader& file, const FoundStage& stage) {
    std::size_t row = row_before(stage);
    const std::string branches = "/histories/branch";
    if (!file.has(branches)) return row;
    const std::vector<double> of_rows = file.rows(branches, 0, row + 1, 1);
    while (row > 0 && of_rows[row] != 0.0) --row;
    return row;
}

nlohmann::ordered_json describe_stages(const Hdf5Reader& file,
                                       const std::vector<FoundStage>& stages,
                                       const std::vector<double>& times) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    if (!file.has("/histories/stage") || times.empty()) return list;
    const std::size_t last = times.size() - 1;
    for (std::size_t i = 0; i < stages.size(); ++i) {
        const std::size_t end = i + 1 < stages.size() ? row_before(stages[i + 1]) : last;
        list.push_back({{"name", stages[i].name},
                        {"kind", stages[i].kind},
                        {"from", times[std::min(row_before(stages[i]), last)]},
                        {"until", times[std::min(end, last)]}});
    }
    return list;
}

}  // namespace gxrod
