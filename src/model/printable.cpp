#include "model/printable.hpp"

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
        const std::size_t length = control_length(text, at);
        if (length == 0) {
            shown += text[at++];
            continue;
        }
        shown += escape(static_cast<unsigned char>(text[at + length - 1]));
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
