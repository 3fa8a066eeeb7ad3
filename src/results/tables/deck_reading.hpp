#pragma once

#include <string>

#include "model/deck_record.hpp"
#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// Returns the name of the deck's text in /deck: "text", and after resumptions that changed it "text_2", …
std::string deck_text_name(std::size_t count);

// Reads the deck of the last run and the meshes from a results file. Throws Hdf5Error.
DeckRecord read_deck_record(const Hdf5Reader& file);

}  // namespace gxrod
