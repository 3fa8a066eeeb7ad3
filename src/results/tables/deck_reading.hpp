#pragma once

#include <string>

#include "model/deck_record.hpp"
#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// Where in /deck the deck's text is: "text", and of resumptions that changed it "text_2" …
std::string deck_text_name(std::size_t count);

// The deck as run last, and the meshes, that a results file keeps. Throws Hdf5Error.
DeckRecord read_deck_record(const Hdf5Reader& file);

}  // namespace gxrod
