#include "batch/plan/read_variations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "batch/plan/latin_hypercube.hpp"
#include "batch/plan/plan_schema.hpp"
#include "batch/plan/plan_tables.hpp"
#include "batch/plan/value_range.hpp"
#include "deck/reading/validation.hpp"
#include "deck/schema/suggestion.hpp"
#include "deck/text/csv_reading.hpp"
#include "deck/text/override_key.hpp"
#include "deck/text/text_file.hpp"
#include "deck/text/toml_writing.hpp"
#include "machine/file_error.hpp"

namespace gxrod {
namespace {

std::string path_of(const std::string& key) { return fmt::format("vary.\"{}\"", key); }

// "a" and "b" of the combination that a kind of entry is for, if it is not for this one; else "".
std::string explain_combination(const VariationTable& entry, Combination combination) {
    const bool is_spread = entry.uniform || entry.normal || entry.lognormal;
    if (is_spread && combination != Combination::latin_hypercube) {
        return "a distribution is drawn from with combine = \"latin-hypercube\" only; expected a list of "
               "values or "
               "{ from, to, count }";
    }
    if (entry.column.has_value() != (combination == Combination::table)) {
        return combination == Combination::table
                   ? "with combine = \"table\" the values are in the table; expected { column = \"…\" }"
                   : "a column is taken with combine = \"table\" only; expected a list of values or { from, "
                     "to, count }";
    }
    return "";
}

class VariationReader {
  public:
    VariationReader(Combination combination, FaultList& faults)
        : combination_(combination), faults_(faults) {}

    Variation read(const DeckEntry& entry) {
        Variation variation{entry.key, entry.place, {}, {}, {}};
        path_ = path_of(entry.key);
        if (is_top_level_value(plan_schema(), entry.key)) {
            add(entry.place, explain_misplaced_key(entry.key, "[vary]"));
        } else if (!split_key(entry.key)) {
            add(entry.place, "not a key; expected one such as \"analysis.time_step\" or \"load[0].force\"");
        } else if (entry.node.array() != nullptr) {
            variation.values = read_list(entry.node);
        } else if (entry.node.table() != nullptr) {
            read_table(entry.node, variation);
        } else {
            add(entry.node.place,
                "expected a list of values, as in [1, 2, 3], or a table such as { from = 0, to = 1, count = "
                "5 }");
        }
        return variation;
    }

  private:
    void add(const Place& place, const std::string& message) { faults_.add(place, path_, message); }

    // A table of the deck, whose single keys [vary] has.
    static bool is_deck_table(const std::string& key) {
        const KeySpec* spec = deck_schema().find(key);
        return spec != nullptr && spec->table != nullptr;
    }

    void explain_quotes(const DeckNode& node, const std::string& key) {
        const std::string inner = node.table()->empty() ? "KEY" : node.table()->front().key;
        add(node.place, fmt::format("a key of the deck must be in quotes here: \"{}.{}\" = …", key, inner));
    }

    std::vector<std::string> read_list(const DeckNode& node) {
        if (combination_ == Combination::table) {
            add(node.place,
                "with combine = \"table\" the values are in the table; expected { column = \"…\" }");
            return {};
        }
        std::vector<std::string> values;
        for (const DeckNode& value : *node.array()) values.push_back(write_toml_value(value));
        if (values.empty()) add(node.place, "an empty list; expected one value at least");
        return values;
    }

    void read_table(const DeckNode& node, Variation& variation) {
        if (is_deck_table(variation.key)) return explain_quotes(node, variation.key);
        if (combination_ == Combination::latin_hypercube && node.find("from") && !node.find("count"))
            return add(node.place, "a sample between two numbers is uniform = { from = …, to = … }");
        const std::size_t before = faults_.count();
        const CheckedTable checked = check_table(node, path_, variation_table(), faults_);
        if (faults_.count() > before) return;
        const auto& entry = static_cast<const VariationTable&>(*checked.record);
        const std::string wrong = explain_combination(entry, combination_);
        if (!wrong.empty()) return add(node.place, wrong);
        if (entry.column) variation.values = {*entry.column};
        if (entry.from) variation.values = read_range(entry);
        if (entry.uniform) variation.spread = read_spread(*entry.uniform, {.kind = Spread::Kind::uniform});
        if (entry.normal) variation.spread = read_spread(*entry.normal, Spread::Kind::normal);
        if (entry.lognormal) variation.spread = read_spread(*entry.lognormal, Spread::Kind::lognormal);
    }

    std::vector<std::string> read_range(const VariationTable& entry) {
        const double from = *entry.from;
        const double to = *entry.to;
        const Spacing spacing = entry.spacing.value_or(Spacing::linear);
        if (from == to) {
            add(entry.place_of(&entry.to), "an empty range: from and to are the same");
            return {};
        }
        if (spacing == Spacing::log && !(from * to > 0.0)) {
            add(entry.place_of(&entry.from), "equal ratios need both ends positive, or both negative");
            return {};
        }
        std::vector<std::string> values;
        for (const double number : space_out(from, to, *entry.count, spacing))
            values.push_back(write_number(number));
        return values;
    }

