#pragma once

#include <optional>
#include <string>

#include "model/model.hpp"
#include "model/settings/settings.hpp"

namespace gxrod {

// Angular frequencies at which the undeformed, unloaded model vibrates, in rad per time.
struct MeshFrequencies {
    double lowest = 0.0;  // rigid motions left out
    double highest = 0.0;
    int rigid_motions = 0;  // that nothing holds, of frequency 0
};

// By Lanczos' method, to some 1e-4. nullopt if a motion has no inertia, nothing can vibrate, or
// more than ten parts are free.
std::optional<MeshFrequencies> find_mesh_frequencies(const Model& model);

// The frequencies, what the damping of sections makes of them, and the longest stable step of explicit
// schemes, in lines for a reader; "" if there is nothing to say.
std::string describe_frequencies(const Model& model, const DynamicSettings& settings);

}  // namespace gxrod
