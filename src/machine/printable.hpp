#pragma once

#include <string>
#include <string_view>

namespace gxrod {

// A text from a file as a message shows it: control characters, which a terminal would obey, as \n, \t or
// \x1b. Of UTF-8 only those below U+00A0 are changed; bytes that are no UTF-8 are shown as \xd6.
std::string printable(std::string_view text);

// A text of UTF-8 of any length, as a message quotes it: its beginning and "…" if it is long.
std::string shorten(std::string_view text);

// The place of the first control character but newline, carriage return and tab; npos if there is none.
std::size_t find_control_character(std::string_view text);

}  // namespace gxrod
