#pragma once

#include <string>
#include <vector>

#include "deck/text/deck_tree.hpp"

namespace gxrod {

// Puts the values of `--set KEY=VALUE` into a deck, in their order. KEY is a path such as analysis.beta or
// load[0].force[1]; VALUE is TOML, or text without its quotes. A missing key is added to its table, and so is
// a missing table that a deck has once, such as [output]. A key that excludes others of the deck's text, as
// steps excludes time_step, replaces them. Faults go to the fault list.
void apply_overrides(const std::vector<std::string>& overrides, DeckNode& deck, FaultList& faults);

// Describes a key of [parameters] that the deck does not have, so that its value would be added without any
// use: 'parameter "NAME"' and the names that exist; "" for other keys.
std::string describe_missing_parameter(const std::string& key, const DeckNode& deck);

// Writes the deck as run: its overrides in a comment, then the deck itself.
std::string write_overridden_deck(const std::string& name,
                                  const std::vector<std::string>& overrides,
                                  const DeckNode& deck);

}  // namespace gxrod
