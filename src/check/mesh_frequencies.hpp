#pragma once

#include <optional>
#include <string>

#include "model/model.hpp"
#include "model/settings/settings.hpp"

namespace gxrod {

// Angular frequencies of the undeformed, unloaded model, in rad per time.
struct MeshFrequencies {
    double lowest = 0.0;  // without rigid motions
    double highest = 0.0;
    int rigid_motions = 0;  // unsupported motions of frequency 0
};

// Finds frequencies by Lanczos' method, to some 1e-4. Returns nullopt if a motion has no inertia, nothing can
// vibrate, more than ten parts are free, or something starts inside of something else.
std::optional<MeshFrequencies> find_mesh_frequencies(const Model& model);

// Describes the frequencies, the damping of sections at them, and the longest stable step of explicit
// schemes, in lines; "" if there is nothing to report.
std::string describe_frequencies(const Model& model, const DynamicSettings& settings);

}  // namespace gxrod
