#pragma once

#include <nlohmann/json_fwd.hpp>

#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// Describes the ends of lines that a run has recorded as a table of the page: null if there are none.
nlohmann::ordered_json describe_line_ends(const Hdf5Reader& file);

}  // namespace gxrod
