#include "machine/descriptor_io.hpp"

#include <sys/types.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace gxrod {
namespace {

// Calls transfer(bytes, offset) until all bytes are done or the end is reached.
template <class Bytes, class Transfer>
std::size_t transfer_all(Bytes bytes, std::uint64_t offset, Transfer transfer) {
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t count = transfer(bytes.subspan(done), static_cast<off_t>(offset + done));
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw std::system_error(errno, std::generic_category());
        if (count == 0) break;
        done += static_cast<std::size_t>(count);
    }
    return done;
}

}  // namespace

void write_at(int descriptor, std::uint64_t offset, std::span<const std::byte> bytes) {
    const std::size_t written =
        transfer_all(bytes, offset, [&](std::span<const std::byte> rest, off_t place) {
            return ::pwrite(descriptor, rest.data(), rest.size(), place);
        });
    if (written < bytes.size()) throw std::system_error(EIO, std::generic_category());
}

std::size_t read_at(int descriptor, std::uint64_t offset, std::span<std::byte> bytes) {
    return transfer_all(bytes, offset, [&](std::span<std::byte> rest, off_t place) {
        return ::pread(descriptor, rest.data(), rest.size(), place);
    });
}

}  // namespace gxrod
