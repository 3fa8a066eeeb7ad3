#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/model.hpp"

namespace gxrod {

// Returns the section of a rod at a place; where it varies, that of the nearest node.
const Section& section_at(const Model& model, const RodPlace& place);

// Says why stresses of a section do not follow from its resultants, as what it has or is: "has a law, …"; ""
// if they do. Where contents press on it, or water on a hollow section, its wall carries more than the
// resultants, and rings of it, too.
std::string explain_no_stress(const Model& model, const Section& section);

// Returns the arc length of a place, from the start of the rod.
double arc_length_at(const Model& model, const RodPlace& place);

// Returns whether a place is at a node of its element.
bool is_at_node(const Model& model, const RodPlace& place);

// Lists the places of an element at which stresses are compared: its ends and its middle; where the section
// varies, its nodes.
std::vector<RodPlace> list_stress_places(const Model& model, int rod, int element);

// A shape on cells, and its part of the values at a place.
struct ShapePart {
    std::shared_ptr<const CrossSection> shape;
    double part = 1.0;
    const Section* between = nullptr;  // the section at the place, where that lies between two stations
};

// Lists the shapes at a place, that with the largest part first: one, or of a place between two stations, or
// between two nodes where the section varies, several. Empty without a shape, and where a law makes stresses
// others.
std::vector<ShapePart> find_shapes(const Model& model, const RodPlace& place);

// A shape on cells that a model's rods have, once.
struct ListedShape {
    std::shared_ptr<const CrossSection> shape;
    std::string name;  // "post"; where it varies "haunch along beam, s = 0.25", the first place that has it
};

// Lists the shapes of all stress places, without those where a law acts.
std::vector<ListedShape> list_shapes(const Model& model);

}  // namespace gxrod
