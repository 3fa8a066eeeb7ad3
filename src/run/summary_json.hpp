#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "run/run.hpp"

namespace gxrod {

// Returns the summary of a run as one object; docs/guide/first_run.md lists its keys.
nlohmann::ordered_json describe_summary(const RunSummary& summary,
                                        const std::string& deck,
                                        const std::string& results);

}  // namespace gxrod
