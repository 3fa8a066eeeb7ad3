#pragma once

#include <filesystem>

namespace gxrod {

// Looks at every object of an HDF5 file in a process of its own, since the library itself breaks down over
// some damaged files, or does not come back; also at what it takes for granted: where texts lie and how long
// they are, that the bits of numbers and characters lie within their bytes, that chunks of rows have the
// bytes that they should and belong to one dataset, that names are found where they are listed, that trees
// have the usual size, and that all is in this file. Throws FileError of such faults; others are for the
// reader to find.
void survey_file(const std::filesystem::path& path);

}  // namespace gxrod
