#pragma once

#include <filesystem>

namespace gxrod {

// What to do about a results file that exists already.
enum class Existing { refuse, replace };

// Creates an empty file and returns its descriptor, open for reading and writing. Throws FileError, with a
// hint, if there is a directory or another thing that is no file, if the folder is missing or may not be
// written, or if the file exists and is not to be replaced.
int create_output_file(const std::filesystem::path& path, Existing existing);

}  // namespace gxrod
