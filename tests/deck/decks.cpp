#include "deck/decks.hpp"

#include "deck/fault.hpp"

namespace gxrod::test {

std::string replaced(std::string deck, const std::string& old_text, const std::string& new_text) {
    const std::size_t at = deck.find(old_text);
    REQUIRE(at != std::string::npos);
    return deck.replace(at, old_text.size(), new_text);
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
