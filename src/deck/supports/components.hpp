#pragma once

#include <array>
#include <string>
#include <vector>

// The words for components of displacements and rotations: of `fix`, and of what a generic joint holds.
namespace gxrod {

std::vector<std::string> component_words();
// Returns which of x, y, z, rx, ry, rz a word names.
std::array<bool, 6> components_of(const std::string& word);

}  // namespace gxrod
