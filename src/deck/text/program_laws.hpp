#pragma once

#include <string_view>

namespace gxrod {

// Begins the deck in results of a run to which a program gave laws or functions of its own.
inline constexpr std::string_view program_laws_note =
    "# A program ran this deck with laws or functions of its own, which are not in it.\n";

}  // namespace gxrod
