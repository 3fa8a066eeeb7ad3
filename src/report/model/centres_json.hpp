#pragma once

#include <nlohmann/json_fwd.hpp>

#include "model/model.hpp"

// Shear centres, tension centres, centres of mass and principal axes of sections, as the page draws them and
// as its tables have them. Only of sections where one is away from the line or turned.
namespace gxrod {

// By rod: its index and stations along it, one of a constant section. A station has its arc length, the
// centres (y, z), `mass` null without inertia, and by which angle about x the axes of bending are turned.
nlohmann::ordered_json describe_centres_along(const Model& model);

// A table of them: sections, and the ends of rods whose section varies. No rows without any.
nlohmann::ordered_json describe_centre_table(const Model& model);

}  // namespace gxrod
