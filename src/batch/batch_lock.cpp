#include "batch/batch_lock.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

#include "batch/plan/plan_schema.hpp"
#include "machine/file_error.hpp"

namespace gxrod {
namespace {

// Byte 0 of the file locks the table, byte n case n, the one after all cases their submission.
struct flock describe(off_t first, off_t count) {
    struct flock lock {};
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    lock.l_start = first;
    lock.l_len = count;
    return lock;
}

struct flock describe(const CaseRange& range) { return describe(range.first, range.last - range.first + 1); }

std::filesystem::path lock_path(const std::filesystem::path& folder) { return folder / "lock"; }

int open_lock(const std::filesystem::path& folder) {
    const std::filesystem::path path = lock_path(folder);
    const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor < 0) throw FileError(path, "cannot be written", std::generic_category().message(errno));
    return descriptor;
}

// Adds the locked ones of the cases. The lock that the system names first need not be the first one.
void add_running(int descriptor, const CaseRange& range, std::vector<CaseRange>& running) {
    if (range.last < range.first) return;
    struct flock lock = describe(range);
    if (::fcntl(descriptor, F_OFD_GETLK, &lock) != 0 || lock.l_type == F_UNLCK) return;
    const long last = lock.l_len == 0 ? range.last : lock.l_start + lock.l_len - 1;
    const CaseRange found{std::max(lock.l_start, range.first), std::min(last, range.last)};
    add_running(descriptor, {range.first, found.first - 1}, running);
    running.push_back(found);
    add_running(descriptor, {found.last + 1, range.last}, running);
}

[[noreturn]] void refuse(const std::filesystem::path& folder, int descriptor) {
    const int code = errno;
    ::close(descriptor);
    if (code == EAGAIN || code == EACCES) {
        throw FileError(
            folder, "another gxrod batch is running in it", "-o takes another folder, --only other cases");
    }
    throw FileError(lock_path(folder), "cannot be locked", std::generic_category().message(code));
}

}  // namespace

BatchLock BatchLock::of_cases(const std::filesystem::path& folder, const CaseRange& range) {
    // The workers of a batch that was killed die a little later, and have its lock until then.
    return acquire(folder, describe(range), std::chrono::seconds(2));
}

BatchLock BatchLock::of_table(const std::filesystem::path& folder) {
    return acquire(folder, describe(0, 1), std::chrono::minutes(10));
}

BatchLock BatchLock::acquire(const std::filesystem::path& folder,
                             struct flock lock,
                             std::chrono::seconds patience) {
    constexpr std::chrono::milliseconds pause{50};
    const auto end = std::chrono::steady_clock::now() + patience;
    const int descriptor = open_lock(folder);
    while (::fcntl(descriptor, F_OFD_SETLK, &lock) != 0) {
        const bool is_busy = errno == EAGAIN || errno == EACCES;
        if (!is_busy || std::chrono::steady_clock::now() > end) refuse(folder, descriptor);
        std::this_thread::sleep_for(pause);
    }
    return BatchLock(descriptor);
}

BatchLock BatchLock::of_submission(const std::filesystem::path& folder) {
    const int descriptor = open_lock(folder);
    struct flock lock = describe(largest_case_count + 1, 1);
    if (::fcntl(descriptor, F_OFD_SETLK, &lock) == 0) return BatchLock(descriptor);
    if (errno != EAGAIN && errno != EACCES) refuse(folder, descriptor);
    ::close(descriptor);
    throw FileError(folder, "another gxrod batch is submitting its cases", "wait until it has ended");
}

std::vector<CaseRange> BatchLock::list_running(const std::filesystem::path& folder, const CaseRange& range) {
    return BatchLock(open_lock(folder)).list_running(range);
}

std::vector<CaseRange> BatchLock::list_running(const CaseRange& range) const {
    std::vector<CaseRange> running;
    add_running(descriptor_, range, running);
    return running;
}

BatchLock::~BatchLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

BatchLock::BatchLock(BatchLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

}  // namespace gxrod
