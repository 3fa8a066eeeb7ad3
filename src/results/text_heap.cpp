#include "results/text_heap.hpp"

#include <bit>
#include <cstring>

// The form is that of section III.E, "Global Heap", of HDF5's file format specification: "GCOL", version 1,
// three zeros, size; then objects of a number (2 bytes), count of references (2), 4 unused bytes, size (8),
// and what they hold, up to a multiple of eight bytes. Object 0 is the free room, of which the size counts
// these 16 bytes, too. A reference is a text's length, the place of its heap, and its number there (a "global
// heap ID" with the length before it).
namespace gxrod {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::size_t alignment = 8;
constexpr std::size_t header_bytes = 16;  // of a heap, and of an object in it

template <class Number>
Number read_number(std::span<const std::byte> bytes, std::size_t at) {
    Number number{};
    std::memcpy(&number, bytes.data() + at, sizeof number);
    return number;
}

}  // namespace

std::optional<std::uint64_t> read_text_heap_size(std::span<const std::byte> begin) {
    constexpr char signature[] = "GCOL\1\0\0";  // and the 0 that ends it
    static_assert(sizeof signature == 8);
    if (begin.size() < header_bytes || std::memcmp(begin.data(), signature, sizeof signature) != 0) return {};
    return read_number<std::uint64_t>(begin, sizeof signature);
}

std::optional<TextSizes> read_text_heap(std::span<const std::byte> heap) {
    if (read_text_heap_size(heap) != heap.size() || heap.size() < text_heap_bytes ||
        heap.size() % alignment != 0)
        return {};
    TextSizes sizes;
    for (std::size_t at = header_bytes; heap.size() - at >= header_bytes;) {
        const auto number = read_number<std::uint16_t>(heap, at);
        const auto size = read_number<std::uint64_t>(heap, at + 8);
        const std::size_t room = heap.size() - at;
        if (number == 0) return size == room ? std::optional(sizes) : std::nullopt;
        if (size > room - header_bytes || !sizes.emplace(number, size).second) return {};
        at += header_bytes + (size + alignment - 1) / alignment * alignment;
    }
    return sizes;
}

TextReference read_text_reference(std::span<const std::byte, text_reference_bytes> bytes) {
    return {read_number<std::uint32_t>(bytes, 0),
            read_number<std::uint64_t>(bytes, 4),
            read_number<std::uint32_t>(bytes, 12)};
}

}  // namespace gxrod
