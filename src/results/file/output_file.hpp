#pragma once

#include <filesystem>
#include <optional>

namespace gxrod {

// What to do about a file that exists already.
enum class Existing { refuse, replace };

// Creates an empty file and returns its descriptor, open for reading and writing. Throws FileError, with a
// hint, if there is a directory or another thing that is no file, if the folder is missing or may not be
// written, or if the file exists and is not to be replaced.
int create_output_file(const std::filesystem::path& path, Existing existing);

// Takes away a file that was created so, when nothing could be written to it; of a link, what it points to.
void remove_output_file(const std::filesystem::path& path);

// Opens a results file to go on with it. Throws FileError if there is none, it may not be written, or another
// process is writing it: both functions lock the file for their process, which keeps nobody from reading.
int open_output_file(const std::filesystem::path& path);

// Throws FileError unless there is a regular file: a device may have no end, a pipe nobody who writes to it.
void check_results_path(const std::filesystem::path& path);

// Of a page, table or frame that is to be written whole: throws FileError if there is what is no file, or one
// that is not to be replaced.
void check_export_file(const std::filesystem::path& path, Existing existing);

// Whether another process has it open by one of these; nullopt where the file system knows no locks.
std::optional<bool> is_being_written(const std::filesystem::path& path);

}  // namespace gxrod
