// Stands before the C library's functions that change files (LD_PRELOAD) and lets one of their calls go
// wrong:
//
//   FAULT      kill     the process is killed before the call
//              torn     some of the pages that the call writes are written, then the process is killed: the
//                       system looks for that signal between pages of memory, not within one; other calls
//                       than writes are not done
//              full     this and every later call that takes room fails: no space left on the device
//              once     this call alone fails so
//              io       this call alone fails: input/output error
//              short    every call writes half, and every third one is interrupted first
//   FAULT_AT   the number of the call, from 1
//   FAULT_LOG  a file for the number of calls, at the process's end
//
// Calls on terminals, pipes and sockets are not counted.
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>

#include "shim_symbols.hpp"

namespace {

using namespace gxrod::faults;

enum class Fault { none, kill, torn, full, once, io, shortened };

Fault read_fault() {
    if (is_chosen("FAULT", "kill")) return Fault::kill;
    if (is_chosen("FAULT", "torn")) return Fault::torn;
    if (is_chosen("FAULT", "full")) return Fault::full;
    if (is_chosen("FAULT", "once")) return Fault::once;
    if (is_chosen("FAULT", "io")) return Fault::io;
    return is_chosen("FAULT", "short") ? Fault::shortened : Fault::none;
}

const Fault fault = read_fault();
const long fault_at = read_number("FAULT_AT", 0);
std::atomic<long> calls{0};

[[gnu::destructor]] void log_calls() {
    const char* path = std::getenv("FAULT_LOG");
    if (!path) return;
    if (std::FILE* log = std::fopen(path, "w")) {
        std::fprintf(log, "%ld\n", calls.load());
        std::fclose(log);
    }
}

[[noreturn]] void die() {
    ::kill(::getpid(), SIGKILL);
    while (true) ::pause();
}

bool is_file(int descriptor) {
    struct stat status {};
    return ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

enum class Call { write, growth, other };

// Counts a call. True if it is to fail, with errno as the device would set it.
bool fails(Call kind) {
    const long call = ++calls;
    const bool takes_room = kind != Call::other;
    if (fault == Fault::full && fault_at > 0 && call >= fault_at && takes_room) {
        errno = ENOSPC;
        return true;
    }
    if (call != fault_at) return false;
    if (fault == Fault::kill) die();
    if (fault == Fault::torn && kind != Call::write) die();
    if (fault != Fault::once && fault != Fault::io) return false;
    errno = fault == Fault::io ? EIO : ENOSPC;
    return true;
}

// Bytes of a write up to the page's end after its middle, or else before it; 0 if it is within a page.
std::size_t cut_at_page(std::size_t size, off64_t offset) {
    constexpr off64_t page = 4096;
    const off64_t end = (offset + static_cast<off64_t>(size + 1) / 2 + page - 1) / page * page;
    const off64_t cut = end - offset < static_cast<off64_t>(size) ? end - offset : end - page - offset;
    return cut > 0 ? static_cast<std::size_t>(cut) : 0;
}

// Writes `size` bytes by `write_part(bytes)`, or what the fault leaves of it.
template <class WritePart>
ssize_t write_faultily(std::size_t size, off64_t offset, WritePart&& write_part) {
    if (fails(Call::write)) return -1;
    if (fault == Fault::torn && calls == fault_at) {
        write_part(cut_at_page(size, offset));
        die();
    }
    if (fault == Fault::shortened) {
        if (calls % 3 == 0) {
            errno = EINTR;
            return -1;
        }
        return write_part(size - size / 2);
    }
    return write_part(size);
}

}  // namespace

extern "C" {

ssize_t pwrite64(int descriptor, const void* bytes, std::size_t size, off64_t offset) {
    static const auto write_real = real(&::pwrite64, "pwrite64");
    if (!is_file(descriptor)) return write_real(descriptor, bytes, size, offset);
    return write_faultily(
        size, offset, [&](std::size_t part) { return write_real(descriptor, bytes, part, offset); });
}

ssize_t pwrite(int descriptor, const void* bytes, std::size_t size, off_t offset) {
    return ::pwrite64(descriptor, bytes, size, offset);
}

ssize_t write(int descriptor, const void* bytes, std::size_t size) {
    static const auto write_real = real(&::write, "write");
    if (!is_file(descriptor)) return write_real(descriptor, bytes, size);
    const off64_t offset = ::lseek64(descriptor, 0, SEEK_CUR);
    return write_faultily(
        size, offset, [&](std::size_t part) { return write_real(descriptor, bytes, part); });
}

ssize_t writev(int descriptor, const iovec* parts, int count) {
    static const auto write_real = real(&::writev, "writev");
    if (is_file(descriptor) && fails(Call::growth)) return -1;
    return write_real(descriptor, parts, count);
}

int ftruncate64(int descriptor, off64_t size) noexcept {
    static const auto truncate_real = real(&::ftruncate64, "ftruncate64");
    struct stat status {};
    const bool grows = ::fstat(descriptor, &status) == 0 && size > status.st_size;
    if (fails(grows ? Call::growth : Call::other)) return -1;
    return truncate_real(descriptor, size);
}

int ftruncate(int descriptor, off_t size) noexcept { return ::ftruncate64(descriptor, size); }

int rename(const char* before, const char* after) noexcept {
    static const auto rename_real = real(&::rename, "rename");
    if (fails(Call::other)) return -1;
    return rename_real(before, after);
}

int unlink(const char* path) noexcept {
    static const auto unlink_real = real(&::unlink, "unlink");
    if (fails(Call::other)) return -1;
    return unlink_real(path);
}

int remove(const char* path) noexcept {
    static const auto remove_real = real(&::remove, "remove");
    if (fails(Call::other)) return -1;
    return remove_real(path);
}

int open64(const char* path, int flags, ...) {
    static const auto open_real = real(&::open64, "open64");
    mode_t mode = 0;
    if ((flags & O_CREAT) != 0) {
        va_list arguments;
        va_start(arguments, flags);
        mode = va_arg(arguments, mode_t);
        va_end(arguments);
        if (fails(Call::growth)) return -1;
    }
    return open_real(path, flags, mode);
}

int open(const char* path, int flags, ...) {
    mode_t mode = 0;
    if ((flags & O_CREAT) != 0) {
        va_list arguments;
        va_start(arguments, flags);
        mode = va_arg(arguments, mode_t);
        va_end(arguments);
    }
    return ::open64(path, flags, mode);
}
}
