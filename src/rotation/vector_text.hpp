#pragma once

#include <string>

#include "rotation/types.hpp"

namespace gxrod {

// Writes a vector as a sentence has it: "(1, 0, 0)". Components smaller than `least` are zero, and −0 is 0.
std::string in_parentheses(const Vec3& v, int digits = 6, double least = 0.0);

// Writes a vector as a deck has it: "[1, 0, 0]".
std::string in_brackets(const Vec3& v, int digits = 6, double least = 0.0);

}  // namespace gxrod
