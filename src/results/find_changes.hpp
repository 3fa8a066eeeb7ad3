#pragma once

#include <string>
#include <vector>

#include "results/hdf5_reader.hpp"
#include "state/restart_record.hpp"

namespace gxrod {

// What is not as it was written, of all up to the state to go on from: a sentence for each kind; none of a
// file whose run was stopped before it wrote checksums. Throws like Hdf5Reader.
std::vector<std::string> find_changes(const Hdf5Reader& file, const RestartPlace& place);
// The same of the state, too, of what cannot be read, and of what no checksum stands for.
std::vector<std::string> find_changes(const Hdf5Reader& file);

}  // namespace gxrod
