#pragma once

#include <string_view>

namespace gxrod {

// Says what to take instead of a quantity that has no sign, or is sorted by size, where cycles are counted;
// "" of others.
std::string_view find_signed_instead(std::string_view word);

// Returns whether a word is that of the exposure of a material.
bool is_exposure(std::string_view word);

}  // namespace gxrod
