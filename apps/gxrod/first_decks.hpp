#pragma once

#include <string_view>
#include <vector>

namespace gxrod {

// A deck to begin with, of a trade; made from the files of apps/gxrod/decks.
struct FirstDeck {
    std::string_view name;
    std::string_view text;
};

const std::vector<FirstDeck>& list_first_decks();

}  // namespace gxrod
