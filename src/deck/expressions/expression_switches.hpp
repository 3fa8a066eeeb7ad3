#pragma once

#include <string>
#include <vector>

#include "deck/expressions/expression_syntax.hpp"

namespace gxrod {

// The text of a number on which the form of an expression depends; model/time/time_function.hpp tells its
// use.
struct SwitchSource {
    // The first text is in the variables of the expression; each other one is in t, which stands for the
    // value of the one before.
    std::vector<std::string> chain;
    std::vector<double> knots;
    bool has_time = false;        // whether t occurs in the first
    bool has_arc_length = false;  // whether s occurs in the first
};

// Finds the switches of a checked expression: of comparisons, of abs, sign, sqrt, min, max, asin, acos, atan2
// and broken powers, of tables, and of the functions that it calls. Returns only the first most_switches if
// there are more.
inline constexpr std::size_t most_switches = 200;
std::vector<SwitchSource> find_switches(const std::string& expression, const Symbols& symbols);

}  // namespace gxrod
