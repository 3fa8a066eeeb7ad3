#include "deck/reading/word_reading.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/schema/suggestion.hpp"
#include "deck/schema/synonyms.hpp"

namespace gxrod {
namespace {

void expect(const DeckNode& node,
            const std::string& path,
            const KeySpec& key,
            const ReadingContext& context) {
    context.faults.add(
        node.place, path, fmt::format("expected {}, found {}", describe_expected(key), describe_found(node)));
}

std::string explain_word(const std::string& word, const std::vector<std::string>& words) {
    const std::string meant = find_choice(word, words);
    return meant.empty() ? did_you_mean(word, words) : fmt::format("; did you mean \"{}\"?", meant);
}

}  // namespace

std::optional<std::string> read_text(const DeckNode& node,
                                     const std::string& path,
                                     const KeySpec& key,
                                     const ReadingContext& context) {
    if (node.text() != nullptr) return *node.text();
    expect(node, path, key, context);
    return std::nullopt;
}

std::optional<std::string> read_word(const DeckNode& node,
                                     const std::string& path,
                                     const KeySpec& key,
                                     const ReadingContext& context) {
    const std::string* text = node.text();
    const std::vector<std::string>& words = key.choices;
    if (text != nullptr && std::find(words.begin(), words.end(), *text) != words.end()) return *text;
    const std::vector<std::string>& expected = context.likely_words.empty() ? words : context.likely_words;
    const std::string hint = text == nullptr ? "" : explain_word(*text, expected);
    const std::string remark = key.remark.empty() ? "" : (hint.empty() ? "; " : " ") + key.remark;
    context.faults.add(node.place,
                       path,
                       fmt::format("expected {}{}, found {}{}{}",
                                   expected.size() > 1 ? "one of " : "",
                                   quoted_list(expected),
                                   describe_found(node),
                                   hint,
                                   remark));
    return std::nullopt;
}

namespace {

// One word, or a list of them that is not empty, each read by `read_one`.
template <class ReadOne>
std::optional<std::vector<CheckedWord>> read_list(const DeckNode& node,
                                                  const std::string& path,
                                                  const KeySpec& key,
                                                  const ReadingContext& context,
                                                  const ReadOne& read_one) {
    std::vector<CheckedWord> words;
    bool complete = true;
    const auto read = [&](const DeckNode& element, const std::string& element_path) {
        const std::optional<std::string> word = read_one(element, element_path, key, context);
        complete = complete && word;
        if (word) words.push_back({*word, element.place, element_path});
    };
    if (node.text() != nullptr) {
        read(node, path);
    } else if (node.array() != nullptr && !node.array()->empty()) {
        for (std::size_t i = 0; i < node.array()->size(); ++i) {
            read((*node.array())[i], fmt::format("{}[{}]", path, i));
        }
    } else {
        expect(node, path, key, context);
        complete = false;
    }
    return complete ? std::optional(std::move(words)) : std::nullopt;
}

}  // namespace

std::optional<std::vector<CheckedWord>> read_words(const DeckNode& node,
                                                   const std::string& path,
                                                   const KeySpec& key,
                                                   const ReadingContext& context) {
    return read_list(node, path, key, context, read_word);
}

std::optional<std::vector<CheckedWord>> read_names(const DeckNode& node,
                                                   const std::string& path,
                                                   const KeySpec& key,
                                                   const ReadingContext& context) {
    return read_list(node, path, key, context, read_text);
}

std::optional<std::vector<CheckedWord>> read_points(const DeckNode& node,
                                                    const std::string& path,
                                                    const KeySpec& key,
                                                    const ReadingContext& context,
                                                    const std::string& one,
                                                    std::size_t most) {
    const std::size_t count = node.array() == nullptr ? 0 : node.array()->size();
    if (count < 2 || count > most) {
        expect(node, path, key, context);
        return std::nullopt;
    }
    std::vector<CheckedWord> points;
    for (std::size_t i = 0; i < count; ++i) {
        const DeckNode& element = (*node.array())[i];
        const std::string element_path = fmt::format("{}[{}]", path, i);
        if (element.text() != nullptr) {
            points.push_back({*element.text(), element.place, element_path});
        } else {
            context.faults.add(element.place,
                               element_path,
                               fmt::format("expected a {}, found {}", one, describe_found(element)));
        }
    }
    return points.size() == count ? std::optional(std::move(points)) : std::nullopt;
}

}  // namespace gxrod
