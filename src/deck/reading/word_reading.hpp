#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deck/reading/checked_deck.hpp"
#include "deck/reading/reading_context.hpp"

// Text and words of a deck. What is wrong goes to the fault list, and nullopt comes back.
namespace gxrod {

std::optional<std::string> read_text(const DeckNode& node,
                                     const std::string& path,
                                     const KeySpec& key,
                                     const ReadingContext& context);

// One of the key's words.
std::optional<std::string> read_word(const DeckNode& node,
                                     const std::string& path,
                                     const KeySpec& key,
                                     const ReadingContext& context);

// One of the key's words, or a list of them that is not empty.
std::optional<std::vector<CheckedWord>> read_words(const DeckNode& node,
                                                   const std::string& path,
                                                   const KeySpec& key,
                                                   const ReadingContext& context);

// A name, or a list of them that is not empty; whether there are such tables is not checked.
std::optional<std::vector<CheckedWord>> read_names(const DeckNode& node,
                                                   const std::string& path,
                                                   const KeySpec& key,
                                                   const ReadingContext& context);

// A list of points, two at least.
std::optional<std::vector<CheckedWord>> read_points(const DeckNode& node,
                                                    const std::string& path,
                                                    const KeySpec& key,
                                                    const ReadingContext& context);

// The name or the number of a physical group.
decltype(CheckedValue::value) read_mesh_group(const DeckNode& node,
                                              const std::string& path,
                                              const KeySpec& key,
                                              const ReadingContext& context);

}  // namespace gxrod
