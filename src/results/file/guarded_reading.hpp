#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "results/file/file_seal.hpp"

namespace gxrod {

// How a results file is read: HDF5's library breaks down over some damaged files, or does not come back. So
// whatever reads one that is not known to be what gxrod wrote does so in a process of its own.
class GuardedReading {
  public:
    // Looks at the seal. Throws FileError if there is no such file, or it cannot be read.
    explicit GuardedReading(const std::filesystem::path& path);

    // What speaks against trusting the file, a clause; "" if nothing does, and of one that is being written.
    const std::string& doubt() const { return doubt_; }
    // Does `work`, which reads the file and may write others, and returns what it returns. Throws what it
    // throws; in a process of its own that, and what else ends it, is FileError.
    std::string read(const std::function<std::string()>& work) const;

  private:
    std::filesystem::path path_;
    std::string doubt_;
    bool is_trusted_ = false;
};

// Of a file with this seal that nobody writes; "" if it is kept.
std::string describe_doubt(SealState seal);

// What GuardedReading does with a file that is not trusted.
std::string read_in_child(const std::filesystem::path& path, const std::function<std::string()>& work);

}  // namespace gxrod
