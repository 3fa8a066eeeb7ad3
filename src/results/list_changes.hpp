#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gxrod {

// What in a results file is not as a run wrote it, as where the disk changed a bit, or may be otherwise
// untold: a sentence for each kind. Files of more than 2 GB are not looked at, as that takes seconds, nor are
// those that are being written. Throws FileError like read_results.
std::vector<std::string> list_changes(const std::filesystem::path& path);

}  // namespace gxrod
