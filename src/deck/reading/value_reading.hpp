#pragma once

#include <optional>
#include <string>

#include "deck/reading/checked_deck.hpp"
#include "deck/reading/reading_context.hpp"

// Functions that turn values of a deck into checked values. If a value is wrong, they add a fault and return
// nullopt or monostate; they return these without a fault if an expression uses a parameter or function that
// is itself wrong.
namespace gxrod {

// Reads a number in the key's range, or an expression with such a value.
std::optional<double> read_number(const DeckNode& node,
                                  const std::string& path,
                                  const KeySpec& key,
                                  const ReadingContext& context);

// Reads the value of a key that is not a table.
decltype(CheckedValue::value) read_value(const DeckNode& node,
                                         const std::string& path,
                                         const KeySpec& key,
                                         const ReadingContext& context);

}  // namespace gxrod
