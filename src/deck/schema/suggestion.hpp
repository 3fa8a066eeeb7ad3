#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

// The nearest valid spelling of a word.
namespace gxrod {

// Insertions, deletions, replacements and swaps of neighbours that turn one word into the other, upper and
// lower case being the same (optimal string alignment).
std::size_t edit_distance(std::string_view first, std::string_view second);

// The candidate nearest to the word; empty if none is near. The first of equally near ones.
std::string nearest_spelling(std::string_view word, const std::vector<std::string>& candidates);

// '; did you mean "section"?' for a message to end with; empty if no candidate is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

// '"a", "b"', '`a`, `b`' and 'a, b'.
std::string quoted_list(const std::vector<std::string>& words);
std::string code_list(const std::vector<std::string>& words);
std::string plain_list(const std::vector<std::string>& words);

}  // namespace gxrod
