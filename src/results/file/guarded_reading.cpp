#include "results/file/guarded_reading.hpp"

#include <system_error>

#include "machine/child_process.hpp"
#include "machine/file_error.hpp"
#include "results/file/output_file.hpp"

namespace gxrod {
namespace {

constexpr ChildLimits limits{.processor_seconds = 20};
constexpr std::uintmax_t most_bytes = 2'000'000'000;  // that are read for the seal alone

// The first byte of what a child returns.
constexpr char is_done = '+';
constexpr char has_failed = '-';

}  // namespace

std::string describe_doubt(SealState seal) {
    switch (seal) {
        case SealState::violated:
            return "not all of its bytes are those that were written";
        case SealState::missing:
            return "it has no seal of gxrod, so that changes to it would not be noticed";
        case SealState::open:
            return "its run was stopped while it wrote, so that changes to it would not be noticed";
        default:
            return "";
    }
}

std::string read_in_child(const std::filesystem::path& path, const std::function<std::string()>& work) {
    std::string result;
    try {
        result = run_in_child(
            [&] {
                try {
                    return is_done + work();
                } catch (const std::bad_alloc&) {
                    throw;
                } catch (const std::exception& error) {
                    return has_failed + std::string(error.what());
                }
            },
            limits);
    } catch (const ChildMemoryError&) {
        throw FileError(path, "cannot be read: there is not enough memory");
    } catch (const ChildError& error) {
        throw FileError(path, std::string("is damaged: where HDF5's library reads it, ") + error.what());
    }
    if (result.starts_with(has_failed)) throw FileError(path, FileError::Line{result.substr(1)});
    return result.substr(1);
}

GuardedReading::GuardedReading(const std::filesystem::path& path) : path_(path) {
    check_results_path(path);
    if (is_being_written(path).value_or(true)) return;
    try {
        if (std::filesystem::file_size(path) > most_bytes) return;
        const SealState seal = look_at_seal(path);
        // A run can have resumed it meanwhile.
        if (is_being_written(path).value_or(true)) return;
        is_trusted_ = seal == SealState::kept;
        doubt_ = describe_doubt(seal);
    } catch (const std::system_error& error) {
        throw FileError(path, "cannot be read", error.code().message());
    }
}

std::string GuardedReading::read(const std::function<std::string()>& work) const {
    return is_trusted_ ? work() : read_in_child(path_, work);
}

}  // namespace gxrod