    Spread read_spread(const NormalTable& table, Spread::Kind kind) {
        Spread spread{.kind = kind};
        spread.mean = table.mean;
        spread.deviation = table.deviation;
        return read_spread(table, spread);
    }

    // Takes the ends of a distribution.
    Spread read_spread(const UniformTable& table, Spread spread) {
        spread.from = table.from.value_or(spread.from);
        spread.to = table.to.value_or(spread.to);
        if (!(spread.from < spread.to)) {
            add(table.place_of(&table.to),
                fmt::format("an empty range: from {} to {}", spread.from, spread.to));
        }
        if (spread.from < spread.to && !(probability_within(spread) > 0.0)) {
            add(table.place,
                fmt::format(
                    "nothing of the distribution lies from {} to {}; its mean is {}, its deviation {}",
                    spread.from,
                    spread.to,
                    spread.mean,
                    spread.deviation));
        }
        return spread;
    }

    Combination combination_;
    FaultList& faults_;
    std::string path_;
};

std::size_t find_column(const CsvRow& header, const std::string& name) {
    return static_cast<std::size_t>(std::find(header.fields.begin(), header.fields.end(), name) -
                                    header.fields.begin());
}

void check_rows(const std::filesystem::path& file, const std::vector<CsvRow>& rows) {
    if (rows.size() < 2) {
        throw FileError(
            file, "has no rows", "expected a line with the names of the columns, then a row for each case");
    }
    if (rows[0].fields.size() == 1 && rows[0].fields[0].find(';') != std::string::npos) {
        throw FileError(fmt::format("{}:{}", file.string(), rows[0].line),
                        "has one column",
                        "columns are separated by commas, not by semicolons");
    }
    for (const CsvRow& row : rows) {
        if (row.fields.size() == rows[0].fields.size()) continue;
        throw FileError(fmt::format("{}:{}", file.string(), row.line),
                        fmt::format("has {} fields where the first line names {} columns",
                                    row.fields.size(),
                                    rows[0].fields.size()));
    }
    std::vector<std::string> names = rows[0].fields;
    std::sort(names.begin(), names.end());
    const auto twice = std::adjacent_find(names.begin(), names.end());
    if (twice == names.end()) return;
    throw FileError(fmt::format("{}:{}", file.string(), rows[0].line),
                    fmt::format("has two columns \"{}\"", *twice));
}

}  // namespace

std::vector<Variation> read_variations(const DeckNode& vary, Combination combination, FaultList& faults) {
    std::vector<Variation> variations;
    VariationReader reader(combination, faults);
    for (const DeckEntry& entry : *vary.table()) {
        const std::size_t before = faults.count();
        variations.push_back(reader.read(entry));
        variations.back().is_faulty = faults.count() > before;
    }
    return variations;
}

void check_conflicts(const std::vector<Variation>& variations, FaultList& faults) {
    std::vector<std::vector<KeyStep>> keys;
    for (const Variation& variation : variations) {
        const auto steps = split_key(variation.key);
        keys.push_back(steps.value_or(std::vector<KeyStep>{}));
        for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
            const std::size_t shared = std::min(keys[i].size(), keys.back().size());
            if (shared == 0 || !std::equal(keys[i].begin(),
                                           keys[i].begin() + static_cast<std::ptrdiff_t>(shared),
                                           keys.back().begin()))
                continue;
            faults.add(variation.place,
                       path_of(variation.key),
                       fmt::format("\"{}\" is varied too, and has the same value", variations[i].key));
        }
    }
}

void read_table_columns(const std::filesystem::path& table,
                        const Place& place,
                        std::vector<Variation>& variations,
                        FaultList& faults) {
    const std::vector<CsvRow> rows = read_csv(read_text_file(table, "a table"), table);
    check_rows(table, rows);
    const CsvRow& header = rows[0];
    if (variations.empty()) {
        for (const std::string& name : header.fields) {
            if (!split_key(name)) {
                faults.add(place,
                           "table",
                           fmt::format("column \"{}\" is no key of a deck; [vary] can say which key takes it",
                                       name));
            }
            variations.push_back({name, place, {name}, {}, {}, !split_key(name)});
        }
    }
    for (Variation& variation : variations) {
        if (variation.values.empty()) continue;  // at fault already
        const std::string column = std::exchange(variation.values, {}).front();
        const std::size_t index = find_column(header, column);
        if (index == header.fields.size()) {
            faults.add(variation.place,
                       path_of(variation.key),
                       fmt::format("{} has no column \"{}\"; it has {}{}",
                                   table.string(),
                                   column,
                                   quoted_list(header.fields),
                                   did_you_mean(column, header.fields)));
            continue;
        }
        variation.column = Column{column, header.line, {}};
        for (std::size_t i = 1; i < rows.size(); ++i) {
            variation.values.push_back(rows[i].fields[index]);
            variation.column->lines.push_back(rows[i].line);
        }
    }
}

}  // namespace gxrod
