#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace gxrod {

// CRC-32 (that of gzip) of bytes that follow others with the checksum `before`.
std::uint32_t checksum(std::span<const std::byte> bytes, std::uint32_t before = 0);

// The same of numbers, as they lie in memory.
template <class Number>
std::uint32_t checksum(std::span<const Number> numbers, std::uint32_t before = 0) {
    return checksum(std::as_bytes(numbers), before);
}

}  // namespace gxrod
