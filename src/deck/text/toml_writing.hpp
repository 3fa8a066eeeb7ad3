#pragma once

#include <string>

#include "deck/text/deck_tree.hpp"

namespace gxrod {

// A TOML text that read_toml turns into the same tree, every number to the last bit. Comments are not kept.
std::string write_toml(const DeckNode& deck);
// A key as it is written before its value: in quotes unless it is plain.
std::string write_toml_key(const std::string& key);
// A value as it is written after a key, on one line.
std::string write_toml_value(const DeckNode& node);

}  // namespace gxrod
