#include "batch/plan/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "batch/plan/faulty_plan.hpp"
#include "batch/plan/plan_schema.hpp"
#include "batch/plan/read_variations.hpp"
#include "deck/reading/validation.hpp"
#include "deck/text/csv_reading.hpp"
#include "deck/text/text_file.hpp"

namespace gxrod {
namespace {

constexpr double bytes_in_gigabyte = 1e9;

// Columns that every index has, and names that stand for something else.
constexpr std::array reserved_names{"case",
                                    "deck",
                                    "status",
                                    "reason",
                                    "steps",
                                    "newton_iterations",
                                    "rejected_steps",
                                    "time",
                                    "seconds",
                                    "results",
                                    "warning"};

// The value of a key that is given, or has a default, and is no fault; nullptr otherwise.
template <class Value>
const Value* find_value(const CheckedTable& table, std::string_view key) {
    const CheckedValue* found = table.find(key);
    return found == nullptr ? nullptr : std::get_if<Value>(&found->value);
}

// nullopt where a value is at fault.
std::optional<Collection> read_collection(const CheckedTable& table, FaultList& faults) {
    Collection collection;
    collection.name = table.name;
    collection.place = table.place;
    if (std::find(reserved_names.begin(), reserved_names.end(), table.name) != reserved_names.end()) {
        faults.add(
            table.place, table.path, "every table has a column of this name already; take another one");
    }
    const bool is_of_stage = table.gives("stage");
    for (const char* key : {"component", "take", "at"}) {
        if (!is_of_stage || !table.gives(key)) continue;
        faults.add(table.place_of(key),
                   table.path_of(key),
                   "is for histories and the ledger, not for what a stage finds");
    }
    bool is_right = is_of_stage ? table.gives("found")
                                : table.gives("history") != table.gives("ledger") &&
                                      table.gives("take") != table.gives("at");
    const auto take_word = [&](const char* key, const auto& take) {
        if (!table.gives(key)) return;
        const auto* word = find_value<std::string>(table, key);
        is_right = is_right && word != nullptr;
        if (word != nullptr) take(*word);
    };
    take_word("stage", [&](const std::string& word) { collection.stage = word; });
    take_word("found", [&](const std::string& word) { collection.found = word; });
    if (const auto* number = find_value<long>(table, "number")) collection.number = *number;
    take_word("history", [&](const std::string& word) { collection.history = word; });
    if (table.gives("history")) {
        is_right = is_right && table.gives("quantity");
        take_word("quantity", [&](const std::string& word) { collection.quantity = word; });
    }
    take_word("ledger", [&](const std::string& word) {
        collection.ledger = std::find_if(ledger_columns.begin(),
                                         ledger_columns.end(),
                                         [&](const auto& column) { return column.name == word; });
    });
    take_word("component",
              [&](const std::string& word) { collection.component = value_of(component_choices, word); });
    take_word("take", [&](const std::string& word) { collection.take = value_of(take_choices, word); });
    if (const auto* at = find_value<double>(table, "at")) collection.at = *at;
    if (const auto* reference = find_value<double>(table, "reference")) collection.reference = *reference;
    is_right = is_right && (!table.gives("at") || collection.at.has_value());
    return is_right ? std::optional(collection) : std::nullopt;
}

// Values that are taken together must be equally many.
void check_zip(const Plan& plan, FaultList& faults) {
    for (const Variation& variation : plan.variations) {
        const std::size_t wanted = plan.variations.front().values.size();
        if (variation.values.empty() || wanted == 0 || variation.values.size() == wanted) continue;
        faults.add(variation.place,
                   fmt::format("vary.\"{}\"", variation.key),
                   fmt::format("has {} values where \"{}\" has {}; combine = \"zip\" takes them together",
                               variation.values.size(),
                               plan.variations.front().key,
                               wanted));
    }
}

void check_column_name(const Collection& collection,
                       const std::vector<Variation>& variations,
                       FaultList& faults) {
    const bool is_taken = std::any_of(variations.begin(), variations.end(), [&](const Variation& variation) {
        return variation.key == collection.name;
    });
    if (!is_taken) return;
    faults.add(
        collection.place, collection.path(), "[vary] has a column of this name already; take another one");
}

void check_count(const Plan& plan, FaultList& faults) {
    double count = 1.0;
    if (plan.combination == Combination::grid) {
        for (const Variation& variation : plan.variations)
            count *= static_cast<double>(variation.values.size());
    } else if (!plan.variations.empty()) {
        count = static_cast<double>(plan.variations.front().values.size());
    }
    if (count <= static_cast<double>(largest_case_count)) return;
    faults.add({}, "", fmt::format("makes {:.0f} cases; {} at most are run", count, largest_case_count));
}

void take_settings(const CheckedTable& checked, Plan& plan) {
    if (const auto* word = find_value<std::string>(checked, "combine"))
        plan.combination = value_of(combination_choices, *word);
    if (plan.combination == Combination::latin_hypercube) {
        if (const auto* count = find_value<long>(checked, "count")) plan.count = *count;
        if (const auto* seed = find_value<long>(checked, "seed"))
            plan.seed = static_cast<std::uint64_t>(*seed);
    }
    if (const auto* limit = find_value<double>(checked, "time_limit")) plan.time_limit = *limit;
    if (const auto* limit = find_value<double>(checked, "memory_limit"))
        plan.memory_limit = *limit * bytes_in_gigabyte;
    if (checked.tables("keep").empty()) return;
    if (const auto* word = find_value<std::string>(checked.tables("keep").front(), "results"))
        plan.keeping = value_of(keeping_choices, *word);
}

// Whether there is the file that a key names.
bool check_file(const std::filesystem::path& file,
                const char* key,
                const CheckedTable& checked,
                FaultList& faults) {
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored)) return true;
    faults.add(checked.place_of(key),
               key,
               fmt::format("there is no file {}; it is looked for from the plan's folder", file.string()));
    return false;
}

}  // namespace

