#pragma once

#include <hdf5.h>

#include <filesystem>
#include <fstream>
#include <span>
#include <unordered_map>

#include "results/text_heap.hpp"

namespace gxrod {

// Looks whether texts of a results file are where its references say, and of that length. HDF5 does not: it
// takes memory of the length of the reference, and copies the text of the heap into it, however long that is.
class TextCheck {
  public:
    // Throws Hdf5Error and std::filesystem::filesystem_error.
    explicit TextCheck(const std::filesystem::path& path);

    // The type in which to ask HDF5 for a text's reference instead of the text.
    hid_t reference_type() const { return reference_type_; }

    // `references`: of so many texts, one after the other.
    bool are_sound(std::span<const std::byte> references);

  private:
    bool is_sound(const TextReference& text);
    std::optional<TextSizes> read_heap(std::uint64_t place);

    hid_t reference_type_;
    std::ifstream in_;
    std::uint64_t file_bytes_;
    std::unordered_map<std::uint64_t, std::optional<TextSizes>> heaps_;
};

}  // namespace gxrod
