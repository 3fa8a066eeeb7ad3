#include "check/summaries/item_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

namespace gxrod {
namespace {

bool is_of_word(char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
           std::string_view("._@-+[]").find(letter) != std::string_view::npos;
}

// The sentence with # for each word that has a digit or a dot inside, as names of points and numbers do.
std::string make_pattern(const std::string& sentence) {
    std::string pattern;
    for (std::size_t i = 0; i < sentence.size();) {
        std::size_t end = i;
        while (end < sentence.size() && is_of_word(sentence[end])) ++end;
        const std::string_view word(sentence.data() + i, end - i);
        const bool has_digit =
            std::any_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
        const bool has_dot =
            word.size() > 1 && word.substr(0, word.size() - 1).find('.') != std::string_view::npos;
        if (has_digit || has_dot) {
            pattern += '#';
        } else {
            pattern += word;
        }
        if (end < sentence.size()) pattern += sentence[end];
        i = end + 1;
    }
    return pattern;
}

}  // namespace

std::string describe(const ItemList& list, Detail detail) {
    // One or two more need no more room than what would be said of them.
    constexpr std::size_t longest = 4;
    constexpr std::size_t shown = 2;
    const std::size_t count = list.items.size();
    const bool is_shortened = detail == Detail::shortened && count > longest;
    std::string text;
    for (std::size_t i = 0; i < (is_shortened ? shown : count); ++i) text += list.items[i];
    if (!is_shortened) return text;
    text += fmt::format("and {} more {}", count - shown, list.kind);
    if (!list.sum.empty()) text += fmt::format("; all {}: {}", count, list.sum);
    return text + "\n";
}

std::vector<std::string> sum_up_repeats(const std::vector<std::string>& sentences) {
    struct Kind {
        std::string pattern;
        std::string first;
        long others = 0;
    };
    std::vector<Kind> kinds;
    for (const std::string& sentence : sentences) {
        const std::string pattern = make_pattern(sentence);
        const auto known = std::find_if(
            kinds.begin(), kinds.end(), [&](const Kind& kind) { return kind.pattern == pattern; });
        if (known == kinds.end()) {
            kinds.push_back({pattern, sentence});
        } else {
            ++known->others;
        }
    }
    std::vector<std::string> summed;
    for (const Kind& kind : kinds) {
        summed.push_back(kind.others == 0
                             ? kind.first
                             : fmt::format("{} (and {} more like this)", kind.first, kind.others));
    }
    return summed;
}

long count_lines(std::string_view text) { return std::count(text.begin(), text.end(), '\n'); }

}  // namespace gxrod
