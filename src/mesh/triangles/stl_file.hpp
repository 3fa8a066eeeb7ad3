#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "rotation/types.hpp"

namespace gxrod {

using Corners = std::array<Vec3, 3>;

// Reads the triangles of an STL file, as text or bytes. Throws MeshError.
std::vector<Corners> read_stl(std::string_view bytes);

// Whether an STL file is text that has more solids than ends of them: the rest of it may be lost.
bool lacks_end_of_stl(std::string_view bytes);

}  // namespace gxrod
