#pragma once

#include "model/sections/section_at.hpp"
#include "results/file/hdf5_objects.hpp"

namespace gxrod {

// Writes /sections, the shapes with their cells and the stress operator at each point, unless the file has it
// already. Throws Hdf5Error.
void write_cross_sections(const Hdf5Handle& root, const std::vector<ListedShape>& shapes);

}  // namespace gxrod
