#pragma once

#include "model/deck_record.hpp"
#include "results/file/hdf5_objects.hpp"

// The origin of a results file: version, deck, meshes, status. Throws Hdf5Error.
namespace gxrod {

// Writes the origin for a run that begins.
void write_provenance(const Hdf5Handle& root, const DeckRecord& deck);
// Writes the origin for a run that resumes: adds its deck to the earlier ones if it differs.
void write_resumption(const Hdf5Handle& root, const DeckRecord& before, const DeckRecord& deck);

}  // namespace gxrod
