#pragma once

#include <filesystem>

#include "results/file/output_file.hpp"

namespace gxrod {

// Writes what the bodies of a results file look like, at all frames, as bodies.vtkhdf, VTKHDF 2.0: triangles
// and lines, with the number of the body as cell data. Creates the folder if it is missing. If the job is
// still running, writes the frames so far. Returns the file.
//
// Throws FileError if the results cannot be read, have no frame yet or no body, or if the file exists and
// must not be replaced, or cannot be written.
std::filesystem::path export_bodies(const std::filesystem::path& results,
                                    const std::filesystem::path& folder,
                                    Existing existing);

}  // namespace gxrod
