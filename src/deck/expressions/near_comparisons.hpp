#pragma once

#include <string>

namespace gxrod {

// Rewrites the comparisons of an expression so that numbers are equal that differ by round-off, 1e-9 of
// 1 + |a| + |b|: "z == 3*h" holds where z is 0.3 and h is 0.1. Throws ExpressionError.
std::string compare_nearly(const std::string& expression);

}  // namespace gxrod
