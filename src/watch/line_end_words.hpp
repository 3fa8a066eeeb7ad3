#pragma once

#include <string>
#include <vector>

#include "model/settings/history_request.hpp"

namespace gxrod {

// Lists the words of the quantities that the end of a line, or the line as a whole, is recorded with, as far
// as it has them.
std::vector<std::string> list_line_end_words(const Watched& target, const Model& model);

}  // namespace gxrod
