#pragma once

#include <span>
#include <string>
#include <string_view>

#include "cross_section/cross_section.hpp"
#include "deck/places/build_context.hpp"

namespace gxrod {

// Adds a fault at a place of the deck if none of the materials of sections has what a criterion of failure
// needs; else notes which of them are compared by another criterion, or not at all. `word` is a criterion's.
void check_materials_of(std::string_view word,
                        std::span<const ElasticMaterial> materials,
                        const Place& place,
                        const std::string& path,
                        const BuildContext& context);

// Notes which materials of sections are compared by another criterion than this, or not at all, if some are.
void note_other_criteria(std::string_view word,
                         std::span<const ElasticMaterial> materials,
                         const std::string& path,
                         const BuildContext& context);

// Compares the point of a section, (y, z) in its axes, of which a history has the stresses, with the points
// of its cells: notes the nearest one if that is some way off, and adds a fault if it is far away.
void check_section_point(const PlanePoint& point,
                         const CrossSection& shape,
                         const Place& place,
                         const std::string& path,
                         const BuildContext& context);

}  // namespace gxrod
