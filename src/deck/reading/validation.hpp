#pragma once

#include "deck/reading/checked_deck.hpp"
#include "deck/schema/schema.hpp"
#include "deck/text/deck_tree.hpp"

namespace gxrod {

// Checks a deck against the schema: keys, types, ranges, expressions, missing keys. Adds every fault to the
// list; the result is complete only if there was none.
CheckedTable check_deck(const DeckNode& deck, FaultList& faults);

// Checks another text, whose top level is `root`, likewise; its expressions have no names.
CheckedTable check_text(const DeckNode& text, const TableSpec& root, FaultList& faults);

// Checks one table of a text that is declared by itself; `node` must be a table.
CheckedTable check_table(const DeckNode& node,
                         const std::string& path,
                         const TableSpec& table,
                         FaultList& faults);

}  // namespace gxrod
