#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deck/reading/checked_deck.hpp"
#include "deck/reading/reading_context.hpp"

// Functions that read arrays of numbers, and of arrays of numbers. If a value is wrong, they add a fault and
// return nullopt.
namespace gxrod {

// Reads one number or more.
std::optional<std::vector<double>> read_number_list(const DeckNode& node,
                                                    const std::string& path,
                                                    const KeySpec& key,
                                                    const ReadingContext& context);

// Reads y and z.
std::optional<std::vector<double>> read_section_point(const DeckNode& node,
                                                      const std::string& path,
                                                      const KeySpec& key,
                                                      const ReadingContext& context);

// Reads one number, or six, each within the key's range.
std::optional<std::vector<double>> read_number_or_six(const DeckNode& node,
                                                      const std::string& path,
                                                      const KeySpec& key,
                                                      const ReadingContext& context);

// Reads one number, or a lower and an upper one.
std::optional<std::vector<double>> read_bounds(const DeckNode& node,
                                               const std::string& path,
                                               const KeySpec& key,
                                               const ReadingContext& context);

// Reads two vectors or more.
std::optional<std::vector<CheckedVector>> read_vectors(const DeckNode& node,
                                                       const std::string& path,
                                                       const KeySpec& key,
                                                       const ReadingContext& context);

// Reads six rows of six numbers.
std::optional<Mat6> read_section_matrix(const DeckNode& node,
                                        const std::string& path,
                                        const KeySpec& key,
                                        const ReadingContext& context);

}  // namespace gxrod
