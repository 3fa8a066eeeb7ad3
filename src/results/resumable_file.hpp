#pragma once

#include <filesystem>
#include <utility>

#include "model/deck_record.hpp"
#include "state/records/restart_record.hpp"

namespace gxrod {

// A results file that can be resumed, open for writing and locked against a second writer.
class ResumableFile {
  public:
    // Throws FileError if there is no such file, it cannot be written, another process writes it, or it has
    // no state to resume from.
    explicit ResumableFile(const std::filesystem::path& path);
    ~ResumableFile();
    ResumableFile(ResumableFile&& other) noexcept;
    ResumableFile& operator=(ResumableFile&&) = delete;

    const std::filesystem::path& path() const { return path_; }
    const RestartPlace& place() const { return place_; }
    // Returns whether the run reached its end and closed the file.
    bool is_complete() const { return is_complete_; }
    // Returns the deck and meshes with which the file was written.
    const DeckRecord& deck() const { return deck_; }
    // Returns the descriptor, which the caller must close.
    int release();

  private:
    std::filesystem::path path_;
    int descriptor_;
    RestartPlace place_;
    DeckRecord deck_;
    bool is_complete_ = false;
};

}  // namespace gxrod
