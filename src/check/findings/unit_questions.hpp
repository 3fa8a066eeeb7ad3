#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/findings/finding.hpp"
#include "model/model.hpp"

namespace gxrod {

// The units of a deck, in those of the SI.
struct DeckUnits {
    double length = 1.0;         // metres
    double time = 1.0;           // seconds
    std::optional<double> mass;  // kilograms, if the text names a mass or a force
};

// Reads units such as "mm t s", "m kN" or "in lbf"; the second is the time if none is named. nullopt without
// a length.
std::optional<DeckUnits> read_units(const std::string& text);

// Asks whether gravity, moduli and densities of a model, which has the units that a deck names, are those of
// the earth and of its materials. Nothing without units.
std::vector<Finding> question_units(const Model& model, const std::string& units);

}  // namespace gxrod
