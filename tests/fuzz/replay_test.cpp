#include <filesystem>
#include <fstream>
#include <iterator>

#include "fuzz/inputs.hpp"
#include "tools/catch.hpp"

// What libFuzzer found worth keeping, and what once broke a reader, through the same functions. Each input is
// small.

namespace {

std::string read_bytes(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// How many inputs there are for a reader, each of which was tried.
int replay(const std::string& reader, void (*attempt)(std::string_view)) {
    int count = 0;
    for (const std::filesystem::path group : {GXROD_CORPUS, GXROD_SOURCE_DIR "/tests/issues/inputs"}) {
        const std::filesystem::path folder = group / reader;
        if (!std::filesystem::exists(folder)) continue;
        for (const auto& file : std::filesystem::directory_iterator(folder)) {
            INFO(file.path().string());
            CHECK_NOTHROW(attempt(read_bytes(file.path())));
            ++count;
        }
    }
    return count;
}

}  // namespace

TEST_CASE("Decks that were tried are read or refused", "[fuzz]") {
    CHECK(replay("deck", gxrod::fuzz::try_deck) > 100);
}

TEST_CASE("Plans that were tried are read or refused", "[fuzz]") {
    CHECK(replay("plan", gxrod::fuzz::try_plan) > 100);
}

TEST_CASE("Expressions that were tried are read or refused", "[fuzz]") {
    CHECK(replay("expression", gxrod::fuzz::try_expression) > 100);
}

TEST_CASE("Meshes that were tried are read or refused", "[fuzz]") {
    CHECK(replay("mesh", gxrod::fuzz::try_mesh) > 100);
}
