#pragma once

#include <string>

namespace gxrod {

// Where a model came from, kept with its results.
struct DeckRecord {
    std::string name;  // file name of the deck
    std::string text;  // the deck as run, after --set; itself a valid deck
    std::string title;
    std::string units;  // a label only
};

}  // namespace gxrod
