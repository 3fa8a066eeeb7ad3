#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace gxrod {

// Returns the CRC-32 (as gzip computes it) of all bytes so far: `before` is the checksum of the earlier ones.
std::uint32_t checksum(std::span<const std::byte> bytes, std::uint32_t before = 0);

// Returns the checksum of numbers, as they lie in memory.
template <class Number>
std::uint32_t checksum(std::span<const Number> numbers, std::uint32_t before = 0) {
    return checksum(std::as_bytes(numbers), before);
}

}  // namespace gxrod
