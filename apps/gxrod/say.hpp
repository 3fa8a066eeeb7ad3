#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <utility>

namespace gxrod {

// Prints, whether anybody reads it or not: work goes on where a pipe was closed.
template <class... Arguments>
void say(std::FILE* out, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    const std::string text = fmt::format(format, std::forward<Arguments>(arguments)...);
    std::fwrite(text.data(), 1, text.size(), out);
}

}  // namespace gxrod
