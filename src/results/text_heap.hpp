#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace gxrod {

// Of HDF5's heap of texts (a "global heap collection"): its least size.
inline constexpr std::size_t text_heap_bytes = 4096;

// Size of the heap whose first bytes these are; nothing if they are not those of a heap.
std::optional<std::uint64_t> read_text_heap_size(std::span<const std::byte> begin);

// Whether a heap's texts follow each other up to its free room, and that to the end, as HDF5 writes them.
// HDF5 reads others as well, and writes beyond their end when it puts another text there.
bool is_sound_text_heap(std::span<const std::byte> heap);

}  // namespace gxrod
