#pragma once

#include <filesystem>
#include <string>

namespace gxrod {

// Creates a folder for temporary files; `purpose` is part of its name. Throws FileError.
std::filesystem::path make_temporary_folder(const std::string& purpose);

// A temporary folder, which the destructor removes with all that it holds.
class TemporaryFolder {
  public:
    explicit TemporaryFolder(const std::string& purpose) : path_(make_temporary_folder(purpose)) {}
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace gxrod
