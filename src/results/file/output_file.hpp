#pragma once

#include <filesystem>
#include <optional>

namespace gxrod {

// Treatment of a file that exists already.
enum class Existing { refuse, replace };

// Creates an empty file and returns its descriptor, open for reading and writing. Throws FileError, with a
// hint, if the path is not a regular file, if the folder is missing or not writable, or if the file exists
// and must not be replaced.
int create_output_file(const std::filesystem::path& path, Existing existing);

// Removes a file that was created so, when nothing could be written to it; if it is a link, the file it
// points to.
void remove_output_file(const std::filesystem::path& path);

// Opens a results file to resume it. Throws FileError if there is no such file, it is not writable, or
// another process is writing it: both functions lock the file for their process, which does not prevent
// reading.
int open_output_file(const std::filesystem::path& path);

// Throws FileError unless the path is a regular file: a device may have no end, a pipe no writer.
void check_results_path(const std::filesystem::path& path);

// Checks a path to which a page, table or frame will be written whole: throws FileError if it is not a
// regular file, or if the file must not be replaced.
void check_export_file(const std::filesystem::path& path, Existing existing);

// Returns whether another process has opened the file with one of these functions; nullopt if the file system
// has no locks.
std::optional<bool> is_being_written(const std::filesystem::path& path);

}  // namespace gxrod
