#pragma once

#include <set>
#include <string>

#include "deck/expressions/expression.hpp"

// The grammar of expressions, which is checked before muParser reads them, as muParser accepts some mistakes
// silently ("t = 15" assigns, "1,2" is 2, "0 < t < 5" is always true).
namespace gxrod {

// Variables that an expression can use in addition to numbers, pi and the deck's parameters.
enum class Variables {
    none,          // nothing: a constant
    time,          // t, the time, and the deck's functions
    line,          // also s, the arc length from a rod's start
    arc,           // s, and the deck's functions; not t
    place,         // x, y, z of the reference position, s and the deck's functions; not t
    field,         // t, x, y, z of a position, and the deck's functions
    motion,        // t, x, y, z of a point's position, vx, vy, vz of its velocity, rx, ry, rz of its rotation
                   // vector, wx, wy, wz of its angular velocity, and the deck's functions
    motion_along,  // also s, the arc length from a rod's start
    spring,        // length, rate of a spring's length, and the deck's functions; not t
    angle          // angle about a centre, and the deck's functions; not t
};

// The names that an expression uses, without the built-in ones.
struct ExpressionNames {
    std::set<std::string> parameters;
    std::set<std::string> functions;
    std::set<std::string> inputs;
    std::set<std::string> variables;
    double operations = 0.0;  // largest number in one evaluation, with the functions that it calls
    int depth = 0;            // depth of functions that call functions
};

// Returns whether expressions can use the word as a name: letters, digits and _, no digit first.
bool is_identifier(const std::string& word);

// Explains why a parameter or function cannot have this name, or returns "".
std::string explain_unusable_name(const std::string& name);

// Limits on evaluating one expression.
inline constexpr std::size_t most_expression_letters = 10'000;
inline constexpr double most_operations = 1e5;
inline constexpr int most_function_depth = 100;

// Checks all of an expression except the arrangement of its operators. Throws ExpressionError.
ExpressionNames check_expression(const std::string& expression, const Symbols& symbols, Variables variables);

}  // namespace gxrod
