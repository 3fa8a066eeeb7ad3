#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "results/file/file_seal.hpp"

namespace gxrod {

// Reads a results file in a separate process if it may differ from what gxrod wrote, as HDF5 crashes or hangs
// on some damaged files.
class GuardedReading {
  public:
    // Checks the seal. Throws FileError if there is no such file or it cannot be read.
    explicit GuardedReading(const std::filesystem::path& path);

    // Returns a clause on why the file is not trusted; "" if it is trusted or is being written.
    const std::string& doubt() const { return doubt_; }
    // Calls `work`, which reads the file and can write others, and returns its result. Throws what `work`
    // throws; from a separate process, FileError for that and for any other end of it.
    std::string read(const std::function<std::string()>& work) const;

  private:
    std::filesystem::path path_;
    std::string doubt_;
    bool is_trusted_ = false;
};

// Returns the doubt about a file with this seal that no process is writing; "" if the seal is kept.
std::string describe_doubt(SealState seal);

// Reads in a child process, as GuardedReading does if the file is not trusted.
std::string read_in_child(const std::filesystem::path& path, const std::function<std::string()>& work);

}  // namespace gxrod
