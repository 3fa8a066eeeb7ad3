#pragma once

#include <string>

#include "deck/text/deck_tree.hpp"

namespace gxrod {

// Writes a TOML text that read_toml turns into the same tree, every number to the last bit. Comments are not
// kept.
std::string write_toml(const DeckNode& deck);
// Writes a key as it stands before its value: in quotes unless it is plain.
std::string write_toml_key(const std::string& key);
// Writes a value as it stands after a key, on one line.
std::string write_toml_value(const DeckNode& node);

}  // namespace gxrod
