#include "results/text_check.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "deck/reading/text_file.hpp"
#include "results/hdf5_objects.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

using Reference = std::array<std::byte, text_reference_bytes>;

// Texts in a file, and what stands there in place of each.
struct Texts {
    sample::ScratchFolder folder;
    std::string path = folder / "a";
    std::vector<std::string> written = {"", "a", std::string(300, 'b'), std::string(9000, 'c')};
    std::vector<Reference> references;

    Texts() {
        silence_hdf5();
        const Hdf5Handle file(
            H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose, "creating the file");
        for (std::size_t i = 0; i < written.size(); ++i) write_attribute(file.id(), name(i), written[i]);
        check_hdf5(H5Fflush(file.id(), H5F_SCOPE_LOCAL), "flushing");
        const TextCheck check(path);
        for (std::size_t i = 0; i < written.size(); ++i) {
            const Hdf5Handle attribute(
                H5Aopen(file.id(), name(i).c_str(), H5P_DEFAULT), H5Aclose, "opening an attribute");
            check_hdf5(H5Aread(attribute.id(), check.reference_type(), references.emplace_back().data()),
                       "reading a reference");
        }
    }
    static std::string name(std::size_t i) { return "text" + std::to_string(i); }
    bool is_sound(const Reference& reference) const { return TextCheck(path).are_sound(reference); }
};

void write_bytes(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

Reference change(Reference reference, std::size_t byte, int by) {
    reference[byte] = static_cast<std::byte>(std::to_integer<int>(reference[byte]) + by);
    return reference;
}

}  // namespace

TEST_CASE("References of texts tell where HDF5 has put them", "[results]") {
    const Texts texts;
    const std::string bytes = read_text_file(texts.path);
    for (std::size_t i = 0; i < texts.written.size(); ++i) {
        const TextReference reference = read_text_reference(texts.references[i]);
        INFO(texts.written[i].size() << " characters");
        CHECK(reference.length == texts.written[i].size());
        CHECK(bytes.substr(reference.heap, 4) == "GCOL");
        CHECK(reference.number > 0);
        CHECK(texts.is_sound(texts.references[i]));
    }
}

TEST_CASE("Several references are looked at, each of them", "[results]") {
    const Texts texts;
    std::vector<std::byte> all;
    for (const Reference& one : texts.references) all.insert(all.end(), one.begin(), one.end());
    TextCheck check(texts.path);
    CHECK(check.are_sound(all));
    const std::size_t last = all.size() - text_reference_bytes;
    all[last] ^= std::byte{1};
    CHECK_FALSE(check.are_sound(all));
}

TEST_CASE("A reference of another length, place or number is not sound", "[results]") {
    const Texts texts;
    for (const Reference& reference : texts.references) {
        for (const std::size_t length_byte : {0U, 3U})
            CHECK_FALSE(texts.is_sound(change(reference, length_byte, 1)));
        for (const std::size_t place_byte : {4U, 5U, 11U})
            CHECK_FALSE(texts.is_sound(change(reference, place_byte, 1)));
        for (const std::size_t number_byte : {13U, 15U})
            CHECK_FALSE(texts.is_sound(change(reference, number_byte, 1)));
    }
}

TEST_CASE("A text that was never written is sound", "[results]") {
    const Texts texts;
    CHECK(texts.is_sound({}));
}

TEST_CASE("A text whose heap is damaged or cut off is not sound", "[results]") {
    const Texts texts;
    const std::string bytes = read_text_file(texts.path);
    const TextReference reference = read_text_reference(texts.references.back());
    for (const std::size_t at : {0U, 8U, 15U, 24U}) {  // its signature, its size, the size of its first text
        std::string damaged = bytes;
        damaged[reference.heap + at] = '\x7f';
        const sample::ScratchFolder folder;
        write_bytes(folder / "b", damaged);
        CHECK_FALSE(TextCheck(folder / "b").are_sound(texts.references.back()));
    }
    const sample::ScratchFolder folder;
    write_bytes(folder / "b", bytes.substr(0, reference.heap + 5000));
    CHECK_FALSE(TextCheck(folder / "b").are_sound(texts.references.back()));
}

TEST_CASE("What is no reference is not read as one", "[results]") {
    // Numbers of another size have no conversion to it.
    const Texts texts;
    const Hdf5Handle file(H5Fopen(texts.path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose, "opening");
    const std::array<std::int64_t, 2> numbers{1, 2};
    write_attribute(file.id(), "numbers", numbers);
    const Hdf5Handle attribute(H5Aopen(file.id(), "numbers", H5P_DEFAULT), H5Aclose, "opening");
    std::array<std::byte, 2 * text_reference_bytes> read{};
    CHECK(H5Aread(attribute.id(), TextCheck(texts.path).reference_type(), read.data()) < 0);
}
