#pragma once

#include "model/model.hpp"

namespace gxrod {

// Returns the section of a rod at a place; where it varies, that of the nearest node.
const Section& section_at(const Model& model, const RodPlace& place);

// Returns its shape on cells; nullptr without one, and where a law makes its stresses others.
std::shared_ptr<const CrossSection> find_shape(const Model& model, const RodPlace& place);

}  // namespace gxrod
