#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deck/reading/checked_deck.hpp"
#include "deck/reading/reading_context.hpp"

// Arrays of numbers, and of arrays of them. What is wrong goes to the fault list, and nullopt comes back.
namespace gxrod {

// One number or more.
std::optional<std::vector<double>> read_number_list(const DeckNode& node,
                                                    const std::string& path,
                                                    const KeySpec& key,
                                                    const ReadingContext& context);

// y and z.
std::optional<std::vector<double>> read_section_point(const DeckNode& node,
                                                      const std::string& path,
                                                      const KeySpec& key,
                                                      const ReadingContext& context);

// One number, or six, each within the key's range.
std::optional<std::vector<double>> read_number_or_six(const DeckNode& node,
                                                      const std::string& path,
                                                      const KeySpec& key,
                                                      const ReadingContext& context);

// One number, or a lower and an upper one.
std::optional<std::vector<double>> read_bounds(const DeckNode& node,
                                               const std::string& path,
                                               const KeySpec& key,
                                               const ReadingContext& context);

// Two vectors or more.
std::optional<std::vector<CheckedVector>> read_vectors(const DeckNode& node,
                                                       const std::string& path,
                                                       const KeySpec& key,
                                                       const ReadingContext& context);

// Six rows of six numbers.
std::optional<Mat6> read_section_matrix(const DeckNode& node,
                                        const std::string& path,
                                        const KeySpec& key,
                                        const ReadingContext& context);

}  // namespace gxrod
