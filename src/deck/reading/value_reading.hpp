#pragma once

#include <optional>
#include <string>

#include "deck/reading/checked_deck.hpp"
#include "deck/reading/reading_context.hpp"

// Values of a deck into checked ones. What is wrong goes to the fault list, and nullopt or monostate comes
// back; so it does, without a fault, for an expression that rests on a parameter or function that is itself
// at fault.
namespace gxrod {

// A number in the key's range, or an expression that has one.
std::optional<double> read_number(const DeckNode& node,
                                  const std::string& path,
                                  const KeySpec& key,
                                  const ReadingContext& context);

// The value of a key that is not a table.
decltype(CheckedValue::value) read_value(const DeckNode& node,
                                         const std::string& path,
                                         const KeySpec& key,
                                         const ReadingContext& context);

}  // namespace gxrod
