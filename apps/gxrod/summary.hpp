#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "run/run.hpp"

namespace gxrod {

// Writes JSON to a file, or to standard output for "-". Throws FileError.
void write_json(const std::string& target, const nlohmann::ordered_json& json);

// Writes the summary of a run as one JSON object to a file, or to standard output for "-". Throws FileError.
void write_summary(const std::string& target,
                   const RunSummary& summary,
                   const std::string& deck,
                   const std::string& results);

}  // namespace gxrod
