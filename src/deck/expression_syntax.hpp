#pragma once

#include <set>
#include <string>

#include "deck/expression.hpp"

// The grammar of expressions: what the reader lets through to muParser, which would read some mistakes
// silently
// ("t = 15" assigns, "1,2" is 2, "0 < t < 5" is always true).
namespace gxrod {

enum class TimeUse {
    none,  // a constant: numbers, parameters, pi
    free   // also t and the deck's functions
};

// The names that an expression uses, without the built-in ones.
struct ExpressionNames {
    std::set<std::string> parameters;
    std::set<std::string> functions;
    bool time = false;
};

// Whether expressions can use the word as a name: letters, digits and _, no digit first.
bool is_identifier(const std::string& word);

// Why a parameter or function cannot have this name, or "".
std::string explain_unusable_name(const std::string& name);

// Checks an expression up to the arrangement of its operators. Throws ExpressionError.
ExpressionNames check_expression(const std::string& expression, const Symbols& symbols, TimeUse time);

}  // namespace gxrod
