#include <array>
#include <fstream>

#include "deck/reading/text_file.hpp"
#include "machine/file_error.hpp"
#include "results/hdf5_reader.hpp"
#include "results/written_file.hpp"
#include "tools/catch.hpp"
#include "tools/let_hdf5_leak.hpp"

// Of changed bits in what HDF5 keeps of its own.

using namespace gxrod;

namespace {

// HDF5's file format, IV.A.2.d: a float of 8 bytes, the lowest first.
const std::string float_type("\x11\x20\x3f\0\x08\0\0\0\0\0\x40\0\x34\x0b\0\x34\xff\x03\0\0", 20);

haddr_t address_in(const std::filesystem::path& path, const char* object) {
    const Hdf5Reader file(path);
    return address_of(Hdf5Handle(H5Oopen(file.id(), object, H5P_DEFAULT), H5Oclose, "opening").id());
}

}  // namespace

// The same bytes are other numbers if their type is another.
TEST_CASE("A changed bit of the type of numbers is told", "[results]") {
    const test::LetHdf5Leak leaks;
    const sample::WrittenFile written;
    const std::string sound = read_text_file(written.path);
    const char* const name = "/ledger/energy_error";
    const std::size_t place = sound.find(float_type, address_in(written.path, name));
    REQUIRE(place != std::string::npos);
    const auto is_same_type = [&] {
        const Hdf5Reader file(written.path);
        const Hdf5Handle dataset(H5Dopen2(file.id(), name, H5P_DEFAULT), H5Dclose, "opening");
        return H5Tequal(Hdf5Handle(H5Dget_type(dataset.id()), H5Tclose, "type").id(), H5T_IEEE_F64LE) > 0;
    };
    int told = 0;
    for (std::size_t bit = 0; bit < 8 * float_type.size(); ++bit) {
        INFO("byte " << bit / 8 << ", bit " << bit % 8);
        std::string changed = sound;
        changed[place + bit / 8] = static_cast<char>(changed[place + bit / 8] ^ (1 << (bit % 8)));
        std::ofstream(written.path, std::ios::binary) << changed;
        try {
            if (list_changes(written.path).empty())
                CHECK(is_same_type());  // a bit that means nothing
            else
                ++told;
        } catch (const FileError&) {
            ++told;
        }
    }
    CHECK(told > 100);
}

// All texts: those of states, and those that change while a run goes on, too, of which there is no checksum
// before it ends.
TEST_CASE("A text that is said to be of other characters, or padded in another way, is told", "[results]") {
    const sample::WrittenFile written;
    written.change([](hid_t file) { sample::rewrite_checksum(file, "end", -1); });
    REQUIRE(written.changes().empty());
    const std::string sound = read_text_file(written.path);
    // HDF5's file format, IV.A.2.d: a list of any length, that is a text, ends with a zero, and is UTF-8.
    const std::string type("\x19\x01\x01\0\x10\0\0\0", 8);
    constexpr std::array<std::pair<std::size_t, int>, 5> bits = {{{1, 4}, {1, 5}, {2, 0}, {2, 1}, {2, 2}}};
    std::size_t texts = 0;
    for (std::size_t place = sound.find(type); place != std::string::npos;
         place = sound.find(type, place + 1)) {
        const auto [byte, bit] = bits[texts++ % bits.size()];
        const std::size_t at = place + byte;
        INFO("byte " << at << ", bit " << bit);
        std::string changed = sound;
        changed[at] = static_cast<char>(changed[at] ^ (1 << bit));
        std::ofstream(written.path, std::ios::binary) << changed;
        const std::vector<std::string> changes = written.changes();
        REQUIRE(changes.size() == 1);
        CHECK_THAT(changes[0], Catch::EndsWith("is of no type that gxrod writes"));
    }
    CHECK(texts > 100);
}

// Of the index of rows HDF5 itself goes from parents to children; other programs, and what splits a leaf, go
// from leaf to leaf as well.
TEST_CASE("A leaf of an index that does not lead to the next is told", "[results]") {
    const sample::WrittenFile written;
    const std::string sound = read_text_file(written.path);
    constexpr std::size_t next_leaf = 16;  // HDF5's file format, III.A.1
    int leaves = 0;
    for (std::size_t at = sound.find("TREE"); at != std::string::npos; at = sound.find("TREE", at + 1)) {
        const bool is_of_rows = sound[at + 4] == 1;
        if (!is_of_rows) continue;
        std::string changed = sound;
        changed[at + next_leaf + 2] = static_cast<char>(changed[at + next_leaf + 2] ^ 0x20);
        std::ofstream(written.path, std::ios::binary) << changed;
        INFO("byte " << at);
        leaves += written.changes().empty() ? 0 : 1;
    }
    CHECK(leaves > 10);
}

