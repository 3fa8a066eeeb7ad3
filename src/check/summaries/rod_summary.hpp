#pragma once

#include <string>

#include "model/model.hpp"

namespace gxrod {

// Describes the constants of a section, as a full matrix if they couple, and its damping, in lines.
std::string describe_section(const Section& section);

// Describes length, mass, mesh, axes and extent of a rod, with a warning if its elements are too long for its
// curve.
std::string describe_rod(const Model& model, const Rod& rod);

// Computes the largest angle by which the tangent turns within one element of a rod, from the tangents at its
// nodes.
double compute_largest_turn(const Rod& rod);

// Computes the angle by which the section axes turn about the tangent along the elements of a rod, relative
// to axes carried along without twisting; by double reflection (Wang, Jüttler, Zheng and Liu 2008) between
// nodes, with an error of fourth order in their distance.
double compute_twist(const Model& model, const Rod& rod);

}  // namespace gxrod
