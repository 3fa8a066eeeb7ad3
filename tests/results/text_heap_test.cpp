#include "results/text_heap.hpp"

#include <hdf5.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "deck/reading/text_file.hpp"
#include "results/hdf5_objects.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

// The heaps of a file that HDF5's own driver wrote, some of them full, with free room, and with texts
// removed.
std::vector<std::string> make_heaps() {
    silence_hdf5();
    const sample::ScratchFolder folder;
    const std::string path = folder / "a";
    {
        const Hdf5Handle file(
            H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose, "creating the file");
        for (std::size_t i = 0; i < 90; ++i)
            write_attribute(file.id(), "text" + std::to_string(i), std::string(37 * i % 500, 'a'));
        for (std::size_t i = 0; i < 90; i += 7)
            rewrite_attribute(file.id(), "text" + std::to_string(i), std::string(i, 'b'));
        write_attribute(file.id(), "long", std::string(10000, 'c'));
    }
    const std::string bytes = read_text_file(path);
    std::vector<std::string> heaps;
    for (std::size_t at = bytes.find("GCOL"); at != std::string::npos; at = bytes.find("GCOL", at + 1)) {
        std::uint64_t size = 0;  // HDF5's file format, III.E
        std::memcpy(&size, bytes.data() + at + 8, sizeof size);
        heaps.push_back(bytes.substr(at, size));
    }
    return heaps;
}

std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span(text)); }

bool is_sound(const std::string& heap) { return read_text_heap(bytes_of(heap)).has_value(); }

// Where its objects begin, and the first byte behind the last of them.
std::vector<std::size_t> object_places(const std::string& heap) {
    std::vector<std::size_t> places{16};
    for (;;) {
        std::uint16_t number = 0;
        std::uint64_t size = 0;
        if (places.back() + 16 > heap.size()) return places;
        std::memcpy(&number, heap.data() + places.back(), sizeof number);
        std::memcpy(&size, heap.data() + places.back() + 8, sizeof size);
        places.push_back(places.back() + (number == 0 ? size : 16 + (size + 7) / 8 * 8));
        if (number == 0) return places;
    }
}

}  // namespace

TEST_CASE("Heaps of texts as HDF5 writes them are sound", "[results]") {
    const std::vector<std::string> heaps = make_heaps();
    REQUIRE(heaps.size() > 3);
    bool has_long = false;
    for (const std::string& heap : heaps) {
        CHECK(read_text_heap_size(bytes_of(heap)) == heap.size());
        CHECK(is_sound(heap));
        has_long = has_long || heap.size() > text_heap_bytes;
    }
    CHECK(has_long);
}

TEST_CASE("Texts of a heap have the sizes that were written", "[results]") {
    std::vector<std::uint64_t> found, written;
    for (const std::string& heap : make_heaps()) {
        const std::optional<TextSizes> sizes = read_text_heap(bytes_of(heap));
        REQUIRE(sizes);
        for (const auto& [number, size] : *sizes) found.push_back(size);
    }
    for (std::size_t i = 0; i < 90; ++i) written.push_back(37 * i % 500);
    for (std::size_t i = 0; i < 90; i += 7) written.push_back(i);  // those before them stay, too
    written.push_back(10000);
    std::sort(found.begin(), found.end());
    std::sort(written.begin(), written.end());
    CHECK(found == written);
}

TEST_CASE("A heap of texts with another size of itself or of an object is not sound", "[results]") {
    for (const std::string& heap : make_heaps()) {
        CHECK_FALSE(is_sound(heap.substr(0, heap.size() - 8)));
        CHECK_FALSE(is_sound(heap + std::string(8, '\0')));
        std::vector<std::size_t> places = object_places(heap);
        places.pop_back();
        for (const std::size_t at : places) {
            INFO("object at " << at << " of " << heap.size());
            std::string changed = heap;
            changed[at + 8 + 7] = '\x7f';  // of a size of 8 bytes, the highest
            CHECK_FALSE(is_sound(changed));
        }
        // Object 0 is the free room; its size ends at the heap's end.
        const std::size_t last = places.back();
        if (heap[last] != 0 || heap[last + 1] != 0) continue;
        for (const int change : {-8, -1, 1, 8}) {
            std::string changed = heap;
            changed[last + 8] = static_cast<char>(changed[last + 8] + change);
            CHECK_FALSE(is_sound(changed));
        }
    }
}

TEST_CASE("A heap of texts with two objects of one number, or none, is not sound", "[results]") {
    const std::string heap = make_heaps().front();
    const std::vector<std::size_t> places = object_places(heap);
    REQUIRE(places.size() > 3);
    std::string twice = heap;
    twice[places[1]] = heap[places[0]];
    CHECK_FALSE(is_sound(twice));
    std::string none = heap;
    none.replace(places[0], 16, 16, '\0');
    CHECK_FALSE(is_sound(none));
}

TEST_CASE("What is no heap of texts has no size of one", "[results]") {
    const std::string heap = make_heaps().front();
    for (const std::size_t changed : {0U, 3U, 4U, 5U, 7U}) {
        std::string other = heap;
        other[changed] = '\x05';
        CHECK_FALSE(read_text_heap_size(bytes_of(other)));
        CHECK_FALSE(is_sound(other));
    }
    CHECK_FALSE(read_text_heap_size(bytes_of(heap).first(15)));
    CHECK_FALSE(is_sound(""));
}
