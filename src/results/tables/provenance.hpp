#pragma once

#include "model/deck_record.hpp"
#include "results/file/hdf5_objects.hpp"

// What a results file says of where it comes from: version, deck, meshes, status. Throws Hdf5Error.
namespace gxrod {

// Of a run that begins …
void write_provenance(const Hdf5Handle& root, const DeckRecord& deck);
// … and of one that goes on: keeps its deck next to those before, if it is another one.
void write_resumption(const Hdf5Handle& root, const DeckRecord& before, const DeckRecord& deck);

}  // namespace gxrod
