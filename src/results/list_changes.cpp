#include "results/list_changes.hpp"

#include <system_error>

#include "results/find_changes.hpp"
#include "results/results_access.hpp"

namespace gxrod {

std::vector<std::string> list_changes(const std::filesystem::path& path) {
    constexpr std::uintmax_t most_bytes = 2'000'000'000;
    std::error_code error;
    const std::uintmax_t bytes = std::filesystem::file_size(path, error);
    if (error || bytes > most_bytes || is_being_written(path).value_or(true)) return {};
    std::vector<std::string> changes;
    read_results(path, [&](const Hdf5Reader& file) { changes = find_changes(file); });
    // A run may go on with it since.
    return is_being_written(path).value_or(true) ? std::vector<std::string>{} : changes;
}

}  // namespace gxrod
