#pragma once

#include <string>
#include <string_view>

namespace gxrod {

// Returns a text from a file as messages show it. Control characters, which a terminal would obey, become \n,
// \t or \x1b; other characters from U+00A0 on stay. Bytes that are not UTF-8 become, for example, \xd6.
std::string printable(std::string_view text);

// Returns a UTF-8 text as messages quote it: a long one is cut and ends with "…".
std::string shorten(std::string_view text);

// Finds the first control character other than newline, carriage return and tab; npos if there is none.
std::size_t find_control_character(std::string_view text);

}  // namespace gxrod
