#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace gxrod {

enum class TokenKind { number, name, operation, open, close, comma };

struct Token {
    TokenKind kind;
    std::string text;
    std::size_t offset;  // bytes before it in the expression
};

// Splits an expression. Throws ExpressionError at a character that no expression has.
std::vector<Token> split_expression(const std::string& expression);

}  // namespace gxrod
