#pragma once

#include "deck/reading/checked_deck.hpp"
#include "deck/schema/schema.hpp"
#include "deck/text/deck_tree.hpp"

namespace gxrod {

// Checks a deck against the schema: keys, types, ranges, expressions, what is missing. Every fault is added
// to the list; the result is complete only if none was.
CheckedTable check_deck(const DeckNode& deck, FaultList& faults);

// The same for another text, whose top level is `root`; its expressions have no names.
CheckedTable check_text(const DeckNode& text, const TableSpec& root, FaultList& faults);

// Checks one table of a text that is declared on its own; `node` must be a table.
CheckedTable check_table(const DeckNode& node,
                         const std::string& path,
                         const TableSpec& table,
                         FaultList& faults);

}  // namespace gxrod
