#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>

namespace gxrod {

// Largest size of a deck or plan, and of anything that is not a regular file, such as a pipe or a device.
constexpr std::size_t most_deck_bytes = 100'000'000;

// Reads the bytes of a file. Throws FileError, which says that `what` was expected, for a folder, for more
// bytes, and for a pipe without a writer. A pipe can be read once.
std::string read_text_file(const std::filesystem::path& file,
                           const std::string& what = "a file",
                           std::size_t most_bytes = std::numeric_limits<std::size_t>::max());

}  // namespace gxrod
