#include "deck/text/syntax_fault.hpp"

#include <fmt/format.h>

#include <cctype>
#include <optional>

namespace gxrod {
namespace {

bool is_digit(char letter) { return std::isdigit(static_cast<unsigned char>(letter)) != 0; }

bool is_word_letter(char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 || std::string_view("_.+-").find(letter) < 4;
}

std::string_view line_of(std::string_view text, int number) {
    for (; number > 1; --number) {
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos) return {};
        text.remove_prefix(end + 1);
    }
    return text.substr(0, text.find_first_of("\r\n"));
}

// Bytes before the character in the given column (from 1) of a UTF-8 line.
std::size_t byte_offset(std::string_view line, int column) {
    std::size_t byte = 0;
    for (int passed = 0; byte < line.size(); ++byte) {
        const bool starts_character = (static_cast<unsigned char>(line[byte]) & 0xC0u) != 0x80u;
        if (starts_character && ++passed == column) break;
    }
    return byte;
}

struct Word {
    std::size_t begin;
    std::string_view text;
};

// The word without blanks at a byte of a line, or the one that ends there.
Word word_at(std::string_view line, std::size_t byte) {
    std::size_t begin = std::min(byte, line.size());
    while (begin > 0 && is_word_letter(line[begin - 1])) --begin;
    std::size_t end = begin;
    while (end < line.size() && is_word_letter(line[end])) ++end;
    return {begin, line.substr(begin, end - begin)};
}

// The number with the digits that TOML wants next to its point ("1." → "1.0"), if it is one that lacks them.
std::optional<std::string> complete_number(std::string_view word) {
    std::string result;
    bool lacked = false;
    for (std::size_t i = 0; i < word.size(); ++i) {
        if (word[i] != '.') {
            if (!is_digit(word[i]) && std::string_view("eE+-_").find(word[i]) == std::string_view::npos)
                return {};
            result += word[i];
            continue;
        }
        const bool digit_before = i > 0 && is_digit(word[i - 1]);
        const bool digit_after = i + 1 < word.size() && is_digit(word[i + 1]);
        if (!digit_before && !digit_after) return {};
        result += digit_before ? "." : "0.";
        if (!digit_after) result += '0';
        lacked = lacked || !digit_before || !digit_after;
    }
    return lacked ? std::optional(result) : std::nullopt;
}

int column_of(std::string_view line, std::size_t byte) {
    int column = 1;
    for (std::size_t i = 0; i < byte; ++i) {
        if ((static_cast<unsigned char>(line[i]) & 0xC0u) != 0x80u) ++column;
    }
    return column;
}

// What a user wrote without quotes, up to the end of the value.
std::string_view bare_value(std::string_view line, std::size_t byte) {
    std::string_view value = line.substr(byte);
    value = value.substr(0, value.find_first_of(",]}#"));
    const std::size_t last = value.find_last_not_of(" \t");
    return value.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

// "Error while parsing array: expected …" without its beginning.
std::string_view reason_of(std::string_view description) {
    constexpr std::string_view beginning = "Error while parsing ";
    if (description.substr(0, beginning.size()) != beginning) return description;
    const std::size_t colon = description.find(": ");
    return colon == std::string_view::npos ? description : description.substr(colon + 2);
}

}  // namespace

DeckFault explain_syntax_fault(std::string_view text,
                               const std::string& file,
                               const Place& place,
                               std::string_view description) {
    const std::string_view line = line_of(text, place.line);
    const std::size_t byte = byte_offset(line, place.column);
    const Word word = word_at(line, byte);
    if (const auto number = complete_number(word.text)) {
        const std::string message = fmt::format(
            "TOML does not read {}, a number with no digit next to its point: write {}", word.text, *number);
        return {file, place.line, column_of(line, word.begin), "", message};
    }
    if (description.find("could not determine value type") != std::string_view::npos) {
        const std::string message = fmt::format(
            "{0} is no TOML value: text and expressions stand in quotes, \"{0}\"", bare_value(line, byte));
        return {file, place.line, place.column, "", message};
    }
    if (byte >= line.size() && description.find("control characters") != std::string_view::npos) {
        return {file, place.line, place.column, "", "text without its closing quote"};
    }
    if (description.find("could not be interpreted as a value") != std::string_view::npos) {
        return {file,
                place.line,
                column_of(line, word.begin),
                "",
                fmt::format("{} is out of the range of numbers", word.text)};
    }
    return {file, place.line, place.column, "", fmt::format("not TOML: {}", reason_of(description))};
}

}  // namespace gxrod