// Of the one of two that the run did not last write, too, for it writes it next.
TEST_CASE("A changed type of a state's numbers is told", "[results]") {
    const sample::WrittenFile written;
    const std::string sound = read_text_file(written.path);
    for (const char* const name : {"/restart/a/sections", "/restart/b/sections", "/restart/b/numbers"}) {
        INFO(name);
        const std::size_t type = sound.find(float_type, address_in(written.path, name));
        REQUIRE(type != std::string::npos);
        std::string changed = sound;
        changed[type] = '\x10';  // whole numbers
        std::ofstream(written.path, std::ios::binary) << changed;
        CHECK(written.changes() == std::vector{sample::structure_changed});
        std::ofstream(written.path, std::ios::binary) << sound;
    }
}

TEST_CASE("A changed type of a state's attributes is told", "[results]") {
    const sample::WrittenFile written;
    const std::string sound = read_text_file(written.path);
    const std::string type("\x10\x08\0\0\x08\0\0\0\0\0\x40\0", 12);  // whole numbers with a sign
    for (const std::string name : {"slot", "structure", "end", "version"}) {
        INFO(name);
        const std::string head = name + std::string(8 - name.size() % 8, '\0') + type;
        const std::size_t place = sound.find(head);
        REQUIRE(place != std::string::npos);
        CHECK(sound.find(head, place + 1) == std::string::npos);
        std::string changed = sound;
        changed[place + head.size() - type.size() + 1] = '\0';  // without a sign
        std::ofstream(written.path, std::ios::binary) << changed;
        CHECK(written.changes() == std::vector{sample::structure_changed});
    }
}

// HDF5 looks for the sum behind the form of it, in as many bytes as that is said to have.
TEST_CASE("A checksum that is not where it was is told", "[results]") {
    const sample::WrittenFile written;
    std::string bytes = read_text_file(written.path);
    const std::string head("\x0a\0\x0c\0\x08\0structure", 15);  // bytes of the name, the type, the form
    const std::size_t place = bytes.find(head);
    REQUIRE(place != std::string::npos);
    bytes[place + 4] = 9;
    std::ofstream(written.path, std::ios::binary) << bytes;
    try {
        const std::vector<std::string> changes = written.changes();
        CHECK(changes == std::vector<std::string>{"/restart@structure is damaged"});
    } catch (const FileError& error) {  // where a sanitizer looks, HDF5 breaks down before that
        CHECK_THAT(error.what(), Catch::Contains("is damaged: where HDF5's library reads it"));
    }
}

// HDF5 takes what lies behind the second part of a header for more of it, and writes that back later.
TEST_CASE("A header that is said to be longer is told", "[results]") {
    const sample::WrittenFile written;
    const std::string sound = read_text_file(written.path);
    const std::string next_part("\x10\0\x10\0\0\0\0\0", 8);  // HDF5's file format, IV.A.2.q
    for (const char* const name : {"/restart", "/restart/a/numbers", "/restart/b/forces", "/ledger/time"}) {
        INFO(name);
        const haddr_t header = address_in(written.path, name);
        const std::size_t place = sound.find(next_part, header);
        REQUIRE(place < header + 300);
        std::string changed = sound;
        changed[place + 16] = static_cast<char>(changed[place + 16] + 8);  // the length of the part
        std::ofstream(written.path, std::ios::binary) << changed;
        try {
            const std::vector<std::string> changes = written.changes();
            CHECK(!changes.empty());
        } catch (const FileError& error) {
            CHECK_THAT(error.what(), Catch::Contains("is damaged: where HDF5's library reads it"));
        }
    }
}

// A program that removes one of its names would remove the rows.
TEST_CASE("A changed number of the names of rows is told", "[results]") {
    const sample::WrittenFile written;
    const haddr_t address = address_in(written.path, "/histories/time");
    std::string bytes = read_text_file(written.path);
    constexpr std::size_t names = 4;  // HDF5's file format, IV.A.1.a
    REQUIRE(bytes[address + names] > 1);
    bytes[address + names] = 1;
    std::ofstream(written.path, std::ios::binary) << bytes;
    CHECK(written.changes() == std::vector{sample::structure_changed});
}
