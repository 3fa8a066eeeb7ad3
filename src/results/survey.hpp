#pragma once

#include <filesystem>

namespace gxrod {

// Looks at every object of an HDF5 file in a process of its own, since the library itself breaks down over
// some damaged files, or does not come back. Throws FileError if it does; other faults are for the reader to
// find.
void survey_file(const std::filesystem::path& path);

}  // namespace gxrod
