#include "machine/checksum.hpp"

#include <libdeflate.h>

namespace gxrod {

std::uint32_t checksum(std::span<const std::byte> bytes, std::uint32_t before) {
    // With a null pointer, the library would return a fresh checksum.
    return bytes.empty() ? before : libdeflate_crc32(before, bytes.data(), bytes.size());
}

}  // namespace gxrod
