#include "results/read_results.hpp"

#include <system_error>

namespace gxrod {

Hdf5Reader open_results(const std::filesystem::path& path) {
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) throw FileError(path, "there is no such file");
    if (std::filesystem::is_directory(path, ignored))
        throw FileError(path, "is a folder, not a results file");
    Hdf5Reader file(path);
    if (!file.has_attribute("/", "gxrod_version") || !file.has("/histories/time") || !file.has("/ledger")) {
        throw FileError(path, "is not a results file of gxrod");
    }
    return file;
}

}  // namespace gxrod
