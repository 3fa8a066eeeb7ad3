#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace gxrod {

// The checksum of a file's bytes after its seal: the CRC-32 of the CRC-32s, as they lie in memory, of its
// pages of 4096 bytes. Only changed pages are read again.
class PageSums {
  public:
    // Marks bytes that have changed, or may have.
    void mark_changed(std::uint64_t offset, std::size_t count);
    // Computes the checksum of a file of `size` bytes. Throws std::system_error if they cannot be read.
    std::uint32_t compute(int descriptor, std::uint64_t size);

  private:
    void read_pages(int descriptor, std::uint64_t first, std::uint64_t last);

    std::uint64_t size_ = 0;
    std::vector<std::uint32_t> sums_;                               // by page
    std::vector<std::pair<std::uint64_t, std::uint64_t>> changed_;  // ranges of pages, the end excluded
};

}  // namespace gxrod
