#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace gxrod {

// A file could not be read or written. what() is one line: the path, what failed, and a hint if there is one.
class FileError : public std::runtime_error {
  public:
    // The line that another FileError reported.
    struct Line {
        std::string text;
    };
    FileError(std::filesystem::path path, const Line& line)
        : std::runtime_error(line.text), path_(std::move(path)) {}
    FileError(std::filesystem::path path, const std::string& failure, const std::string& hint = "")
        : std::runtime_error(path.string() + ": " + failure + (hint.empty() ? "" : " (" + hint + ")")),
          path_(std::move(path)) {}

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

// Results could not be written; some may already have been.
class WriteError : public FileError {
  public:
    using FileError::FileError;
};

}  // namespace gxrod
