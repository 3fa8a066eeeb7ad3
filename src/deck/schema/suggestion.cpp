#include "deck/schema/suggestion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace gxrod {
namespace {

bool same_letter(char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

}  // namespace

std::size_t edit_distance(std::string_view first, std::string_view second) {
    // Rows of the table for the last two and the present letter of `first`.
    std::vector<std::size_t> before_last(second.size() + 1), last(second.size() + 1), row(second.size() + 1);
    for (std::size_t j = 0; j <= second.size(); ++j) last[j] = j;
    for (std::size_t i = 1; i <= first.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= second.size(); ++j) {
            const bool same = same_letter(first[i - 1], second[j - 1]);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
            if (i > 1 && j > 1 && same_letter(first[i - 1], second[j - 2]) &&
                same_letter(first[i - 2], second[j - 1])) {
                row[j] = std::min(row[j], before_last[j - 2] + 1);
            }
        }
        before_last = last;
        last = row;
    }
    return last[second.size()];
}

std::string nearest_spelling(std::string_view word, const std::vector<std::string>& candidates) {
    std::string nearest;
    std::size_t smallest = 0;
    for (const std::string& candidate : candidates) {
        const std::size_t distance = edit_distance(word, candidate);
        const std::size_t limit = std::max(word.size(), candidate.size()) / 3;
        if (distance > limit || distance >= std::max(word.size(), candidate.size())) continue;
        if (nearest.empty() || distance < smallest) {
            nearest = candidate;
            smallest = distance;
        }
    }
    return nearest;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
    const std::string nearest = nearest_spelling(word, candidates);
    return nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest);
}

std::string quoted_list(const std::vector<std::string>& words) {
    std::vector<std::string> quoted;
    for (const std::string& word : words) quoted.push_back('"' + word + '"');
    return plain_list(quoted);
}

std::string code_list(const std::vector<std::string>& words) {
    std::vector<std::string> quoted;
    for (const std::string& word : words) quoted.push_back('`' + word + '`');
    return plain_list(quoted);
}

std::string plain_list(const std::vector<std::string>& words) {
    return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace gxrod
