#pragma once

#include <optional>

#include "check/surroundings/line_at_rest.hpp"

namespace gxrod {

// The lowest frequency, cycles per time, at which what hangs swings across itself in water, its added mass
// included: of a beam under the tension that is held where supports hold it. nullopt if nothing holds it, if
// it falls over, or if a body at an end swings with it.
std::optional<double> find_lowest_frequency(const Model& model, const Rod& rod, const LineAtRest& line);

}  // namespace gxrod
