#include "deck/expressions/expression_tokens.hpp"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "deck/expressions/expression.hpp"

namespace gxrod {
namespace {

constexpr std::string_view available_operators = "+ - * / ^ < <= > >= == != && || ?:";

bool is_digit(char letter) { return std::isdigit(static_cast<unsigned char>(letter)) != 0; }
bool is_name_start(char letter) {
    return std::isalpha(static_cast<unsigned char>(letter)) != 0 || letter == '_';
}
bool is_name_letter(char letter) { return is_name_start(letter) || is_digit(letter); }

// The end of the digits at `end`.
std::size_t skip_digits(const std::string& text, std::size_t end) {
    while (end < text.size() && is_digit(text[end])) ++end;
    return end;
}

bool starts_number(const std::string& text, std::size_t begin) {
    return is_digit(text[begin]) ||
           (text[begin] == '.' && begin + 1 < text.size() && is_digit(text[begin + 1]));
}

Token read_number(const std::string& text, std::size_t begin) {
    if (text[begin] == '0' && begin + 1 < text.size() &&
        std::string_view("xXbBoO").find(text[begin + 1]) < 6) {
        throw ExpressionError("hexadecimal, octal and binary numbers are not read; write a decimal number");
    }
    std::size_t end = skip_digits(text, begin);
    if (end < text.size() && text[end] == '.') end = skip_digits(text, end + 1);
    if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
        const bool has_sign = end + 1 < text.size() && (text[end + 1] == '+' || text[end + 1] == '-');
        const std::size_t exponent = end + (has_sign ? 2 : 1);
        if (exponent < text.size() && is_digit(text[exponent])) end = skip_digits(text, exponent);
    }
    const std::string number = text.substr(begin, end - begin);
    if (end < text.size() && (text[end] == '_' || text[end] == '.')) {
        throw ExpressionError(fmt::format("\"{}{}\" is not a number", number, text[end]));
    }
    if (!std::isfinite(std::strtod(number.c_str(), nullptr))) {
        throw ExpressionError(fmt::format("{} is too large for a number", number));
    }
    return {TokenKind::number, number, begin};
}

Token read_name(const std::string& text, std::size_t begin) {
    std::size_t end = begin;
    while (end < text.size() && is_name_letter(text[end])) ++end;
    return {TokenKind::name, text.substr(begin, end - begin), begin};
}

// One character, whole in UTF-8.
std::string character_at(const std::string& text, std::size_t begin) {
    std::size_t end = begin + 1;
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) ++end;
    return text.substr(begin, end - begin);
}

[[noreturn]] void refuse_character(const std::string& text, std::size_t begin) {
    switch (text[begin]) {
        case '=':
            throw ExpressionError("\"=\" would assign; write \"==\" to compare");
        case '"':
        case '\'':
            throw ExpressionError("an expression has no text in it");
        case '!':
            throw ExpressionError("\"!\" is not available; write \"(x == 0)\" for \"not x\"");
        case '&':
        case '|':
            throw ExpressionError(fmt::format("\"{0}\" is not available; write \"{0}{0}\"", text[begin]));
        case '#':
            throw ExpressionError(
                "hexadecimal, octal and binary numbers are not read; write a decimal number");
        default:
            throw ExpressionError(fmt::format(
                "\"{}\" is not an operator; available: {}", character_at(text, begin), available_operators));
    }
}

Token read_operator(const std::string& text, std::size_t begin) {
    const std::string pair = text.substr(begin, 2);
    if (pair == "**") throw ExpressionError("\"**\" is not an operator; write \"^\" for a power");
    if (pair == "<>") throw ExpressionError("\"<>\" is not an operator; write \"!=\"");
    for (const char* operation : {"<=", ">=", "==", "!=", "&&", "||"}) {
        if (pair == operation) return {TokenKind::operation, pair, begin};
    }
    if (std::string_view("+-*/^<>?:").find(text[begin]) == std::string_view::npos)
        refuse_character(text, begin);
    return {TokenKind::operation, text.substr(begin, 1), begin};
}

Token read_token(const std::string& text, std::size_t begin) {
    if (starts_number(text, begin)) return read_number(text, begin);
    if (is_name_start(text[begin])) return read_name(text, begin);
    switch (text[begin]) {
        case '(':
            return {TokenKind::open, "(", begin};
        case ')':
            return {TokenKind::close, ")", begin};
        case ',':
            return {TokenKind::comma, ",", begin};
        default:
            return read_operator(text, begin);
    }
}

}  // namespace

std::vector<Token> split_expression(const std::string& expression) {
    std::vector<Token> tokens;
    for (std::size_t at = 0; at < expression.size();) {
        if (std::isspace(static_cast<unsigned char>(expression[at])) != 0) {
            ++at;
            continue;
        }
        tokens.push_back(read_token(expression, at));
        at += tokens.back().text.size();
    }
    if (tokens.empty()) throw ExpressionError("the expression is empty");
    return tokens;
}

}  // namespace gxrod
