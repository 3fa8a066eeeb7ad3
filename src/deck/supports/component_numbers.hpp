#pragma once

#include <array>
#include <string>

#include "deck/table/table.hpp"

// A number for each component of a displacement and a rotation: what bushings and supports that yield resist.
namespace gxrod {

struct ComponentNumbers : TableHead {
    std::array<double, 6> values{};
};

// Declares the table of stiffness, or of damping, at this path, such as "bushing.NAME.stiffness".
TableSpec stiffness_components(const std::string& path);
TableSpec damping_components(const std::string& path);

}  // namespace gxrod
