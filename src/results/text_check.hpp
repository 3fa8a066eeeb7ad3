#pragma once

#include <hdf5.h>

#include <filesystem>
#include <fstream>
#include <span>
#include <unordered_map>

#include "results/text_heap.hpp"

namespace gxrod {

// A type of HDF5's to read a text's reference in, instead of the text. Throws Hdf5Error.
hid_t text_reference_type();

// Looks whether texts of a results file are where its references say, and of that length. HDF5 does not: it
// takes memory of the length of the reference, and copies the text of the heap into it, however long that is.
class TextCheck {
  public:
    explicit TextCheck(const std::filesystem::path& path);

    // `references`: of so many texts, one after the other.
    bool are_sound(std::span<const std::byte> references);

  private:
    bool is_sound(const TextReference& text);
    std::optional<TextSizes> read_heap(std::uint64_t place);

    std::ifstream in_;
    std::uint64_t file_bytes_;
    std::unordered_map<std::uint64_t, std::optional<TextSizes>> heaps_;
};

}  // namespace gxrod
