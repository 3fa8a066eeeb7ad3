#pragma once

#include <optional>

#include "cross_section/cross_section.hpp"

// How a section expands by heat.
namespace gxrod {

// Returns whether a material of the section expands.
bool expands(const CrossSection& section);

// Returns the strain along the rod for each degree if the section expands alike all over, without stress;
// nothing if its parts hold each other.
std::optional<double> find_even_expansion(const CrossSection& section);

}  // namespace gxrod
