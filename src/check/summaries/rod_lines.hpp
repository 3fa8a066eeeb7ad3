#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

// Rods that are pieces of a longer line: a blade or a riser of many sections.
namespace gxrod {

// Computes L √(EA/EI), with the smaller EI: for a solid section the length over the radius of gyration.
double compute_slenderness(const Section& section, double length);

// Measures for each rod the length of its line: rods whose ends share a node and continue into each other
// there, bent by less than 60 degrees. If several rods could follow, the straightest one does.
std::vector<double> measure_lines(const Model& model);

// Describes the rods whose lines are thicker than long, all in one sentence; "" if there is none. Leaves out
// stubs and stiff links: rods of connected parts that have a slender line, too.
std::string describe_thick_rods(const Model& model);

// Describes the rods with an element that turns by more than 45 degrees, likewise.
std::string describe_coarse_rods(const Model& model);

}  // namespace gxrod
