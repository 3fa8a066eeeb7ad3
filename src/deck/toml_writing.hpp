#pragma once

#include <string>

#include "deck/deck_tree.hpp"

namespace gxrod {

// A TOML text that read_toml turns into the same tree, every number to the last bit. Comments are not kept.
std::string write_toml(const DeckNode& deck);

}  // namespace gxrod
