#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "results/file/output_file.hpp"

namespace gxrod {

// Writes one HTML page that shows a study of a deck, `gxrod verify DECK`, from its description with curves.
// Returns its size in bytes. Throws FileError if the page exists and must not be replaced, or cannot be
// written.
std::size_t write_study_page(const nlohmann::ordered_json& study,
                             const std::filesystem::path& page,
                             Existing existing);

}  // namespace gxrod
