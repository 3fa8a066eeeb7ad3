#pragma once

#include <string>
#include <string_view>

namespace gxrod {

// SHA-256 of a text, as 64 lower-case hexadecimal digits.
std::string sha256_hex(std::string_view text);

}  // namespace gxrod
