#pragma once

#include <string>

#include "model/model.hpp"

namespace gxrod {

// Lines for a reader: constants of a section, as a full matrix where they couple, and its damping.
std::string describe_section(const Section& section);

// Length, mass, mesh, axes and extent of a rod; a warning where its elements are too long for its curve.
std::string describe_rod(const Model& model, const Rod& rod);

// The largest angle by which the tangent turns within one element of a rod, by the tangents at its nodes.
double compute_largest_turn(const Rod& rod);

// The angle by which the section axes turn about the tangent along the elements of a rod, beyond what carries
// them along without twisting; by double reflection (Wang, Jüttler, Zheng and Liu 2008) between nodes, with
// an error of fourth order in their distance.
double compute_twist(const Model& model, const Rod& rod);

}  // namespace gxrod
