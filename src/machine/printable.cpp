#include "machine/printable.hpp"

#include <algorithm>
#include <array>

namespace gxrod {
namespace {

constexpr unsigned char first_of_second_controls = 0xC2;  // of U+0080 to U+009F in UTF-8

// How many bytes of the text at `at` are a control character; 0 if there is none.
std::size_t control_length(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0xFFu;
    };
    if (byte(at) < 0x20 || byte(at) == 0x7F) return 1;
    return byte(at) == first_of_second_controls && byte(at + 1) >= 0x80 && byte(at + 1) < 0xA0 ? 2 : 0;
}

// How many bytes of the text at `at` are one character of UTF-8 (RFC 3629); 0 if they are not one.
std::size_t character_length(std::string_view text, std::size_t at) {
    struct Form {
        unsigned first, last;             // of the first byte
        unsigned second_from, second_to;  // else a character could be written in two ways, or is not one
        std::size_t length;
    };
    constexpr std::array forms = {Form{0x00, 0x7F, 0, 0, 1},
                                  Form{0xC2, 0xDF, 0x80, 0xBF, 2},
                                  Form{0xE0, 0xE0, 0xA0, 0xBF, 3},
                                  Form{0xE1, 0xEC, 0x80, 0xBF, 3},
                                  Form{0xED, 0xED, 0x80, 0x9F, 3},
                                  Form{0xEE, 0xEF, 0x80, 0xBF, 3},
                                  Form{0xF0, 0xF0, 0x90, 0xBF, 4},
                                  Form{0xF1, 0xF3, 0x80, 0xBF, 4},
                                  Form{0xF4, 0xF4, 0x80, 0x8F, 4}};
    const auto is_within = [&](std::size_t i, unsigned first, unsigned last) {
        if (i >= text.size()) return false;
        const auto byte = static_cast<unsigned char>(text[i]);
        return byte >= first && byte <= last;
    };
    for (const Form& form : forms) {
        if (!is_within(at, form.first, form.last)) continue;
        bool is_whole = form.length < 2 || is_within(at + 1, form.second_from, form.second_to);
        for (std::size_t i = 2; i < form.length; ++i) is_whole = is_whole && is_within(at + i, 0x80, 0xBF);
        return is_whole ? form.length : 0;
    }
    return 0;
}

std::string escape(unsigned char letter) {
    constexpr std::string_view digits = "0123456789abcdef";
    if (letter == '\n') return "\\n";
    if (letter == '\t') return "\\t";
    if (letter == '\r') return "\\r";
    return {'\\', 'x', digits[letter / 16], digits[letter % 16]};
}

}  // namespace

std::string printable(std::string_view text) {
    std::string shown;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t character = character_length(text, at);
        const std::size_t length = std::max<std::size_t>(1, character);
        if (character == 0 || control_length(text, at) > 0)
            shown += escape(static_cast<unsigned char>(text[at + length - 1]));
        else
            shown += text.substr(at, length);
        at += length;
    }
    return shown;
}

std::string shorten(std::string_view text) {
    constexpr std::size_t most = 200;
    if (text.size() <= most) return std::string(text);
    std::size_t end = most;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) --end;
    return std::string(text.substr(0, end)) + "…";
}

std::size_t find_control_character(std::string_view text) {
    constexpr std::string_view layout = "\n\r\t";
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (control_length(text, at) > 0 && layout.find(text[at]) == std::string_view::npos) return at;
    }
    return std::string_view::npos;
}

}  // namespace gxrod
