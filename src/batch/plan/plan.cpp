#include "batch/plan/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "batch/plan/faulty_plan.hpp"
#include "batch/plan/plan_schema.hpp"
#include "batch/plan/plan_tables.hpp"
#include "batch/plan/read_fatigue.hpp"
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

// nullopt where a value is at fault.
std::optional<Collection> read_collection(const CollectTable& table, FaultList& faults) {
    if (std::find(reserved_names.begin(), reserved_names.end(), table.name) != reserved_names.end()) {
        faults.add(
            table.place, table.path, "every table has a column of this name already; take another one");
    }
    const bool is_of_stage = table.gives(table.stage);
    const auto refuse = [&](const auto& field) {
        if (!table.gives(field)) return;
        faults.add(table.place_of(&field),
                   table.path_of(&field),
                   "is for histories and the ledger, not for what a stage finds");
    };
    if (is_of_stage) {
        refuse(table.component);
        refuse(table.take);
        refuse(table.at);
        refuse(table.damage);
        refuse(table.range);
    }
    const auto is_read = [&](const auto& field) { return !table.gives(field) || field.has_value(); };
    const bool is_whole = is_of_stage ? table.gives(table.found)
                                      : table.gives(table.history) != table.gives(table.ledger) &&
                                            table.gives(table.take) + table.gives(table.at) +
                                                    table.gives(table.damage) + table.gives(table.range) ==
                                                1;
    const bool is_right = is_whole && is_read(table.stage) && is_read(table.found) &&
                          is_read(table.history) && is_read(table.ledger) && is_read(table.component) &&
                          is_read(table.take) && is_read(table.at) && is_read(table.damage) &&
                          is_read(table.range) && (!table.gives(table.history) || table.quantity.has_value());
    if (!is_right) return std::nullopt;
    Collection collection;
    collection.name = table.name;
    collection.place = table.place;
    collection.stage = table.stage.value_or("");
    if (table.found) collection.found = table.found->word;
    collection.number = table.number;
    collection.history = table.history.value_or("");
    if (table.history) collection.quantity = table.quantity->word;
    if (table.ledger)
        collection.ledger =
            std::ranges::find(ledger_columns, table.ledger->word, [](const LedgerColumn& column) {
                return std::string(column.name);
            });
    collection.component = table.component;
    collection.take = table.take.value_or(collection.take);
    collection.at = table.at;
    if (table.damage || table.range) {
        collection.fatigue = read_fatigue(table, faults);
        if (!collection.fatigue) return std::nullopt;
    }
    collection.reference = table.reference;
    return collection;
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

void take_settings(const PlanTable& given, Plan& plan) {
    plan.combination = given.combine;
    if (plan.combination == Combination::latin_hypercube) {
        plan.count = given.count.value_or(plan.count);
        plan.seed = static_cast<std::uint64_t>(given.seed);
    }
    plan.time_limit = given.time_limit.value_or(plan.time_limit);
    if (given.memory_limit) plan.memory_limit = *given.memory_limit * bytes_in_gigabyte;
    if (given.keep) plan.keeping = given.keep->results;
}

// Whether there is the file that a field names.
bool check_file(const std::filesystem::path& file,
                const std::optional<std::string>& field,
                const PlanTable& given,
                FaultList& faults) {
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored)) return true;
    faults.add(given.place_of(&field),
               given.path_of(&field),
               fmt::format("there is no file {}; it is looked for from the plan's folder", file.string()));
    return false;
}

}  // namespace

std::string read_plan_file(const std::filesystem::path& file) {
    return read_text_file(file, "a plan or a deck", most_deck_bytes);
}

Plan read_plan(const std::filesystem::path& file) { return read_plan_text(read_plan_file(file), file); }

namespace {

void read_cases(const PlanTable& given, Plan& plan, FaultList& faults) {
    const DeckEntry* vary = plan.tree.find("vary");
    if (vary != nullptr && vary->node.table() != nullptr)
        plan.variations = read_variations(vary->node, plan.combination, faults);
    if (plan.combination == Combination::table) {
        if (given.table) {
            plan.table = std::filesystem::path(plan.file).parent_path() / *given.table;
            if (check_file(plan.table, given.table, given, faults))
                read_table_columns(plan.table, given.place_of(&given.table), plan.variations, faults);
        }
    } else if (plan.variations.empty() && (vary == nullptr || vary->node.table() != nullptr)) {
        faults.add(vary == nullptr ? given.place : vary->node.place,
                   "vary",
                   "missing or empty; expected what differs from case to case");
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
    const auto& given = static_cast<const PlanTable&>(*checked.record);
    take_settings(given, plan);
    bool has_deck = false;
    if (given.deck) {
        plan.decks = {file.parent_path() / *given.deck};
        has_deck = check_file(plan.decks[0], given.deck, given, faults);
    }
    read_cases(given, plan, faults);
    for (const CheckedTable& table : checked.tables("collect")) {
        const std::optional<Collection> collection =
            read_collection(static_cast<const CollectTable&>(*table.record), faults);
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

std::optional<Plan> plan_of_combinations(const std::string& text, const std::filesystem::path& deck) {
    const DeckNode tree = read_toml(text, deck.string());
    const DeckEntry* combinations = tree.find("combination");
    if (combinations == nullptr || combinations->node.table() == nullptr) return std::nullopt;
    std::vector<std::string> names;
    for (const DeckEntry& one : *combinations->node.table()) names.push_back("\"" + one.key + "\"");
    if (names.empty()) return std::nullopt;
    return read_plan_text(
        fmt::format(
            "deck = \"{}\"\n[vary]\napply = [{}]\n", deck.filename().string(), fmt::join(names, ", ")),
        deck);
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
