#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/model.hpp"

namespace gxrod {

// Returns the section of a rod at a place; where it varies, that of the nearest node.
const Section& section_at(const Model& model, const RodPlace& place);

// Returns the arc length of a place, from the start of the rod.
double arc_length_at(const Model& model, const RodPlace& place);

// Returns the shape on cells at a place; nullptr without one, and where a law makes its stresses others.
std::shared_ptr<const CrossSection> find_shape(const Model& model, const RodPlace& place);

// A shape on cells that a model's rods have, once.
struct ListedShape {
    std::shared_ptr<const CrossSection> shape;
    std::string name;  // "post"; where it varies "haunch on beam, s = 0.25", the first place that has it
};

// Lists the shapes on cells at the ends and middles of all elements, without those where a law acts.
std::vector<ListedShape> list_shapes(const Model& model);

}  // namespace gxrod
