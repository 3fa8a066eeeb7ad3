#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

// Functions that read and write at any place of an open file, and repeat what the system interrupts. All
// throw std::system_error.
namespace gxrod {

void write_at(int descriptor, std::uint64_t offset, std::span<const std::byte> bytes);
// Returns how many bytes were read; fewer than requested at the end of the file.
std::size_t read_at(int descriptor, std::uint64_t offset, std::span<std::byte> bytes);

}  // namespace gxrod
