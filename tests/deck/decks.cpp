#include "deck/decks.hpp"

#include <stdlib.h>

#include <fstream>

#include "deck/text/fault.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {

std::string replaced(std::string deck, const std::string& old_text, const std::string& new_text) {
    const std::size_t at = deck.find(old_text);
    REQUIRE(at != std::string::npos);
    return deck.replace(at, old_text.size(), new_text);
}

ScratchFile::ScratchFile(const std::string& name, const std::string& text) {
    std::string folder = (std::filesystem::temp_directory_path() / "gxrod_deck_XXXXXX").string();
    REQUIRE(::mkdtemp(folder.data()) != nullptr);
    path_ = std::filesystem::path(folder) / name;
    std::ofstream(path_) << text;
}

ScratchFile::~ScratchFile() {
    std::error_code ignored;
    std::filesystem::remove_all(path_.parent_path(), ignored);
}

Problem read(const std::string& deck, const std::vector<std::string>& overrides) {
    return read_problem_text(deck, "x.toml", overrides);
}

std::string faults_of(const std::string& deck, const std::vector<std::string>& overrides) {
    try {
        read(deck, overrides);
    } catch (const DeckError& error) {
        return error.what();
    }
    return "";
}

}  // namespace gxrod::test
