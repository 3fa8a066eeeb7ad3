#include "results/file/output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>

#include "machine/file_error.hpp"

namespace gxrod {
namespace {

namespace fs = std::filesystem;

constexpr const char* busy = "another process is writing it";
constexpr const char* failure = "cannot create the results file: ";

// Makes a limit on file sizes an error of writing instead of the end of the program.
void ignore_size_limit_signal() {
    struct sigaction action {};
    if (::sigaction(SIGXFSZ, nullptr, &action) == 0 && action.sa_handler == SIG_DFL) {
        std::signal(SIGXFSZ, SIG_IGN);
    }
}

std::string hint_for(const fs::path& path, int error) {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    std::error_code ignored;
    if (error == ENOENT && !fs::exists(folder, ignored)) {
        return "the folder " + folder.string() + " does not exist";
    }
    if (error == EACCES || error == EROFS) return "the folder " + folder.string() + " is not writable";
    return "";
}

// Locks belong to the open file, not to the process, and do not conflict with those of readers that lock
// whole files.
struct flock whole_file_lock() {
    struct flock whole {};
    whole.l_type = F_WRLCK;
    whole.l_whence = SEEK_SET;
    return whole;
}

// False if another process holds the lock; true also if the file system has no locks.
bool lock(int descriptor) {
    struct flock whole = whole_file_lock();
    if (::fcntl(descriptor, F_OFD_SETLK, &whole) == 0) return true;
    return errno != EAGAIN && errno != EACCES;
}

void make_way(const fs::path& path, Existing existing) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) return;
    if (fs::is_directory(status)) {
        throw FileError(path, std::string(failure) + "it is a directory", "give the name of a file");
    }
    if (!fs::is_regular_file(status)) {
        throw FileError(path, std::string(failure) + "it exists and is not a regular file");
    }
    if (existing == Existing::refuse) {
        throw FileError(path, std::string(failure) + "it exists already", "--force replaces it");
    }
    if (is_being_written(path).value_or(false)) throw FileError(path, busy);
    // Not truncated: programs that have the old file open continue to read it.
    fs::remove(path, error);
    if (error) throw FileError(path, "cannot replace the results file: " + error.message());
}

// A link stays; what it points to is replaced.
fs::path follow_link(const fs::path& path) {
    std::error_code error;
    return fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : path;
}

}  // namespace

void check_results_path(const fs::path& path) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (!fs::exists(status)) throw FileError(path, "there is no such file");
    if (fs::is_directory(status)) throw FileError(path, "is a folder, not a results file");
    if (!fs::is_regular_file(status)) throw FileError(path, "is not a regular file");
}

void check_export_file(const fs::path& path, Existing existing) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (!fs::exists(status)) return;
    if (fs::is_directory(status)) throw FileError(path, "is a folder", "give the name of a file");
    if (!fs::is_regular_file(status)) throw FileError(path, "is not a regular file", "give the name of one");
    if (existing == Existing::refuse) throw FileError(path, "exists already", "--force overwrites it");
}

std::optional<bool> is_being_written(const fs::path& path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return false;
    // Tested, not taken: it must stay free for a writer.
    struct flock whole = whole_file_lock();
    const bool is_told = ::fcntl(descriptor, F_OFD_GETLK, &whole) == 0;
    ::close(descriptor);
    return is_told ? std::optional(whole.l_type != F_UNLCK) : std::nullopt;
}

int create_output_file(const fs::path& path, Existing existing) {
    const fs::path target = follow_link(path);
    make_way(target, existing);
    const int descriptor = ::open(target.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) {
        const int code = errno;
        throw FileError(path, failure + std::generic_category().message(code), hint_for(target, code));
    }
    lock(descriptor);
    ignore_size_limit_signal();
    return descriptor;
}

void remove_output_file(const fs::path& path) {
    std::error_code ignored;
    fs::remove(follow_link(path), ignored);
}

int open_output_file(const fs::path& path) {
    check_results_path(path);
    const int descriptor = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
    if (descriptor < 0) {
        throw FileError(path, "cannot be written: " + std::generic_category().message(errno));
    }
    if (!lock(descriptor)) {
        ::close(descriptor);
        throw FileError(path, busy);
    }
    ignore_size_limit_signal();
    return descriptor;
}

}  // namespace gxrod
