#pragma once

#include <string>
#include <vector>

#include "deck/expressions/expression_syntax.hpp"

namespace gxrod {

// A number on which the form of an expression depends, as text: model/time/time_function.hpp says what for.
struct SwitchSource {
    // The first is in the variables of the expression; each other one is in t, which is the value of the one
    // before.
    std::vector<std::string> chain;
    std::vector<double> knots;
    bool has_time = false;        // whether t occurs in the first
    bool has_arc_length = false;  // whether s does
};

// Those of comparisons, of abs, sign, sqrt, min, max, asin, acos, atan2 and broken powers, of tables, and of
// the functions that the expression calls; of a checked expression. The first most_switches of them if there
// are more.
inline constexpr std::size_t most_switches = 200;
std::vector<SwitchSource> find_switches(const std::string& expression, const Symbols& symbols);

}  // namespace gxrod
