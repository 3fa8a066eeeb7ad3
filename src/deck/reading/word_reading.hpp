#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deck/reading/checked_deck.hpp"
#include "deck/reading/reading_context.hpp"

// Functions that read text and words of a deck. If a value is wrong, they add a fault and return nullopt.
namespace gxrod {

std::optional<std::string> read_text(const DeckNode& node,
                                     const std::string& path,
                                     const KeySpec& key,
                                     const ReadingContext& context);

// Reads one of the key's words.
std::optional<std::string> read_word(const DeckNode& node,
                                     const std::string& path,
                                     const KeySpec& key,
                                     const ReadingContext& context);

// Reads one of the key's words, or a list of them that is not empty.
std::optional<std::vector<CheckedWord>> read_words(const DeckNode& node,
                                                   const std::string& path,
                                                   const KeySpec& key,
                                                   const ReadingContext& context);

// Reads a name, or a list of them that is not empty; does not check that such tables exist.
std::optional<std::vector<CheckedWord>> read_names(const DeckNode& node,
                                                   const std::string& path,
                                                   const KeySpec& key,
                                                   const ReadingContext& context);

// Describes an item of a list of points, in messages.
inline constexpr const char* point_words = "point, such as \"rod.end\"";

// Reads a list of two points, or of so many at most; `one` is such a point, in messages.
std::optional<std::vector<CheckedWord>> read_points(const DeckNode& node,
                                                    const std::string& path,
                                                    const KeySpec& key,
                                                    const ReadingContext& context,
                                                    const std::string& one = point_words,
                                                    std::size_t most = 2);

}  // namespace gxrod
