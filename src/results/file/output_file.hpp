#pragma once

#include <filesystem>
#include <optional>

namespace gxrod {

// What to do about a file that exists already.
enum class Existing { refuse, replace };

// Creates an empty file and returns its descriptor, open for reading and writing. Throws FileError, with a
// hint, if the path is a directory or anything else but a regular file, if the folder is missing or not
// writable, or if the file exists and is not to be replaced.
int create_output_file(const std::filesystem::path& path, Existing existing);

// Removes a file that was created so, when nothing could be written to it; of a link, what it points to.
void remove_output_file(const std::filesystem::path& path);

// Opens a results file to resume it. Throws FileError if there is no such file, it is not writable, or
// another process is writing it: both functions lock the file for their process, which does not prevent
// reading.
int open_output_file(const std::filesystem::path& path);

// Throws FileError unless it is a regular file: a device can have no end, a pipe no writer.
void check_results_path(const std::filesystem::path& path);

// For a page, table or frame that is to be written whole: throws FileError if the path is not that of a
// regular file, or of one that is not to be replaced.
void check_export_file(const std::filesystem::path& path, Existing existing);

// Whether another process has opened it with one of these; nullopt if the file system has no locks.
std::optional<bool> is_being_written(const std::filesystem::path& path);

}  // namespace gxrod
