#pragma once

#include <optional>
#include <string>

#include "cross_section/outlines/outline.hpp"
#include "deck/sections/build_sections.hpp"
#include "deck/sections/section_tables.hpp"

namespace gxrod {

// The outline of a shape that is meshed.
struct ShapeOutline {
    std::string source;  // what it is, for people: "IPE 200", "I", "polygon"
    Outline outline;     // around its centroid, but with ShapeOrigin::given in its own coordinates
    ShapeOrigin origin = ShapeOrigin::centroid;
};

// Returns whether a shape is meshed: neither a circle nor a tube nor a rectangle.
bool has_outline(const ShapeTable& shape);

// Draws a shape that is meshed, in the deck's lengths, at a place along a rod. Adds faults and returns
// nothing if its numbers give no outline there.
std::optional<ShapeOutline> find_outline(const ShapeTable& shape,
                                         const SectionPlace& at,
                                         const BuildContext& context);

// Adds a fault if keys of meshed shapes are given with another one.
void check_outline_keys(const ShapeTable& shape, const BuildContext& context);

}  // namespace gxrod
