#pragma once

#include <string>

#include "check/mesh_frequencies.hpp"
#include "model/model.hpp"
#include "model/settings/settings.hpp"

// Whether scheme and steps of a motion suit its model, and which do.
namespace gxrod {

// Lines for a reader; `damping` is the largest damping ratio at the highest frequency. With contact no scheme
// of several stages is recommended.
std::string describe_steps(const MeshFrequencies& found,
                           double damping,
                           const DynamicSettings& settings,
                           bool has_contact = false);

// Where the model turns far within a step at t = 0, a line; else "".
std::string describe_turning(const Model& model, const DynamicSettings& settings);

}  // namespace gxrod
