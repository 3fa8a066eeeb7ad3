#include "deck/expressions/near_comparisons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "deck/expressions/expression_tokens.hpp"

namespace gxrod {
namespace {

using Tokens = std::span<const Token>;

constexpr std::array<std::string_view, 6> comparisons{"==", "!=", "<", "<=", ">", ">="};
constexpr std::array<std::string_view, 4> weaker{"&&", "||", "?", ":"};

template <std::size_t count>
bool is_one_of(const Token& token, const std::array<std::string_view, count>& operators) {
    return token.kind == TokenKind::operation && std::ranges::find(operators, token.text) != operators.end();
}

// The tokens outside all parentheses for which `is_meant` holds.
template <class Predicate>
std::vector<std::size_t> find_outside(Tokens tokens, Predicate&& is_meant) {
    std::vector<std::size_t> found;
    int depth = 0;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (tokens[i].kind == TokenKind::close) --depth;
        if (depth == 0 && is_meant(tokens[i])) found.push_back(i);
        if (tokens[i].kind == TokenKind::open) ++depth;
    }
    return found;
}

std::string rewrite(Tokens tokens);

// The tokens as they are, but for what stands in parentheses.
std::string rewrite_inner(Tokens tokens) {
    std::string text;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        text += tokens[i].text;
        if (tokens[i].kind != TokenKind::open) continue;
        std::size_t end = i + 1;
        for (int depth = 1; end < tokens.size(); ++end) {
            if (tokens[end].kind == TokenKind::open) ++depth;
            if (tokens[end].kind == TokenKind::close && --depth == 0) break;
        }
        text += rewrite(tokens.subspan(i + 1, end - i - 1));
        i = end - 1;
    }
    return text;
}

// A comparison, or what has none.
std::string rewrite_comparison(Tokens tokens) {
    const auto found = find_outside(tokens, [](const Token& token) { return is_one_of(token, comparisons); });
    if (found.size() != 1) return rewrite_inner(tokens);
    const std::string a = rewrite_inner(tokens.first(found[0]));
    const std::string b = rewrite_inner(tokens.subspan(found[0] + 1));
    const std::string difference = fmt::format("(({})-({}))", a, b);
    const std::string near = fmt::format("(1e-9*(1+abs({})+abs({})))", a, b);
    const std::string& sign = tokens[found[0]].text;
    if (sign == "==") return fmt::format("(abs({})<={})", difference, near);
    if (sign == "!=") return fmt::format("(abs({})>{})", difference, near);
    const bool takes_equal = sign.size() == 2;
    const bool is_less = sign[0] == '<';
    return fmt::format("({}{}{}{})", difference, sign, takes_equal == is_less ? "" : "-", near);
}

std::string rewrite(Tokens tokens) {
    const auto separates = [](const Token& token) {
        return token.kind == TokenKind::comma || is_one_of(token, weaker);
    };
    std::string text;
    std::size_t begin = 0;
    for (const std::size_t at : find_outside(tokens, separates)) {
        text += rewrite_comparison(tokens.subspan(begin, at - begin)) + tokens[at].text;
        begin = at + 1;
    }
    return text + rewrite_comparison(tokens.subspan(begin));
}

}  // namespace

std::string compare_nearly(const std::string& expression) {
    const std::vector<Token> tokens = split_expression(expression);
    return rewrite(tokens);
}

}  // namespace gxrod
