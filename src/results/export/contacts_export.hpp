#pragma once

#include <filesystem>

#include "results/file/output_file.hpp"

namespace gxrod {

// Writes what touches in each frame of a results file as contacts.vtkhdf, VTKHDF 2.0: points with times,
// whose data are the columns of /contacts. In a folder that is created if it is missing. Of a running job,
// the frames so far. Returns the file.
//
// Throws FileError if the results cannot be read, have no frame yet or no contact, or the file exists and is
// not to be replaced, or cannot be written.
std::filesystem::path export_contacts(const std::filesystem::path& results,
                                      const std::filesystem::path& folder,
                                      Existing existing);

}  // namespace gxrod
