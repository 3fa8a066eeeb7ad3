#pragma once

#include <optional>

#include "check/surroundings/line_at_rest.hpp"

namespace gxrod {

// Finds the lowest frequency, cycles per time, of transverse motions of the hanging part in water, added mass
// included: a beam under tension, held at its supports. Returns nullopt if nothing holds it, if it would fall
// over, or if a body at an end swings with it.
std::optional<double> find_lowest_frequency(const Model& model, const Rod& rod, const LineAtRest& line);

}  // namespace gxrod
