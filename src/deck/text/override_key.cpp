#include "deck/text/override_key.hpp"

#include <fmt/format.h>

#include <charconv>

namespace gxrod {
namespace {

bool is_bare_letter(char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
           (letter >= '0' && letter <= '9') || letter == '_' || letter == '-';
}

// Takes a key, with or without quotes, off the front; empty if there is none.
std::string take_name(std::string_view& rest) {
    if (!rest.empty() && rest[0] == '"') {
        const std::size_t end = rest.find('"', 1);
        if (end == std::string_view::npos) return "";
        std::string name(rest.substr(1, end - 1));
        rest.remove_prefix(end + 1);
        return name;
    }
    std::size_t end = 0;
    while (end < rest.size() && is_bare_letter(rest[end])) ++end;
    std::string name(rest.substr(0, end));
    rest.remove_prefix(end);
    return name;
}

// Takes "[3]" off the front.
std::optional<std::size_t> take_index(std::string_view& rest) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(rest.data() + 1, rest.data() + rest.size(), index);
    if (error != std::errc() || end == rest.data() + rest.size() || *end != ']') return std::nullopt;
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()) + 1);
    return index;
}

}  // namespace

std::optional<std::vector<KeyStep>> split_key(std::string_view key) {
    std::vector<KeyStep> steps;
    while (true) {
        std::string name = take_name(key);
        if (name.empty()) return std::nullopt;
        steps.emplace_back(std::move(name));
        while (!key.empty() && key[0] == '[') {
            const auto index = take_index(key);
            if (!index) return std::nullopt;
            steps.emplace_back(*index);
        }
        if (key.empty()) return steps;
        if (key[0] != '.') return std::nullopt;
        key.remove_prefix(1);
    }
}

std::string join_key(const std::vector<KeyStep>& steps, std::size_t count) {
    std::string path;
    for (std::size_t i = 0; i < count; ++i) {
        if (const auto* name = std::get_if<std::string>(&steps[i])) {
            path += (path.empty() ? "" : ".") + *name;
        } else {
            path += fmt::format("[{}]", std::get<std::size_t>(steps[i]));
        }
    }
    return path;
}

}  // namespace gxrod
