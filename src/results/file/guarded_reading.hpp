#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "results/file/file_seal.hpp"

namespace gxrod {

// HDF5 crashes or hangs on some damaged files. So a results file that is not known to be what gxrod wrote is
// read in a process of its own.
class GuardedReading {
  public:
    // Looks at the seal. Throws FileError if there is no such file, or it cannot be read.
    explicit GuardedReading(const std::filesystem::path& path);

    // A clause on why the file is not trusted; "" if it is, or while it is being written.
    const std::string& doubt() const { return doubt_; }
    // Calls `work`, which reads the file and can write others, and returns its result. Throws what `work`
    // throws; from a process of its own, FileError for that and for whatever else ends it.
    std::string read(const std::function<std::string()>& work) const;

  private:
    std::filesystem::path path_;
    std::string doubt_;
    bool is_trusted_ = false;
};

// For a file with this seal that no process is writing; "" if the seal is kept.
std::string describe_doubt(SealState seal);

// How GuardedReading reads a file that is not trusted.
std::string read_in_child(const std::filesystem::path& path, const std::function<std::string()>& work);

}  // namespace gxrod
