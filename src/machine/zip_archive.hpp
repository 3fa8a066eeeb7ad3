#pragma once

#include <map>
#include <string>

namespace gxrod {

// Returns a ZIP archive of these files, {path, bytes}, which are not compressed; all have the date of 1
// January 1980, so that equal files make equal archives. Throws std::length_error beyond 4 GB.
std::string make_zip(const std::map<std::string, std::string>& files);

}  // namespace gxrod
