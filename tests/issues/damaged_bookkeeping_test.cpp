#include <hdf5.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "deck/reading/text_file.hpp"
#include "fuzz/results_sample.hpp"
#include "fuzz/scratch_folder.hpp"
#include "machine/file_error.hpp"
#include "results/hdf5_reader.hpp"
#include "results/list_changes.hpp"
#include "results/results_access.hpp"
#include "results/resumable_file.hpp"
#include "tools/catch.hpp"

// What reads results of files in which what HDF5 keeps of its own is damaged.

namespace gxrod::fuzz {
namespace {

const auto not_listed =
    Catch::Contains("is damaged: where HDF5's library reads it, it cannot list all that is there");
const auto beyond_texts =
    Catch::Contains("is damaged: where HDF5's library reads it, it would go beyond the ends of texts");

std::vector<std::size_t> places_of(const std::string& bytes, const std::string& part) {
    std::vector<std::size_t> places;
    for (std::size_t at = bytes.find(part); at != std::string::npos; at = bytes.find(part, at + 1))
        places.push_back(at);
    return places;
}

// Changes a tree of each group, from a place on.
void check_group_trees(const std::function<void(std::string&, std::size_t)>& change) {
    const ScratchFolder folder;
    const std::string& sound = results_sample();
    const std::vector<std::size_t> trees = places_of(sound, std::string("TREE\0", 5));
    CHECK(trees.size() > 5);
    for (const std::size_t tree : trees) {
        std::string bytes = sound;
        change(bytes, tree);
        const std::filesystem::path path = folder.write("damaged.vtkhdf", bytes);
        INFO("byte " << tree);
        CHECK_THROWS_WITH(ResumableFile(path), not_listed);
        CHECK_THROWS_WITH(list_changes(path), not_listed);
    }
}

}  // namespace

// A reader asks by name, and may come to what a survey that lists all does not get to.
TEST_CASE("A file whose objects or attributes cannot be listed is an error", "[issues]") {
    const ScratchFolder folder;
    const std::string& sound = results_sample();
    const auto told = [&](std::size_t place) {
        std::string bytes = sound;
        bytes[place] = 99;
        try {
            read_results(folder.write("damaged.vtkhdf", bytes), [](const Hdf5Reader&) {});
        } catch (const FileError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    int groups = 0;
    for (std::size_t node = sound.find("SNOD"); node != std::string::npos;
         node = sound.find("SNOD", node + 1)) {
        CHECK_THAT(told(node), not_listed);
        ++groups;
    }
    CHECK(groups > 5);
    constexpr std::size_t before_name = 8;
    const std::size_t name = sound.find("gxrod_version");
    REQUIRE(name != std::string::npos);
    CHECK_THAT(told(name - before_name), not_listed);
}

// The tree of a group leads from a name to where it is kept, but its leaves have all names. Where a run that
// goes on put a group that it did not find, HDF5 ended the process.
TEST_CASE("A file whose names are listed, but not found, is an error", "[issues]") {
    constexpr std::size_t second_key = 24 + 16;  // the greatest name of the first leaf
    check_group_trees([](std::string& bytes, std::size_t tree) {
        std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(tree + second_key), 8, '\0');
    });
}

// HDF5 lists names from parents to children; other programs that visit a file go from leaf to leaf.
TEST_CASE("A file in which a leaf of a group's names does not lead to the next is an error", "[issues]") {
    constexpr std::size_t next_leaf = 16;
    check_group_trees([](std::string& bytes, std::size_t tree) { bytes[tree + next_leaf + 2] ^= 0x20; });
}

// A heap of texts says that it is longer than it is: HDF5 takes what lies behind for more of its texts, and a
// text that a resumed run writes there goes over the heap's end in memory.
TEST_CASE("A file whose texts would be written beyond their heap is an error", "[issues]") {
    const ScratchFolder folder;
    const std::string sound = results_sample();
    const std::vector<std::size_t> heaps = places_of(sound, "GCOL");
    CHECK(heaps.size() > 1);
    for (const std::size_t at : heaps) {
        constexpr std::size_t size = 8;  // where the heap has it
        for (const auto& [byte, value] : {std::pair{0, '\x1f'}, {1, '\x20'}, {7, '\x7f'}}) {
            INFO("byte " << at + size + byte);
            std::string longer = sound;
            longer[at + size + byte] = value;
            const std::filesystem::path path = folder.write("damaged.vtkhdf", longer);
            CHECK_THROWS_WITH(ResumableFile(path), beyond_texts);
            CHECK_THROWS_WITH(list_changes(path), beyond_texts);
        }
    }
}

// HDF5 takes memory of a text's length as the reference has it, and copies into it what the heap has.
TEST_CASE("A file whose texts are not of the length that is told is an error", "[issues]") {
    const ScratchFolder folder;
    const std::string sound = results_sample();
    int references = 0;
    for (const std::size_t heap : places_of(sound, "GCOL")) {
        std::string address(8, '\0');
        std::memcpy(address.data(), &heap, sizeof heap);
        for (const std::size_t at : places_of(sound, address)) {
            const bool is_reference = at % 8 == 4;  // with the length before it
            if (!is_reference || ++references % 6 != 0) continue;
            INFO("byte " << at);
            constexpr std::size_t length = 4;  // bytes before the address
            std::string changed = sound;
            changed[at - length] = static_cast<char>(changed[at - length] + 1);
            const std::filesystem::path path = folder.write("damaged.vtkhdf", changed);
            CHECK_THROWS_WITH(list_changes(path), beyond_texts);
            changed = sound;
            changed[at - 1] = '\x7f';
            folder.write("damaged.vtkhdf", changed);
            CHECK_THROWS_WITH(list_changes(path), beyond_texts);
            changed = sound;
            changed[at + 8 + 1] = '\x7f';  // of its number
            folder.write("damaged.vtkhdf", changed);
            CHECK_THROWS_WITH(ResumableFile(path), beyond_texts);
        }
    }
    CHECK(references > 100);
}

// HDF5 keeps as many bytes of a text's reference as its type has, and writes them where there is room for 16.
TEST_CASE("A file whose attributes keep texts in another room is an error", "[issues]") {
    const ScratchFolder folder;
    const std::string& sound = results_sample();
    const std::string type("\x19\x01\x01\0\x10\0\0\0", 8);
    int attributes = 0;
    const std::vector<std::size_t> texts = places_of(sound, type);
    for (const std::size_t at : texts) {
        std::string changed = sound;
        changed[at + 4] = '\x11';
        const std::filesystem::path path = folder.write("damaged.vtkhdf", changed);
        try {
            list_changes(path);
        } catch (const FileError&) {
            // Where a sanitizer looks, HDF5 breaks down before that.
            CHECK_THROWS_WITH(ResumableFile(path),
                              Catch::Contains("is damaged: where HDF5's library reads it"));
            ++attributes;
        }
    }
    CHECK(attributes > 100);
    // Datasets, the deck and what names the rods and their sections: they take 16 bytes whatever their type
    // says.
    CHECK(texts.size() - attributes == 3);
}

// HDF5 converts bits of characters that there are not, when a run that goes on writes another text.
TEST_CASE("A file whose characters have bits beyond their bytes is an error", "[issues]") {
    const ScratchFolder folder;
    const std::string& sound = results_sample();
    const std::string character("\x10\0\0\0\x01\0\0\0\0\0\x08\0", 12);
    int texts = 0;
    for (const std::size_t at : places_of(sound, character)) {
        const bool is_of_text = sound[at - 8] == '\x19';
        if (!is_of_text) continue;
        std::string changed = sound;
        changed[at + 10] = '\x28';
        const std::filesystem::path path = folder.write("damaged.vtkhdf", changed);
        CHECK_THROWS_WITH(list_changes(path), beyond_texts);
        ++texts;
    }
    CHECK(texts > 100);
}

// HDF5 writes nodes of the size that the file's beginning tells, over what lies behind them.
TEST_CASE("A file whose trees have another size is an error", "[issues]") {
    const ScratchFolder folder;
    for (const auto& [place, bit] : {std::pair{16, 1}, {18, 4}}) {
        std::string changed = results_sample();
        changed[place] = static_cast<char>(changed[place] ^ bit);
        const std::filesystem::path path = folder.write("damaged.vtkhdf", changed);
        CHECK_THROWS_WITH(ResumableFile(path), Catch::Contains("its trees are not of the size of gxrod's"));
    }
}

// The first entry of a heap of texts is one without an end and without a length: HDF5 1.10 looks for the next
// for ever.
TEST_CASE("A file over which HDF5 does not come back is an error", "[issues]") {
    const ScratchFolder folder;
    std::string bytes = results_sample();
    const std::size_t heap = bytes.find("GCOL");
    REQUIRE(heap != std::string::npos);
    constexpr std::size_t header = 16;  // of the heap, and of each entry
    bytes.replace(heap + header, header, header, '\0');
    const std::filesystem::path path = folder.write("damaged.vtkhdf", bytes);
    CHECK_THROWS_WITH(read_results(path, [](const Hdf5Reader&) {}), beyond_texts);
    // What looks for changes is the first to read it, for an export.
    CHECK_THROWS_WITH(list_changes(path), beyond_texts);
}

// HDF5 takes memory of a chunk's length as its index has it, or of what comes out of a compressed one, and
// goes through as many rows as a chunk should have.
TEST_CASE("A file whose chunks are not of the length that is told is an error", "[issues]") {
    const ScratchFolder folder;
    const std::string sound = results_sample();
    constexpr std::size_t level = 5, length = 24, skipped_filters = 28;
    const auto beyond_rows = std::string("it would go beyond the ends of rows");
    int leaves = 0;
    for (const std::size_t index : places_of(sound, "TREE\x01")) {
        if (sound[index + level] != 0) continue;
        ++leaves;
        INFO("byte " << index);
        int told = 0;
        for (const std::size_t place : {length, skipped_filters}) {
            std::string changed = sound;
            changed[index + place] = static_cast<char>(changed[index + place] ^ 1);
            try {
                list_changes(folder.write("damaged.vtkhdf", changed));
            } catch (const FileError& error) {
                told += std::string(error.what()).ends_with(beyond_rows) ? 1 : 0;
            }
        }
        CHECK(told == 1);  // without filters there is none to skip; the length of what is compressed may vary
    }
    CHECK(leaves > 20);
}

// A dataset that leads to the rows of another, of equal ones until a run goes on, say.
TEST_CASE("A file in which two datasets have the same rows is an error", "[issues]") {
    const ScratchFolder folder;
    const std::string& sound = results_sample();
    const std::vector<std::size_t> trees = places_of(sound, "TREE\x01");
    const auto bytes_of = [](std::size_t place) {
        std::string bytes(8, '\0');
        std::memcpy(bytes.data(), &place, sizeof place);
        return bytes;
    };
    const auto beyond_rows = std::string("it would go beyond the ends of rows");
    int told = 0;
    for (std::size_t i = 0; i + 1 < trees.size(); ++i) {
        std::string changed = sound;
        for (const std::size_t at : places_of(sound, bytes_of(trees[i + 1])))
            changed.replace(at, 8, bytes_of(trees[i]));
        const std::filesystem::path path = folder.write("damaged.vtkhdf", changed);
        INFO("tree " << i);
        CHECK_THROWS_AS(list_changes(path), FileError);
        try {
            list_changes(path);
        } catch (const FileError& error) {
            told += std::string(error.what()).ends_with(beyond_rows) ? 1 : 0;
        }
    }
    CHECK(told > 25);
}

}  // namespace gxrod::fuzz
