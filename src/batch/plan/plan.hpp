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
#include "results/tables/step_columns.hpp"

// What a batch runs. docs/plan.md is the reference of the text.
namespace gxrod {

// A distribution of values.
struct Spread {
    enum class Kind { uniform, normal, lognormal };

    Kind kind = Kind::uniform;
    double from = -std::numeric_limits<double>::infinity();
    double to = std::numeric_limits<double>::infinity();
    double mean = 0.0;  // of the values, as is the deviation; of normal and lognormal
    double deviation = 1.0;
};

// Where the values of a table are.
struct Column {
    std::string name;
    int header_line = 1;
    std::vector<int> lines;  // of the rows
};

// A key of the deck that differs from case to case.
struct Variation {
    std::string key;
    Place place;  // in the plan
    // As --set takes them; for a row of the table in its order. Empty if they are drawn from `spread`.
    std::vector<std::string> values;
    std::optional<Spread> spread;
    std::optional<Column> column;  // of the table, with Combination::table
    bool is_faulty = false;        // reported as such
};

// A number that is collected from each case.
struct Collection {
    std::string name;
    Place place;  // in the plan
    // Either a quantity of a history, or a column of the ledger, or what a stage finds: of its items this
    // one, from 1.
    std::string stage = {};
    std::string found = {};
    long number = 1;
    std::string history;
    Quantity quantity = Quantity::position;
    const LedgerColumn* ledger = nullptr;
    std::optional<Component> component;
    Take take = Take::last;
    std::optional<double> at;  // a time, instead of `take`
    std::optional<double> reference;

    std::string path() const { return "collect." + name; }
};

struct Plan {
    std::string file;  // as the user named it; "" for a list of decks
    std::string text;
    DeckNode tree;
    std::vector<std::filesystem::path> decks;  // one, but for Combination::decks
    std::filesystem::path table;               // with Combination::table
    Combination combination = Combination::grid;
    long count = 0;  // of a Latin hypercube
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

// The same of the text of a file that has been read.
Plan read_plan_text(std::string text, const std::filesystem::path& file);

// A case for each deck.
Plan plan_of_decks(std::vector<std::filesystem::path> decks);

// Whether a file of TOML is a plan rather than a deck. Throws DeckError if it is not TOML, or neither of
// them, FileError if it cannot be read.
bool is_plan(const std::filesystem::path& file);
bool is_plan_text(const std::string& text, const std::filesystem::path& file);

// The text of a plan or deck. Throws FileError if it cannot be read.
std::string read_plan_file(const std::filesystem::path& file);

}  // namespace gxrod
