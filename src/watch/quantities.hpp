#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "watch/quantity_tables.hpp"

// Finds the quantities of things.
namespace gxrod {

// Lists all tables, in the order of the words. If several have a word, the first one counts.
const std::vector<const QuantityTable*>& list_quantity_tables();

// Finds the quantity of a word; nullptr if things of this kind do not have it.
const Quantity* find_quantity(const Watched& target, std::string_view word);
// Finds the first quantity of a word, whatever thing it is of; nullptr if there is none.
const Quantity* find_quantity(std::string_view word);
// Returns the quantity of a word. Throws std::invalid_argument if things of this kind do not have it.
const Quantity& quantity_of(const Watched& target, std::string_view word);
// Lists the quantities of a request, in its order.
std::vector<const Quantity*> quantities_of(const HistoryRequest& request);

// Lists the words of all quantities.
std::vector<std::string> list_quantity_words();
// Lists the words of the things that a table of the deck declares, such as "spring"; "contact" stands for
// rods as a whole.
std::vector<std::string> list_quantity_words(std::string_view table);

// Says why the thing does not have the quantity; "" if it has it.
std::string explain_missing(std::string_view word, const Watched& target, const Model& model);
// Returns whether the quantity can be relative to another point.
bool can_be_relative(std::string_view word, const Watched& target);

SnapshotPart part_of(const Quantity& quantity);
const char* dimension_of(const Quantity& quantity, const Watched& target, const Model& model);

}  // namespace gxrod
