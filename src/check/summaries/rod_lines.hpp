#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

// Rods that are pieces of a longer one: a blade or a riser of many sections.
namespace gxrod {

// L √(EA/EI), with the smaller EI: of a solid section the length over the radius of gyration.
double compute_slenderness(const Section& section, double length);

// Of each rod the length of the line that it is in: rods whose ends share a node and continue into each other
// there, bent by less than 60 degrees. Of several that could follow, the straightest one does.
std::vector<double> measure_lines(const Model& model);

// A sentence on the rods whose lines are thicker than long, all of them together; "" if there is none. Not of
// stubs and stiff links: where a connected part has a slender line, too.
std::string describe_thick_rods(const Model& model);

// The same for rods that have an element that turns by more than 45 degrees.
std::string describe_coarse_rods(const Model& model);

}  // namespace gxrod
