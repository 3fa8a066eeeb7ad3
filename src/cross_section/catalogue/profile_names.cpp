#include "cross_section/catalogue/profile_names.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace gxrod {
namespace {

// In capitals, without blanks and underlines; × and * are X, and a comma is a point.
std::string plain_name(std::string_view name) {
    constexpr std::string_view times = "\u00d7";
    std::string text;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const auto letter = static_cast<unsigned char>(name[i]);
        if (name.substr(i).starts_with(times)) {
            text += 'X';
            i += times.size() - 1;
        } else if (letter == '*') {
            text += 'X';
        } else if (letter == ',') {
            text += '.';
        } else if (std::isspace(letter) == 0 && letter != '_') {
            text += static_cast<char>(std::toupper(letter));
        }
    }
    return text;
}

// Reads a number such as 1, 2.5, 3/8 or 1-3/8 from the front of a text and takes it away.
double take_number(std::string_view& text) {
    const auto take = [&] {
        double value = 0.0;
        const auto end =
            std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
        text.remove_prefix(end.ec == std::errc() ? static_cast<std::size_t>(end.ptr - text.data()) : 1);
        return value;
    };
    const auto follows = [&](char sign) {
        if (text.size() < 2 || text[0] != sign || std::isdigit(static_cast<unsigned char>(text[1])) == 0)
            return false;
        text.remove_prefix(1);
        return true;
    };
    double number = take();
    if (follows('/')) return number / take();
    if (follows('-')) {
        const double numerator = take();
        number += follows('/') ? numerator / take() : 0.0;
    }
    return number;
}

bool begins_number(std::string_view text) {
    return !text.empty() && (std::isdigit(static_cast<unsigned char>(text[0])) != 0 || text[0] == '.');
}

void set_usual_spelling(ProfileName& name) {
    const bool is_one_letter = name.rest == "A" || name.rest == "B" || name.rest == "M";
    if (name.letters == "HE" && is_one_letter) {
        name.letters += name.rest;
        name.rest.clear();
    }
    const bool is_square = name.letters == "L" || name.letters == "SHS";
    if (is_square && name.numbers.size() == 2) name.numbers.insert(name.numbers.begin(), name.numbers[0]);
}

}  // namespace

ProfileName parse_profile_name(std::string_view name) {
    const std::string text = plain_name(name);
    std::string_view left = text;
    ProfileName parsed;
    while (!left.empty()) {
        if (begins_number(left)) {
            parsed.numbers.push_back(take_number(left));
            // Between numbers.
            if (left.starts_with('X') && begins_number(left.substr(1))) left.remove_prefix(1);
            continue;
        }
        (parsed.numbers.empty() ? parsed.letters : parsed.rest) += left.front();
        left.remove_prefix(1);
    }
    set_usual_spelling(parsed);
    return parsed;
}

double measure_difference(const ProfileName& a, const ProfileName& b) {
    double sum = a.rest == b.rest ? 0.0 : 1e-3;
    for (std::size_t i = 0; i < std::max(a.numbers.size(), b.numbers.size()); ++i) {
        const double one = i < a.numbers.size() ? a.numbers[i] : 0.0;
        const double other = i < b.numbers.size() ? b.numbers[i] : 0.0;
        sum += std::abs(one - other);
    }
    return sum;
}

}  // namespace gxrod
