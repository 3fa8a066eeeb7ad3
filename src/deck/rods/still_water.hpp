#pragma once

#include <limits>
#include <optional>

#include "deck/rods/curve_table.hpp"

// Holds what acts on a line at rest before the model is built: gravity along −z, still water, level ground.
namespace gxrod {

struct StillWater {
    Vec3 gravity = Vec3::Zero();    // at full load
    double density = 0.0;           // 0 without water
    std::optional<double> surface;  // z; without one water is everywhere

    double weight_in_air(const Section& section) const { return -gravity.z() * section.mass(0, 0); }
    double weight_in_water(const Section& section) const {
        return -gravity.z() * (section.mass(0, 0) - (section.fluid ? density * section.fluid->area : 0.0));
    }
};

StillWater find_still_water(const BuildContext& context);

// Finds the height of a line with a section, if there is one, that lies on the ground: half a diameter above
// it, less what it sinks in; or that of an end a little lower, which can be held on the ground itself.
// Returns nullopt, with a fault, if there is no level ground and the table asks for it.
std::optional<double> find_line_bed(const CatenaryTable& catenary,
                                    const Section* section,
                                    const BuildContext& context);

}  // namespace gxrod
