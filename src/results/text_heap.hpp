#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>

namespace gxrod {

// Of HDF5's heap of texts (a "global heap collection"): its least size.
inline constexpr std::size_t text_heap_bytes = 4096;

// Size of the heap whose first bytes these are; nothing if they are not those of a heap.
std::optional<std::uint64_t> read_text_heap_size(std::span<const std::byte> begin);

// Sizes of the texts of a heap by their numbers. Nothing if the texts do not follow each other up to the
// heap's free room, and that to its end, as HDF5 writes them. HDF5 reads such a heap, too, and writes beyond
// its end when it puts another text there.
using TextSizes = std::unordered_map<std::uint32_t, std::uint64_t>;
std::optional<TextSizes> read_text_heap(std::span<const std::byte> heap);

// What stands in a file in place of a text: where it is, and its length.
struct TextReference {
    std::uint32_t length = 0;
    std::uint64_t heap = 0;  // its place in the file; 0: no text was written
    std::uint32_t number = 0;
};
inline constexpr std::size_t text_reference_bytes = 16;
TextReference read_text_reference(std::span<const std::byte, text_reference_bytes> bytes);

}  // namespace gxrod
