#pragma once

#include <optional>
#include <string>

#include "model/model.hpp"
#include "model/settings/settings.hpp"

namespace gxrod {

// Of the linear static answer of the undeformed model to its gravity and loads, at the time at which these
// are largest: how far it is from what a deck in one set of units gives.
struct StaticScale {
    double time = 0.0;
    double displacement = 0.0;  // the largest, relative to the model's size
    int node = -1;              // where it is
    double strain = 0.0;        // the largest: of the line, or of the section by bending and twist
    int rod = -1;               // where it is
};

// nullopt if nothing is loaded, if supports do not hold every part, or if the model is too large for a look.
std::optional<StaticScale> find_static_scale(const Model& model, const AnalysisSettings& analysis);

// A sentence on strains or displacements that no rod has, as by a modulus in another unit than the lengths;
// "" if there is none.
std::string describe_static_scale(const Model& model, const AnalysisSettings& analysis);

}  // namespace gxrod
