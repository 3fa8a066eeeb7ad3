#pragma once

#include <filesystem>
#include <stdexcept>

#include "model/file_error.hpp"
#include "results/hdf5_reader.hpp"

namespace gxrod {

// Opens a results file of gxrod. Throws FileError if there is none, or Hdf5Error if it is no HDF5 file.
Hdf5Reader open_results(const std::filesystem::path& path);

// Returns what `read` makes of an open results file. A job that writes the file meanwhile moves what the
// library remembers of it; then the file is opened anew, and `read` begins again. Throws FileError.
template <class Read>
auto read_results(const std::filesystem::path& path, Read&& read) {
    constexpr int most_attempts = 20;
    for (int attempt = 1;; ++attempt) {
        try {
            const Hdf5Reader file = open_results(path);
            return read(file);
        } catch (const FileError&) {
            throw;
        } catch (const std::runtime_error& fault) {
            if (attempt < most_attempts) continue;
            throw FileError(path, "cannot be read as results of gxrod", fault.what());
        }
    }
}

}  // namespace gxrod
