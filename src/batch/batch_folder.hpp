#pragma once

#include <filesystem>
#include <string>

// The folder of a batch, and what of it is the batch's own.
namespace gxrod {

// Throws FileError unless there is no such folder, or it holds nothing, a batch, or what a batch left that
// was killed as it began.
void check_batch_folder(const std::filesystem::path& folder);

// Throws FileError.
void make_folder(const std::filesystem::path& folder);

// Takes away what a batch leaves in its folder but its record, and nothing else. Killed in between, it can be
// called again.
void clear_batch_folder(const std::filesystem::path& folder);

// Takes away what was being written when a process was killed. The table must be locked.
void remove_leftovers(const std::filesystem::path& folder);

// Writes a temporary file and moves it there, so that it is whole at every moment. Throws FileError.
void replace_file(const std::filesystem::path& path, const std::string& bytes);

}  // namespace gxrod
