#include "machine/checksum.hpp"

#include <libdeflate.h>

namespace gxrod {

std::uint32_t checksum(std::span<const std::byte> bytes, std::uint32_t before) {
    // Asked for the checksum of nothing at no place, the library starts again.
    return bytes.empty() ? before : libdeflate_crc32(before, bytes.data(), bytes.size());
}

}  // namespace gxrod
