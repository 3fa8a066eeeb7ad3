#pragma once

#include "model/deck_record.hpp"
#include "results/hdf5_reader.hpp"

namespace gxrod {

// The deck and the meshes that a results file keeps. Throws Hdf5Error.
DeckRecord read_deck_record(const Hdf5Reader& file);

}  // namespace gxrod
