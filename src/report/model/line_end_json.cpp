#include "report/model/line_end_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "results/export/line_end_table.hpp"

namespace gxrod {
namespace {

constexpr std::size_t most_end_rows = 300;

std::string in_six_digits(double number) { return std::isnan(number) ? "" : fmt::format("{:.6g}", number); }

}  // namespace

nlohmann::ordered_json describe_line_ends(const Hdf5Reader& file) {
    if (!file.has("/histories/time") || file.size("/histories/time").at(0) == 0) return nullptr;
    const std::vector<LineEndRow> ends = find_line_ends(file, "", {});
    if (ends.empty()) return nullptr;
    auto rows = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < std::min(ends.size(), most_end_rows); ++i) {
        const LineEndRow& end = ends[i];
        std::string words = end.quantity + (end.dimension == "deg" ? ", deg" : "");
        std::ranges::replace(words, '_', ' ');
        rows.push_back({end.point,
                        words,
                        in_six_digits(end.at_rest),
                        in_six_digits(end.range.least),
                        in_six_digits(end.range.time_of_least),
                        in_six_digits(end.range.largest),
                        in_six_digits(end.range.time_of_largest),
                        in_six_digits(end.range.mean())});
    }
    const std::string left = ends.size() > most_end_rows
                                 ? fmt::format("The first {} of {} rows.", most_end_rows, ends.size())
                                 : "";
    return {{"title", "Ends of lines"},
            {"columns", {"", "quantity", "static", "least", "at", "largest", "at", "mean"}},
            {"rows", rows},
            {"note", left}};
}

}  // namespace gxrod
