#pragma once

#include <string>
#include <string_view>

#include "deck/text/fault_list.hpp"

namespace gxrod {

// Explains in a user's words where and why a text is not TOML. `place` and `description` come from the
// parser.
DeckFault explain_syntax_fault(std::string_view text,
                               const std::string& file,
                               const Place& place,
                               std::string_view description);

}  // namespace gxrod
