#pragma once

#include <filesystem>

#include "results/file/output_file.hpp"

namespace gxrod {

// Writes the contacts of each frame of a results file as contacts.vtkhdf, VTKHDF 2.0: points with times,
// whose data are the columns of /contacts. Creates the folder if it is missing. If the job is still running,
// writes the frames so far. Returns the file.
//
// Throws FileError if the results cannot be read, have no frame yet or no contact, or if the file exists and
// must not be replaced, or cannot be written.
std::filesystem::path export_contacts(const std::filesystem::path& results,
                                      const std::filesystem::path& folder,
                                      Existing existing);

}  // namespace gxrod
