#include "deck/surroundings/rao_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "deck/text/table_files.hpp"
#include "machine/file_error.hpp"
#include "machine/printable.hpp"

namespace gxrod {
namespace {

constexpr std::array<const char*, 6> motion_words{"surge", "sway", "heave", "roll", "pitch", "yaw"};
// Frequencies of rows nearer than this are one.
constexpr double same_frequency = 1e-9;

[[noreturn]] void refuse_raos(const std::string& file, int line, const std::string& message) {
    throw FileError(fmt::format("{}:{}", file, line), message);
}

// Where a row puts the number of a column.
enum class RaoColumn { period, frequency, heading, amplitude, phase };
struct RaoPlace {
    RaoColumn column;
    std::size_t motion = 0;
};

RaoPlace find_rao_place(std::string word, int line, const std::string& file) {
    std::ranges::transform(word, word.begin(), [](unsigned char letter) { return std::tolower(letter); });
    if (word == "period") return {RaoColumn::period};
    if (word == "frequency") return {RaoColumn::frequency};
    if (word == "heading") return {RaoColumn::heading};
    for (std::size_t i = 0; i < 6; ++i) {
        if (word == motion_words[i]) return {RaoColumn::amplitude, i};
        if (word == std::string(motion_words[i]) + "_phase") return {RaoColumn::phase, i};
    }
    refuse_raos(
        file,
        line,
        fmt::format("no column \"{}\"; expected period (or frequency, rad a time), heading, and surge, "
                    "surge_phase, sway, sway_phase … yaw_phase",
                    shorten(word)));
}

std::vector<RaoPlace> find_rao_places(const FileTable& table, const std::string& file) {
    std::vector<RaoPlace> places;
    for (const std::string& word : table.header)
        places.push_back(find_rao_place(word, table.header_line, file));
    const auto count = [&](RaoColumn column, std::size_t motion) {
        return std::ranges::count_if(
            places, [&](const RaoPlace& place) { return place.column == column && place.motion == motion; });
    };
    if (count(RaoColumn::period, 0) + count(RaoColumn::frequency, 0) != 1 ||
        count(RaoColumn::heading, 0) != 1) {
        refuse_raos(file,
                    table.header_line,
                    "expected a header with one column period or frequency, and one column heading");
    }
    for (std::size_t i = 0; i < 6; ++i) {
        if (count(RaoColumn::amplitude, i) == count(RaoColumn::phase, i) && count(RaoColumn::phase, i) <= 1)
            continue;
        refuse_raos(file,
                    table.header_line,
                    fmt::format("expected a column {0} and one {0}_phase, or neither", motion_words[i]));
    }
    return places;
}

RaoRow read_rao_row(const CsvRow& row, const std::vector<RaoPlace>& places, const std::string& file) {
    if (row.fields.size() != places.size()) {
        refuse_raos(
            file, row.line, fmt::format("expected {} columns, found {}", places.size(), row.fields.size()));
    }
    RaoRow values{};
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::optional<double> value = read_finite(row.fields[i]);
        const bool is_time =
            places[i].column == RaoColumn::period || places[i].column == RaoColumn::frequency;
        if (!value || (is_time && *value <= 0.0)) {
            refuse_raos(file,
                        row.line,
                        fmt::format("expected a {} number, found \"{}\"",
                                    is_time ? "positive" : "finite",
                                    shorten(row.fields[i])));
        }
        const std::size_t motion = places[i].motion;
        if (places[i].column == RaoColumn::period) values.frequency = 2.0 * M_PI / *value;
        if (places[i].column == RaoColumn::frequency) values.frequency = *value;
        if (places[i].column == RaoColumn::heading) values.heading = *value;
        if (places[i].column == RaoColumn::amplitude) values.amplitudes[motion] = *value;
        if (places[i].column == RaoColumn::phase) values.phases[motion] = *value;
    }
    return values;
}

}  // namespace

std::vector<RaoRow> read_raos(std::string_view bytes, const std::string& file) {
    const FileTable table = read_file_table(bytes, file);
    if (table.header.empty()) {
        refuse_raos(file,
                    table.header_line,
                    "expected a first line that names the columns: period, heading, surge, surge_phase, …");
    }
    const std::vector<RaoPlace> places = find_rao_places(table, file);
    std::vector<RaoRow> rows;
    for (const CsvRow& row : table.rows) rows.push_back(read_rao_row(row, places, file));
    if (rows.empty()) refuse_raos(file, table.header_line, "expected rows below the header");
    std::ranges::sort(rows, [](const RaoRow& a, const RaoRow& b) {
        return std::tie(a.heading, a.frequency) < std::tie(b.heading, b.frequency);
    });
    const auto next =
        std::ranges::find_if(rows, [&](const RaoRow& row) { return row.heading != rows[0].heading; });
    const auto count = static_cast<std::size_t>(next - rows.begin());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const RaoRow& first = rows[i % count];
        const bool is_grid =
            rows.size() % count == 0 && rows[i].heading == rows[i / count * count].heading &&
            std::abs(rows[i].frequency - first.frequency) <= same_frequency * first.frequency;
        const bool is_new = i % count == 0 || rows[i].frequency > rows[i - 1].frequency;
        if (is_grid && is_new) continue;
        refuse_raos(file,
                    table.header_line,
                    fmt::format("expected each period once for each heading; heading {:.6g} differs from "
                                "heading {:.6g} at a period of {:.6g}",
                                rows[i].heading,
                                rows[0].heading,
                                2.0 * M_PI / rows[i].frequency));
    }
    return rows;
}

}  // namespace gxrod
