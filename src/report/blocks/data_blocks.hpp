#pragma once

#include <fmt/format.h>

#include <concepts>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "report/base64.hpp"

namespace gxrod {

// Bytes of text around the base64 text of one block of numbers in a page.
inline constexpr std::size_t block_frame_bytes = 80;

// Writes numbers, little-endian, as a script element "data-NAME" that browsers do not run. `write` gets the
// Base64Writer.
template <std::invocable<Base64Writer&> Write>
void write_block(std::ostream& out, const std::string& name, Write&& write) {
    out << fmt::format("<script type=\"text/plain\" id=\"data-{}\">", name);
    Base64Writer base64(out);
    write(base64);
    base64.finish();
    out << "</script>\n";
}

template <class Number>
void write_block(std::ostream& out, const std::string& name, const std::vector<Number>& numbers) {
    write_block(out, name, [&](Base64Writer& base64) { base64.write(std::span<const Number>(numbers)); });
}

}  // namespace gxrod
