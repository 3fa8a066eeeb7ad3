#pragma once

#include <filesystem>

namespace gxrod {

// Draws the figures whose data a study left in the folder, by the gxrod-plot next to this program. Throws
// FileError if that is not there or fails; the data stay.
void draw_figures(const std::filesystem::path& folder);

}  // namespace gxrod
