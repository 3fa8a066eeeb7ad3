#include "results/file/results_access.hpp"

#include <chrono>
#include <system_error>
#include <thread>

#include "machine/file_error.hpp"

namespace gxrod {

namespace {

constexpr int most_attempts = 20;
constexpr std::chrono::milliseconds pause(2);

Hdf5Reader open_results(const std::filesystem::path& path) {
    check_results_path(path);
    Hdf5Reader file(path);
    if (!file.has_attribute("/", "gxrod_version") || !file.has("/histories/time") || !file.has("/ledger")) {
        throw FileError(path, "is not a results file of gxrod");
    }
    return file;
}

}  // namespace

void read_results(const std::filesystem::path& path, const std::function<void(const Hdf5Reader&)>& read) {
    for (int attempt = 1;; ++attempt) {
        const bool is_written = is_being_written(path).value_or(true);
        try {
            read(open_results(path));
            return;
        } catch (const FileError&) {
            throw;
        } catch (const std::exception& fault) {
            if (attempt == most_attempts || !is_written) {
                throw FileError(path, "cannot be read as results of gxrod", fault.what());
            }
        }
        std::this_thread::sleep_for(pause);
    }
}

void prepare_export(const std::filesystem::path& folder,
                    const std::vector<std::filesystem::path>& files,
                    Existing existing) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw FileError(folder, "cannot be created", error.message());
    for (const std::filesystem::path& file : files) check_export_file(file, existing);
}

}  // namespace gxrod
