#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

namespace gxrod {

// Prints; a closed pipe or a full disk does not stop the work. On a terminal, sentences are broken between
// words.
void say_text(std::FILE* out, std::string_view text);

template <class... Arguments>
void say(std::FILE* out, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    say_text(out, fmt::format(format, std::forward<Arguments>(arguments)...));
}

// Said without need of memory.
inline constexpr std::string_view out_of_memory = "gxrod: out of memory\n";

// Why what was said on standard output is not all there, or "". A closed pipe is no reason: nobody asked for
// it.
std::string describe_output_error();

}  // namespace gxrod
