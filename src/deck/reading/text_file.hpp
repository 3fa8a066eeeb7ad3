#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>

namespace gxrod {

// Of a deck or plan; and of what is no regular file, such as a pipe or a device, in any case.
constexpr std::size_t most_deck_bytes = 100'000'000;

// The bytes of a file. Throws FileError, which says that `what` was expected where there is a folder, where
// there are more bytes, and where there is a pipe that nobody writes to. Of a pipe they can be read once.
std::string read_text_file(const std::filesystem::path& file,
                           const std::string& what = "a file",
                           std::size_t most_bytes = std::numeric_limits<std::size_t>::max());

}  // namespace gxrod
