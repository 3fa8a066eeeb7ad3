#include "results/text_check.hpp"

#include <vector>

#include "results/hdf5_handle.hpp"

namespace gxrod {
namespace {

// A conversion of the library's, of references as they are in the file to so many bytes: it leaves them.
template <class... Others>
herr_t keep_reference(hid_t from, hid_t to, H5T_cdata_t* conversion, Others...) {
    if (conversion->command != H5T_CONV_INIT) return 0;
    conversion->need_bkg = H5T_BKG_NO;
    const bool is_known =
        H5Tget_size(from) == text_reference_bytes && H5Tget_size(to) == text_reference_bytes;
    return is_known ? 0 : -1;
}

// For the rest of the process, as the conversion is.
hid_t make_reference_type() {
    const Hdf5Handle text(H5Tcopy(H5T_C_S1), H5Tclose, "string type");
    check_hdf5(H5Tset_size(text.id(), H5T_VARIABLE), "string type");
    const hid_t bytes = H5Tcreate(H5T_OPAQUE, text_reference_bytes);
    check_hdf5(H5Tregister(H5T_PERS_SOFT, "text reference", text.id(), bytes, keep_reference), "string type");
    return bytes;
}

}  // namespace

TextCheck::TextCheck(const std::filesystem::path& path)
    : reference_type_(make_reference_type()),
      in_(path, std::ios::binary),
      file_bytes_(std::filesystem::file_size(path)) {}

bool TextCheck::are_sound(std::span<const std::byte> references) {
    for (; references.size() >= text_reference_bytes; references = references.subspan(text_reference_bytes)) {
        if (!is_sound(read_text_reference(references.first<text_reference_bytes>()))) return false;
    }
    return true;
}

bool TextCheck::is_sound(const TextReference& text) {
    if (text.heap == 0) return true;
    auto heap = heaps_.find(text.heap);
    if (heap == heaps_.end()) heap = heaps_.emplace(text.heap, read_heap(text.heap)).first;
    if (!heap->second) return false;
    const auto size = heap->second->find(text.number);
    return size != heap->second->end() && size->second == text.length;
}

std::optional<TextSizes> TextCheck::read_heap(std::uint64_t place) {
    const auto read = [&](std::uint64_t count) {
        std::vector<std::byte> bytes;
        if (place > file_bytes_ || count > file_bytes_ - place) return bytes;
        bytes.resize(count);
        in_.clear();
        in_.seekg(static_cast<std::streamoff>(place));
        in_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(count));
        if (!in_) bytes.clear();
        return bytes;
    };
    const std::optional<std::uint64_t> size = read_text_heap_size(read(text_heap_bytes));
    return size ? read_text_heap(read(*size)) : std::nullopt;
}

}  // namespace gxrod
