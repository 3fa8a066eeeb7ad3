#include "results/file/page_sums.hpp"

#include <algorithm>
#include <cerrno>
#include <span>
#include <system_error>

#include "machine/checksum.hpp"
#include "machine/descriptor_io.hpp"
#include "results/file/file_seal.hpp"

namespace gxrod {
namespace {

constexpr std::uint64_t page_bytes = 4096;
constexpr std::uint64_t pages_at_once = 64;

// The page of an offset in the file; for offsets in the seal, the first.
std::uint64_t page_of(std::uint64_t place) {
    return (std::max<std::uint64_t>(place, seal_block_bytes) - seal_block_bytes) / page_bytes;
}

std::uint64_t count_pages(std::uint64_t size) { return page_of(size + page_bytes - 1); }

}  // namespace

void PageSums::mark_changed(std::uint64_t offset, std::size_t count) {
    changed_.emplace_back(page_of(offset), count_pages(offset + count));
}

std::uint32_t PageSums::compute(int descriptor, std::uint64_t size) {
    const std::uint64_t pages = count_pages(size);
    if (size != size_) {
        changed_.emplace_back(page_of(std::min(size, size_)), pages);
        size_ = size;
    }
    sums_.resize(pages);
    std::sort(changed_.begin(), changed_.end());
    std::uint64_t next = 0;
    for (const auto& [first, last] : changed_) {
        for (next = std::max(next, first); next < std::min(last, pages);) {
            const std::uint64_t end = std::min({last, pages, next + pages_at_once});
            read_pages(descriptor, next, end);
            next = end;
        }
    }
    changed_.clear();
    return checksum(std::span<const std::uint32_t>(sums_));
}

void PageSums::read_pages(int descriptor, std::uint64_t first, std::uint64_t last) {
    const std::uint64_t begin = seal_block_bytes + first * page_bytes;
    std::vector<std::byte> bytes(std::min(seal_block_bytes + last * page_bytes, size_) - begin);
    if (read_at(descriptor, begin, bytes) < bytes.size())
        throw std::system_error(EIO, std::generic_category());
    for (std::uint64_t page = first; page < last; ++page) {
        const std::uint64_t at = (page - first) * page_bytes;
        const std::span<const std::byte> rest = std::span(bytes).subspan(at);
        sums_[page] = checksum(rest.first(std::min<std::size_t>(page_bytes, rest.size())));
    }
}

}  // namespace gxrod
