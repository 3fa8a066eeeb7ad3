#pragma once

#include "deck/rods/rod_table.hpp"
#include "deck/sections/rod_sections.hpp"
#include "geometry/centreline.hpp"

namespace gxrod {

// A weight that hangs at a point of a rod between its ends.
struct HungWeight {
    double fraction;                       // of the rod's length
    std::function<double(double)> weight;  // by the height there
};

// Lists the weights of bodies and of steady loads at points of a rod between its ends, in the order of the
// rod.
std::vector<HungWeight> list_hung_weights(int rod, const BuildContext& context);

// Says whether a catenary of one section hangs along gravity and stretches: with gravity along −z, a weight
// in water, and no rest shape of its own.
bool hangs_by_its_weight(const RodTable& table,
                         const std::vector<Station>& stations,
                         const BuildContext& context);

// Finds the centreline of a catenary as it hangs by the weights of its sections and those between its ends in
// still water, and stretches. Errors become faults.
std::optional<Centreline> find_sectioned_catenary(const RodTable& table,
                                                  const std::vector<Station>& stations,
                                                  const std::vector<HungWeight>& weights,
                                                  const BuildContext& context);

}  // namespace gxrod