std::string read_plan_file(const std::filesystem::path& file) {
    return read_text_file(file, "a plan or a deck", most_deck_bytes);
}

Plan read_plan(const std::filesystem::path& file) { return read_plan_text(read_plan_file(file), file); }

namespace {

void read_cases(const CheckedTable& checked, Plan& plan, FaultList& faults) {
    const DeckEntry* vary = plan.tree.find("vary");
    if (vary != nullptr && vary->node.table() != nullptr)
        plan.variations = read_variations(vary->node, plan.combination, faults);
    if (plan.combination == Combination::table) {
        if (const auto* table = find_value<std::string>(checked, "table")) {
            plan.table = std::filesystem::path(plan.file).parent_path() / *table;
            if (check_file(plan.table, "table", checked, faults))
                read_table_columns(plan.table, checked.place_of("table"), plan.variations, faults);
        }
    } else if (plan.variations.empty() && (vary == nullptr || vary->node.table() != nullptr)) {
        faults.add(
            checked.place_of("vary"), "vary", "missing or empty; expected what differs from case to case");
    }
    if (plan.combination == Combination::zip) check_zip(plan, faults);
    check_count(plan, faults);
    check_conflicts(plan.variations, faults);
}

}  // namespace

Plan read_plan_text(std::string text, const std::filesystem::path& file) {
    Plan plan;
    plan.file = file.string();
    plan.text = std::move(text);
    plan.tree = read_toml(plan.text, plan.file);
    FaultList faults(plan.file, {});
    const CheckedTable checked = check_text(plan.tree, plan_schema(), faults);
    take_settings(checked, plan);
    bool has_deck = false;
    if (const auto* deck = find_value<std::string>(checked, "deck")) {
        plan.decks = {file.parent_path() / *deck};
        has_deck = check_file(plan.decks[0], "deck", checked, faults);
    }
    read_cases(checked, plan, faults);
    for (const CheckedTable& table : checked.tables("collect")) {
        const std::optional<Collection> collection = read_collection(table, faults);
        if (!collection) continue;
        plan.collections.push_back(*collection);
        check_column_name(plan.collections.back(), plan.variations, faults);
    }
    if (faults.empty()) return plan;
    // What is wrong with the rest, so that a user sees all of it at once.
    std::vector<DeckFault> all = faults.list();
    if (has_deck) {
        const std::vector<DeckFault> others = find_faults_of_cases(plan);
        all.insert(all.end(), others.begin(), others.end());
    }
    throw DeckError(std::move(all));
}

Plan plan_of_decks(std::vector<std::filesystem::path> decks) {
    Plan plan;
    plan.combination = Combination::decks;
    plan.tree = {DeckNode::Table{}, {}};
    plan.decks = std::move(decks);
    return plan;
}

bool is_plan(const std::filesystem::path& file) { return is_plan_text(read_plan_file(file), file); }

bool is_plan_text(const std::string& text, const std::filesystem::path& file) {
    const DeckNode tree = read_toml(text, file.string());
    const auto has = [&](const std::string& key) { return tree.find(key) != nullptr; };
    const auto& keys = plan_schema().keys;
    const bool has_any =
        std::any_of(keys.begin(), keys.end(), [&](const KeySpec& key) { return has(key.name); });
    if (has_any && !has("analysis")) return true;
    if (has("analysis") || has("rod") || has("body") || has("section")) return false;
    throw DeckError({{file.string(), 0, 0, "", "is neither a plan (deck, [vary]) nor a deck ([analysis])"}});
}

}  // namespace gxrod
