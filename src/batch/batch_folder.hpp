#pragma once

#include <filesystem>
#include <string>

// The folder of a batch and the files in it that belong to the batch.
namespace gxrod {

// Checks the folder: throws FileError unless it does not exist, is empty, or holds a batch or the rest of one
// that was killed as it began.
void check_batch_folder(const std::filesystem::path& folder);

// Makes the folder. Throws FileError.
void make_folder(const std::filesystem::path& folder);

// Removes the files of a batch from its folder, except its record, and no others. If it is killed, it can be
// called again.
void clear_batch_folder(const std::filesystem::path& folder);

// Removes files that were being written when a process was killed. The table must be locked.
void remove_leftovers(const std::filesystem::path& folder);

// Writes a temporary file and moves it to `path`, so that the file is whole at every moment. Throws
// FileError.
void replace_file(const std::filesystem::path& path, const std::string& bytes);

}  // namespace gxrod
