#pragma once

#include <string>
#include <vector>

#include "deck/places/build_context.hpp"
#include "deck/rods/read_rod_nets.hpp"

namespace gxrod {

// A point that becomes one node with others.
struct JoinedPoint {
    std::string name;
    int node = 0;
    int rod = -1;
    bool is_hinged = false;  // an end with a hinge, whose node stays its own
};

JoinedPoint make_joined(std::string name, const PlacedPoint& point, const BuildContext& context);

// Finds the points of some rods that coincide: groups of two nodes or more that are nearer to the first of
// the group than the tolerance. At least one of a group is an end or a corner, a point that the deck names,
// or the end of a curve of a mesh's geometry; the others can be any nodes between elements.
std::vector<std::vector<JoinedPoint>> find_coincident_points(const std::vector<int>& rods,
                                                             double tolerance,
                                                             const RodNets& nets,
                                                             const BuildContext& context);

// Explains which end of these rods lies on another of them within an element, so that nothing connects them;
// "" if none does. `groups` are the points that coincide.
std::string explain_loose_end(const std::vector<int>& rods,
                              double tolerance,
                              const std::vector<std::vector<JoinedPoint>>& groups,
                              const BuildContext& context);

}  // namespace gxrod
