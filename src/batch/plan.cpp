#include "batch/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "batch/plan_schema.hpp"
#include "batch/read_variations.hpp"
#include "deck/csv_reading.hpp"
#include "deck/text_file.hpp"
#include "deck/validation.hpp"

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

Collection read_collection(const CheckedTable& table, FaultList& faults) {
    Collection collection;
    collection.name = table.name;
    collection.place = table.place;
    if (std::find(reserved_names.begin(), reserved_names.end(), table.name) != reserved_names.end()) {
        faults.add(
            table.place, table.path, "every table has a column of this name already; take another one");
    }
    if (table.gives("history")) {
        collection.history = table.get<std::string>("history");
        if (table.gives("quantity"))
            collection.quantity = value_of(quantity_choices, table.get<std::string>("quantity"));
    }
    if (table.gives("ledger")) collection.ledger = value_of(ledger_choices, table.get<std::string>("ledger"));
    if (table.gives("component"))
        collection.component = value_of(component_choices, table.get<std::string>("component"));
    if (table.gives("take")) collection.take = value_of(take_choices, table.get<std::string>("take"));
    if (table.gives("at")) collection.at = table.get<double>("at");
    if (table.gives("reference")) collection.reference = table.get<double>("reference");
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

void take_settings(const CheckedTable& checked, Plan& plan) {
    plan.combination = value_of(combination_choices, checked.get<std::string>("combine"));
    if (plan.combination == Combination::latin_hypercube) {
        plan.count = checked.get<long>("count");
        plan.seed = static_cast<std::uint64_t>(checked.get<long>("seed"));
    }
    if (checked.gives("time_limit")) plan.time_limit = checked.get<double>("time_limit");
    if (checked.gives("memory_limit"))
        plan.memory_limit = checked.get<double>("memory_limit") * bytes_in_gigabyte;
    if (!checked.tables("keep").empty()) {
        plan.keeping = value_of(keeping_choices, checked.tables("keep").front().get<std::string>("results"));
    }
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

Plan read_plan_text(std::string text, const std::filesystem::path& file) {
    Plan plan;
    plan.file = file.string();
    plan.text = std::move(text);
    plan.tree = read_toml(plan.text, plan.file);
    FaultList faults(plan.file, {});
    const CheckedTable checked = check_text(plan.tree, plan_schema(), faults);
    faults.throw_if_any();
    take_settings(checked, plan);
    const std::filesystem::path folder = file.parent_path();
    plan.decks = {folder / checked.get<std::string>("deck")};
    check_file(plan.decks[0], "deck", checked, faults);
    if (const DeckEntry* vary = plan.tree.find("vary"))
        plan.variations = read_variations(vary->node, plan.combination, faults);
    if (plan.combination == Combination::table) {
        plan.table = folder / checked.get<std::string>("table");
        if (check_file(plan.table, "table", checked, faults))
            read_table_columns(plan.table, checked.place_of("table"), plan.variations, faults);
    } else if (plan.variations.empty()) {
        faults.add(
            checked.place_of("vary"), "vary", "missing or empty; expected what differs from case to case");
    }
    if (plan.combination == Combination::zip) check_zip(plan, faults);
    check_count(plan, faults);
    check_conflicts(plan.variations, faults);
    for (const CheckedTable& table : checked.tables("collect")) {
        plan.collections.push_back(read_collection(table, faults));
        check_column_name(plan.collections.back(), plan.variations, faults);
    }
    faults.throw_if_any();
    return plan;
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
