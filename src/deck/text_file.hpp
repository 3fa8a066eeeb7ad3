#pragma once

#include <filesystem>
#include <string>

namespace gxrod {

// The bytes of a file. Throws FileError, which says that `what` was expected where there is a folder.
std::string read_text_file(const std::filesystem::path& file, const std::string& what = "a file");

}  // namespace gxrod
