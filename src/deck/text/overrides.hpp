#pragma once

#include <string>
#include <vector>

#include "deck/text/deck_tree.hpp"

namespace gxrod {

// Puts the values of `--set KEY=VALUE` into a deck, in their order. KEY is a path such as analysis.beta or
// load[0].force[1]; VALUE is TOML, or text without its quotes. A key that is missing is added to its table,
// and so is a missing table that a deck has once, such as [output]; a key that excludes others of the deck's
// text, as steps excludes time_step, takes their place. What is wrong goes to the fault list.
void apply_overrides(const std::vector<std::string>& overrides, DeckNode& deck, FaultList& faults);

// If the key is one of [parameters] that the deck does not have, so that a value would be added which nothing
// uses: 'parameter "NAME"' and which there are; "" otherwise.
std::string describe_missing_parameter(const std::string& key, const DeckNode& deck);

// The deck as run: its overrides named in a comment, then the deck itself.
std::string write_overridden_deck(const std::string& name,
                                  const std::vector<std::string>& overrides,
                                  const DeckNode& deck);

}  // namespace gxrod
