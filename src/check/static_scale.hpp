#pragma once

#include <optional>
#include <string>

#include "model/model.hpp"
#include "model/settings/settings.hpp"

namespace gxrod {

// The largest answers of the undeformed model to its gravity and loads, linear and static, at the time at
// which these are largest. Values far from usual ones indicate mixed units.
struct StaticScale {
    double time = 0.0;
    double displacement = 0.0;  // the largest, relative to the model's size
    int node = -1;              // node with the largest displacement
    double strain = 0.0;        // the largest: of the line, or of the section by bending and twist
    int rod = -1;               // rod with the largest strain
};

// Returns nullopt if nothing is loaded, if supports do not hold every part, or if the model is too large for
// a quick solution.
std::optional<StaticScale> find_static_scale(const Model& model, const AnalysisSettings& analysis);

// Describes strains or displacements that no rod has, as from a modulus in another unit than the lengths; ""
// if there are none.
std::string describe_static_scale(const Model& model, const AnalysisSettings& analysis);

}  // namespace gxrod
