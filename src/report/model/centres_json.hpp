#pragma once

#include <nlohmann/json_fwd.hpp>

#include "model/model.hpp"

// Shear centres, tension centres, centres of mass and principal axes of sections, for the page's drawings and
// tables. Only sections in which one is off the rod's line or turned are described.
namespace gxrod {

// Describes, for each rod, its index and stations along it, a single one for a constant section. A station
// has its arc length, the centres (y, z), `mass` null without inertia, and the angle about x of the axes of
// bending.
nlohmann::ordered_json describe_centres_along(const Model& model);

// Describes a table of them: sections, and the ends of rods whose section varies. No rows if there are none.
nlohmann::ordered_json describe_centre_table(const Model& model);

}  // namespace gxrod
