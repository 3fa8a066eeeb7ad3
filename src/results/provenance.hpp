#pragma once

#include "model/deck_record.hpp"
#include "results/file/hdf5_objects.hpp"

// Where a results file comes from: version, deck, meshes, status. Throws Hdf5Error.
namespace gxrod {

// For a run that begins …
void write_provenance(const Hdf5Handle& root, const DeckRecord& deck);
// … and for one that is resumed: keeps its deck next to the earlier ones, if it differs.
void write_resumption(const Hdf5Handle& root, const DeckRecord& before, const DeckRecord& deck);

}  // namespace gxrod
