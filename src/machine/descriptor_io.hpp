#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

// Reading and writing anywhere in an open file, however often the system interrupts it. All throw
// std::system_error.
namespace gxrod {

void write_at(int descriptor, std::uint64_t offset, std::span<const std::byte> bytes);
// How many bytes were read; fewer than requested at the end of the file.
std::size_t read_at(int descriptor, std::uint64_t offset, std::span<std::byte> bytes);

}  // namespace gxrod
