#pragma once

#include <optional>
#include <string>

#include "cross_section/cross_section.hpp"

namespace gxrod {

// Describes what a picture of a section shows in addition to its mesh: the stress of resultants, or the
// layers without them.
struct PictureRequest {
    std::optional<Vec6> resultants = std::nullopt;  // (N, Vy, Vz, T, My, Mz), about the origin
    bool shows_cells = true;                        // edges of cells
};

// Draws a section as SVG, as seen against x: y to the right, z up. It shows the origin, the centres, the
// principal axes of bending, fibres of plies, and the von Mises stress with its largest value.
std::string draw_section(const CrossSection& section, const PictureRequest& request = {});

}  // namespace gxrod
