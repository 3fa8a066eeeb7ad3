#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "batch/plan/plan_words.hpp"
#include "deck/text/deck_tree.hpp"
#include "model/settings/settings.hpp"
#include "numerics/sn_curve.hpp"
#include "results/tables/step_columns.hpp"

// The plan of a batch. docs/plan.md is the reference of its text.
namespace gxrod {

// A distribution of values.
struct Spread {
    enum class Kind { uniform, normal, lognormal };

    Kind kind = Kind::uniform;
    double from = -std::numeric_limits<double>::infinity();
    double to = std::numeric_limits<double>::infinity();
    double mean = 0.0;  // mean and deviation of the values, for normal and lognormal
    double deviation = 1.0;
};

// The place of the values in a table.
struct Column {
    std::string name;
    int header_line = 1;
    std::vector<int> lines;  // lines of the rows
};

// A key of the deck that differs from case to case.
struct Variation {
    std::string key;
    Place place;  // in the plan
    // In the form of --set; for a table in the order of its rows. Empty if they are drawn from `spread`.
    std::vector<std::string> values;
    std::optional<Spread> spread;
    std::optional<Column> column;  // column of the table, with Combination::table
    bool is_faulty = false;        // a fault was reported
};

// Describes what is counted of a value's cycles: its damage, by a curve, or its equivalent range.
struct FatigueCount {
    std::optional<SNCurve> curve = std::nullopt;
    std::optional<double> category = std::nullopt;  // of the curve, if it is one of EN 1993-1-9
    double ultimate = 0.0;                          // 0: means do not count
    double slope = 0.0;                             // of an equivalent range, with its number of cycles
    double cycles = 0.0;
    double from = 0.0;  // the time at which counting starts
};

// A number that is collected from each case.
struct Collection {
    std::string name;
    Place place;  // in the plan
    // Either a quantity of a history, a column of the ledger, or a result of a stage: the item with this
    // number, from 1.
    std::string stage = {};
    std::string found = {};
    long number = 1;
    std::string history;
    std::string quantity;
    const LedgerColumn* ledger = nullptr;
    std::optional<Component> component;
    Take take = Take::last;
    std::optional<double> at;             // a time, in place of `take`
    std::optional<FatigueCount> fatigue;  // in place of `take`
    std::optional<double> reference;

    std::string path() const { return "collect." + name; }
};

struct Plan {
    std::string file;  // as the user named it; "" for a list of decks
    std::string text;
    DeckNode tree;
    std::vector<std::filesystem::path> decks;  // one, except for Combination::decks
    std::filesystem::path table;               // with Combination::table
    Combination combination = Combination::grid;
    long count = 0;  // samples of a Latin hypercube
    std::uint64_t seed = 0;
    double time_limit = std::numeric_limits<double>::infinity();  // s
    std::optional<double> memory_limit;                           // bytes
    std::vector<Variation> variations;
    std::vector<Collection> collections;
    Keeping keeping = Keeping::all;
};

// Reads a plan and the table that it names. Throws DeckError if it is wrong and FileError if a file cannot be
// read.
Plan read_plan(const std::filesystem::path& file);

// Reads a plan from the text of a file.
Plan read_plan_text(std::string text, const std::filesystem::path& file);

// Makes the plan that runs each [combination.NAME] of a deck; nullopt if the deck, of this text, has none.
std::optional<Plan> plan_of_combinations(const std::string& text, const std::filesystem::path& deck);

// Makes a plan with a case for each deck.
Plan plan_of_decks(std::vector<std::filesystem::path> decks);

// Returns whether a TOML file is a plan rather than a deck. Throws DeckError if it is not TOML or neither of
// both, FileError if it cannot be read.
bool is_plan(const std::filesystem::path& file);
bool is_plan_text(const std::string& text, const std::filesystem::path& file);

// Reads the text of a plan or deck. Throws FileError if it cannot be read.
std::string read_plan_file(const std::filesystem::path& file);

}  // namespace gxrod
