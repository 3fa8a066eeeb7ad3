#pragma once

#include <string>
#include <vector>

namespace gxrod {

// Names the components of a quantity with `width` numbers: w x y z of quaternions, xx yy zz yz xz xy of
// stresses, 1 2 3 of principal stresses, y z of places in a section, x y z of other vectors; none of a
// number.
std::vector<std::string> list_component_labels(const std::string& quantity, std::size_t width);

}  // namespace gxrod
