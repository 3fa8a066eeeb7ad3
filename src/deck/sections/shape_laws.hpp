#pragma once

#include <memory>
#include <optional>

#include "cross_section/plastic_capacity.hpp"
#include "deck/sections/build_sections.hpp"

// Laws that follow from the shape of a section and the yield stresses of its materials.
namespace gxrod {

// Holds what they are made of: a section at a place, with its stiffness and its shape about its own point and
// in its own axes.
struct ShapeLawSource {
    const SectionTable& given;
    const SectionPlace& at;
    const Section& section;
    const BuildContext& context;
};

// Returns whether a section yields by the yield stress of its material, without a law of its own.
bool yields_by_shape(const ShapeLawSource& source);

// Makes layers or fibres for a section that yields by its shape. With a fault, nullptr.
std::shared_ptr<const SectionLaw> make_shape_law(const ShapeLawSource& source);

// Finds the resultants at which a section yields as a whole. Without them adds a fault to `yield` of a law.
std::optional<PlasticCapacity> find_plastic_capacity(const PlasticTable& law, const ShapeLawSource& source);

}  // namespace gxrod
