#include "deck/reading/row_reader.hpp"

#include <fmt/format.h>

namespace gxrod {

template <class Read>
bool RowReader::fractions(const DeckNode& node, const std::string& path, const Read& read) const {
    if (node.array() == nullptr || node.array()->size() < 2) {
        expect(node, path, describe_expected(key_));
        return false;
    }
    bool complete = true;
    std::optional<double> last;
    const std::size_t count = node.array()->size();
    for (std::size_t i = 0; i < count; ++i) {
        const DeckNode& row = (*node.array())[i];
        const std::string row_path = fmt::format("{}[{}]", path, i);
        if (!is_array_of(row, 2)) {
            expect(row, row_path, "a row of 2");
            complete = false;
            continue;
        }
        const std::optional<double> fraction = finite_number((*row.array())[0], row_path + "[0]");
        complete = fraction && read((*row.array())[1], row_path + "[1]", *fraction) && complete;
        if (!fraction) continue;
        const bool is_end = i == 0 || i + 1 == count;
        const double end = i == 0 ? 0.0 : 1.0;
        if (is_end && *fraction != end) {
            add(row, row_path, fmt::format("expected the fraction {} here, found {}", end, *fraction));
            complete = false;
        } else if (last && *fraction < *last) {
            add(row,
                row_path,
                fmt::format("fractions must not fall from row to row: {} follows {}", *fraction, *last));
            complete = false;
        }
        last = fraction;
    }
    return complete;
}

std::optional<TimeTable> RowReader::time_table(const DeckNode& node, const std::string& path) const {
    if (node.array() == nullptr || node.array()->empty()) {
        expect(node, path, describe_expected(key_));
        return std::nullopt;
    }
    TimeTable table;
    bool complete = true;
    for (std::size_t i = 0; i < node.array()->size(); ++i) {
        const DeckNode& row = (*node.array())[i];
        const auto values = table_row(row, fmt::format("{}[{}]", path, i), "a row [t, value]");
        complete = complete && values;
        if (!complete) continue;
        if (!table.empty() && values->first <= table.back().first) {
            add(row,
                fmt::format("{}[{}]", path, i),
                fmt::format(
                    "t must increase from row to row: {} follows {}", values->first, table.back().first));
            complete = false;
        }
        table.push_back(*values);
    }
    return complete ? std::optional(std::move(table)) : std::nullopt;
}

std::optional<CheckedPairs> RowReader::pairs(const DeckNode& node, const std::string& path) const {
    if (node.array() == nullptr || node.array()->empty()) {
        expect(node, path, describe_expected(key_));
        return std::nullopt;
    }
    CheckedPairs pairs;
    for (std::size_t i = 0; i < node.array()->size(); ++i) {
        const DeckNode& row = (*node.array())[i];
        const auto values = table_row(row, fmt::format("{}[{}]", path, i), "a row of 2 numbers");
        if (values) pairs.rows.push_back(*values);
        pairs.places.push_back(row.place);
    }
    return pairs.rows.size() == node.array()->size() ? std::optional(std::move(pairs)) : std::nullopt;
}

std::optional<CheckedProfile> RowReader::profile(const DeckNode& node, const std::string& path) const {
    CheckedProfile profile;
    const auto read = [&](const DeckNode& value, const std::string& value_path, double fraction) {
        const std::optional<double> read_number = number(value, value_path);
        if (read_number) profile.rows.emplace_back(fraction, *read_number);
        return read_number.has_value();
    };
    return fractions(node, path, read) ? std::optional(std::move(profile)) : std::nullopt;
}

std::optional<std::vector<CheckedStation>> RowReader::stations(const DeckNode& node,
                                                               const std::string& path) const {
    std::vector<CheckedStation> stations;
    const auto read = [&](const DeckNode& name, const std::string& name_path, double fraction) {
        if (name.text() == nullptr) {
            expect(name, name_path, "the name of a section");
            return false;
        }
        stations.push_back({fraction, {*name.text(), name.place, name_path}});
        return true;
    };
    return fractions(node, path, read) ? std::optional(std::move(stations)) : std::nullopt;
}

std::optional<CheckedTendonPath> RowReader::tendon_path(const DeckNode& node, const std::string& path) const {
    if (node.array() != nullptr && !node.array()->empty() && node.array()->front().array() != nullptr)
        return tendon_rows(node, path);
    if (!is_array_of(node, 2)) {
        expect(node, path, describe_expected(key_));
        return std::nullopt;
    }
    CheckedTendonPath checked;
    bool complete = true;
    for (std::size_t i = 0; i < 2; ++i) {
        auto value = arc_number((*node.array())[i], fmt::format("{}[{}]", path, i));
        if (!value) {
            complete = false;
        } else if (auto* function = std::get_if<CheckedArcFunction>(&*value)) {
            checked.functions[i] = std::move(function->function);
        } else {
            checked.functions[i] = [number = std::get<double>(*value)](double) { return number; };
        }
    }
    return complete ? std::optional(std::move(checked)) : std::nullopt;
}

std::optional<CheckedTendonPath> RowReader::tendon_rows(const DeckNode& node, const std::string& path) const {
    CheckedTendonPath checked;
    bool complete = node.array()->size() >= 2;
    if (!complete) expect(node, path, describe_expected(key_));
    for (std::size_t i = 0; i < node.array()->size(); ++i) {
        const DeckNode& row = (*node.array())[i];
        const std::string row_path = fmt::format("{}[{}]", path, i);
        if (!is_array_of(row, 3)) {
            expect(row, row_path, "a row [fraction, y, z]");
            complete = false;
            continue;
        }
        const std::optional<Vec3> values = vector(row, row_path);
        complete = complete && values;
        if (!values) continue;
        const double fraction = (*values)[0];
        const double last = checked.rows.empty() ? -1.0 : checked.rows.back()[0];
        if (fraction < 0.0 || fraction > 1.0 || fraction <= last) {
            add(row,
                row_path,
                fmt::format("fractions must increase from row to row, from 0 to 1; found {}", fraction));
            complete = false;
        }
        checked.rows.push_back({fraction, (*values)[1], (*values)[2]});
    }
    return complete ? std::optional(std::move(checked)) : std::nullopt;
}

std::optional<std::pair<double, double>> RowReader::table_row(const DeckNode& row,
                                                              const std::string& path,
                                                              const std::string& expected) const {
    if (!is_array_of(row, 2)) {
        expect(row, path, expected);
        return std::nullopt;
    }
    const auto time = number((*row.array())[0], path + "[0]");
    const auto value = number((*row.array())[1], path + "[1]");
    if (!time || !value) return std::nullopt;
    return std::pair(*time, *value);
}

}  // namespace gxrod
