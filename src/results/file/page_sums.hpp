#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace gxrod {

// The checksum of a file's bytes after its seal, computed from those of its pages, so that only changed pages
// are read again: CRC-32 of the CRC-32s, as they lie in memory, of 4096 bytes each.
class PageSums {
  public:
    // Bytes that have changed, or perhaps have.
    void mark_changed(std::uint64_t offset, std::size_t count);
    // Of a file of `size` bytes. Throws std::system_error if they cannot be read.
    std::uint32_t compute(int descriptor, std::uint64_t size);

  private:
    void read_pages(int descriptor, std::uint64_t first, std::uint64_t last);

    std::uint64_t size_ = 0;
    std::vector<std::uint32_t> sums_;                               // by page
    std::vector<std::pair<std::uint64_t, std::uint64_t>> changed_;  // pages, from one to before another
};

}  // namespace gxrod
