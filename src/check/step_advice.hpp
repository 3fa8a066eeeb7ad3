#pragma once

#include <string>

#include "check/mesh_frequencies.hpp"
#include "model/model.hpp"
#include "model/settings/settings.hpp"

// Whether scheme and steps of a motion suit its model, with advice.
namespace gxrod {

// Describes the steps in lines; `damping` is the largest damping ratio at the highest frequency. With contact
// no scheme of several stages is recommended.
std::string describe_steps(const MeshFrequencies& found,
                           double damping,
                           const DynamicSettings& settings,
                           bool has_contact = false);

// Says in a line where the model turns far within a step at t = 0; else "".
std::string describe_turning(const Model& model, const DynamicSettings& settings);

}  // namespace gxrod
