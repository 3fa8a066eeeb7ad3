#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "deck/schema/schema.hpp"

// The words that users of other programs type, and their names here.
namespace gxrod {

// Words of a choice.
struct WordSynonyms {
    const char* choice;
    const char* words;
};

std::span<const WordSynonyms> word_synonyms();

// "a b c" as a, b, c.
std::vector<std::string> split_words(std::string_view words);

// The entry for a key that the table does not have, upper and lower case being the same; nullopt if there is
// none.
std::optional<OtherNames> find_synonym(const TableSpec& table, std::string_view key);

// '; did you mean "at"?', or what replaces the key, as the end of a message; "" if nothing does.
std::string explain_synonym(const TableSpec& table, std::string_view key);

// The one of `choices` that the word means; "" if none.
std::string find_choice(std::string_view word, const std::vector<std::string>& choices);

}  // namespace gxrod
