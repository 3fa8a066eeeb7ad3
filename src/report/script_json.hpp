#pragma once

#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace gxrod {

// Writes JSON that can stand in a script element of a page: ASCII, without '<', '>' and '&', so that no text
// in it can end the element or begin another. Bytes that are not UTF-8 become U+FFFD; numbers that are not
// finite become null.
std::string write_script_json(const nlohmann::ordered_json& json);

// Writes the script element that a page reads first.
void write_description(std::ostream& out, const nlohmann::ordered_json& json);

}  // namespace gxrod
